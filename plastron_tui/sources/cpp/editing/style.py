"""How a C++ file is laid out: indents, braces, references, as its own lines show."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from plastron_tui.sources.splices import line_start, newline_of

from ..scopes import CppFile, body_of
from .clang_format import ClangFormat

_TAB = 4
LONGEST = 100
"""The longest line of ROS 2's style; a file of longer lines is written with these."""

_CONTROL = re.compile(rb"^[ \t]*(?:\} )?(?:if|for|while|else|try)\b[^\n;]*?(\{)?[ \t]*\r?$", re.M)
_REFERENCE = re.compile(r"[\w>]( ?)&( ?)[a-z_]\w*")


@dataclass(frozen=True, slots=True)
class Style:
    """The layout of a file.

    Attributes:
        indent: one level of it.
        newline: how a line ends.
        is_broken: whether the brace of a function has a line of its own.
        is_control_broken: whether that of an `if` or a loop has.
        reference: how `const T & x` stands there: ` & `, `& ` or ` &`.
        width: the longest line.
    """

    indent: str
    newline: str
    is_broken: bool
    is_control_broken: bool
    reference: str
    width: int

    def laid_out(self, lines: list[str], base: str) -> str:
        """Return lines as the file has them; each level of theirs is a tab.

        Args:
            lines: the lines; a `{` that ends one opens a block.
            base: the blanks that each of them begins with.
        """
        found = []
        columns = len(base.expandtabs(_TAB))
        for line in (part for whole in lines for part in self._broken(whole, columns)):
            inner = line.lstrip("\t")
            depth = len(line) - len(inner)
            found.append(f"{base}{self.indent * depth}{inner}" if inner else "")
        return "".join(f"{line}{self.newline}" for line in found)

    def _broken(self, line: str, columns: int) -> list[str]:
        """Return a call or a head in several lines where it is too long for one."""
        inner = line.lstrip("\t")
        tabs = "\t" * (len(line) - len(inner))
        step = len(self.indent.expandtabs(_TAB))
        room = self.width - columns - step * len(tabs)
        parts = _call_of(inner) if len(inner) > room else None
        if parts is None:
            return [line]
        head, arguments, tail = parts
        joined = ", ".join(arguments)
        room -= step
        if len(joined) + len(tail) <= room:
            return [f"{tabs}{head}", f"{tabs}\t{joined}{tail}"]
        *first, last = arguments
        return [f"{tabs}{head}", *(f"{tabs}\t{each}," for each in first), f"{tabs}\t{last}{tail}"]

    def opened(self, head: str) -> list[str]:
        """Return the line, or two, that begins a function."""
        return [head, "{"] if self.is_broken else [f"{head} {{"]

    def block(self, head: str, lines: list[str]) -> list[str]:
        """Return an `if` or a loop around lines."""
        first = [head, "{"] if self.is_control_broken else [f"{head} {{"]
        return [*first, *(f"\t{each}" for each in lines), "}"]


def _call_of(line: str) -> tuple[str, list[str], str] | None:
    """Return what stands before the arguments of a line's outermost call, these, and the rest."""
    if '"' in line and line.count('"') % 2:
        return None
    starts: list[int] = []
    commas: dict[int, list[int]] = {}
    is_text = False
    for at, letter in enumerate(line):
        if letter == '"' and line[at - 1 : at] != "\\":
            is_text = not is_text
        if is_text:
            continue
        if letter in "([{":
            starts.append(at)
        elif letter in ")]}" and starts:
            start = starts.pop()
            rest = line[at + 1 :].strip()
            is_last = line[start] == "(" and rest in ("", ";", "{", ");", "));", "const", "const {")
            if is_last and not starts and start + 1 < at:
                ends = [*commas.get(start, []), at]
                begins = [start + 1, *(each + 1 for each in ends[:-1])]
                given = [line[a:b].strip() for a, b in zip(begins, ends, strict=True)]
                return line[: start + 1], given, line[at:]
        elif letter == "," and starts:
            if _is_in_template(line, starts[-1], at):
                continue
            commas.setdefault(starts[-1], []).append(at)
    return None


def _is_in_template(line: str, start: int, at: int) -> bool:
    part = line[start + 1 : at].replace("<<", "").replace("->", "")
    return part.count("<") > part.count(">")


def style_of(file: CppFile, ros_version: int, said: ClangFormat) -> Style:
    """Return the layout of a file: as its lines show it, and else as settings say.

    How long a line may be is what the settings say first.
    """
    text, syntax = file.syntax.text, file.syntax
    steps: Counter[str] = Counter()
    broken: Counter[bool] = Counter()
    for scope in file.scopes:
        if scope.kind not in ("function", "class"):
            continue
        body = body_of(scope.node)
        if body is None or body.start_point.row == body.end_point.row:
            continue
        outer = _blanks(text, scope.node.start_byte)
        if scope.kind == "function":
            start = line_start(text, body.start_byte)
            broken[not text[start : body.start_byte].strip()] += 1
        for each in body.named_children[:3]:
            if each.type == "access_specifier":
                continue
            inner = _blanks(text, each.start_byte)
            if inner.startswith(outer) and inner != outer:
                steps[inner.removeprefix(outer)] += 1
    indent = steps.most_common(1)[0][0] if steps else said.indent or "  "
    if "\t" not in indent and len(indent) > 8:
        indent = "  "
    control = Counter(found[1] is None for found in _CONTROL.finditer(syntax.code))
    usual = ros_version == 2 if said.is_broken is None else said.is_broken
    is_broken = broken[True] > broken[False] if broken else usual
    is_control_broken = control[True] > control[False]
    references = Counter(
        f"{found[1]}&{found[2]}" for found in _REFERENCE.finditer(text.decode("latin-1"))
    )
    known = [each for each, _ in references.most_common() if each.strip() != each]
    reference = known[0] if known else said.reference or (" & " if ros_version == 2 else "& ")
    longest = max((len(line.rstrip()) for line in text.split(b"\n")), default=0)
    width = said.width or 0
    if not width:
        width = LONGEST if ros_version == 2 else max(min(longest, 120), 80)
    newline = newline_of(text).decode()
    return Style(indent, newline, is_broken, is_control_broken, reference, width)


def _blanks(text: bytes, offset: int) -> str:
    start = line_start(text, offset)
    line = text[start:offset]
    return line[: len(line) - len(line.lstrip(b" \t"))].decode("ascii")
