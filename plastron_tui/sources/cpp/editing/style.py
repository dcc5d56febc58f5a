"""How a C++ file is laid out: indents, braces, references, as its own lines show."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from plastron_tui.sources.splices import line_start, newline_of

from ..scopes import CppFile

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
        for line in lines:
            inner = line.lstrip("\t")
            depth = len(line) - len(inner)
            found.append(f"{base}{self.indent * depth}{inner}" if inner else "")
        return "".join(f"{line}{self.newline}" for line in found)

    def opened(self, head: str) -> list[str]:
        """Return the line, or two, that begins a function."""
        return [head, "{"] if self.is_broken else [f"{head} {{"]

    def block(self, head: str, lines: list[str]) -> list[str]:
        """Return an `if` or a loop around lines."""
        first = [head, "{"] if self.is_control_broken else [f"{head} {{"]
        return [*first, *(f"\t{each}" for each in lines), "}"]


def style_of(file: CppFile, ros_version: int) -> Style:
    """Return the layout of a file."""
    text, syntax = file.syntax.text, file.syntax
    steps: Counter[str] = Counter()
    broken: Counter[bool] = Counter()
    for scope in file.scopes:
        if scope.kind not in ("function", "class"):
            continue
        body = scope.node.child_by_field_name("body")
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
    indent = steps.most_common(1)[0][0] if steps else "  "
    if "\t" not in indent and len(indent) > 8:
        indent = "  "
    control = Counter(found[1] is None for found in _CONTROL.finditer(syntax.code))
    is_broken = broken[True] > broken[False] if broken else ros_version == 2
    is_control_broken = control[True] > control[False]
    references = Counter(
        f"{found[1]}&{found[2]}" for found in _REFERENCE.finditer(text.decode("latin-1"))
    )
    known = [each for each, _ in references.most_common() if each.strip() != each]
    reference = known[0] if known else " & " if ros_version == 2 else "& "
    longest = max((len(line.rstrip()) for line in text.split(b"\n")), default=0)
    width = LONGEST if ros_version == 2 else max(min(longest, 120), 80)
    newline = newline_of(text).decode()
    return Style(indent, newline, is_broken, is_control_broken, reference, width)


def _blanks(text: bytes, offset: int) -> str:
    start = line_start(text, offset)
    line = text[start:offset]
    return line[: len(line) - len(line.lstrip(b" \t"))].decode("ascii")
