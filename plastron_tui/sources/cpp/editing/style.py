"""How a C++ file is laid out: indents, braces, references, as its own lines show."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from plastron_tui.sources.splices import indent_of, line_start, newline_of

from ..scopes import CppFile, body_of
from .clang_format import ClangFormat

_TAB = 4
LONGEST = 100
"""The longest line of ROS 2's style; a file of longer lines is written with these."""

_NARROW = 80
_LONGEST_OF_ROS1 = 120
"""What the page "CppStyleGuide" of the wiki of ROS 1 allows."""

_CONTROL = re.compile(rb"^[ \t]*(?:\} )?(?:if|for|while|else|try)\b[^\n;]*?(\{)?[ \t]*\r?$", re.M)
_ENDS = ("", ";", "{", ");", "));", "const", "const {", "-> void {", "-> bool {", "-> void")
_ONE_LINE = re.compile(rb"\{( ?)[^{}\s][^{}\n]*;( ?)\}")
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
        continuation: what a line begins with that goes on with a call, behind the indent of its
            first.
        is_aligned: whether the lines of a call begin below its first argument.
        is_spaced: whether an empty line stands between functions.
        pad: what stands inside of the braces of a block in one line.
    """

    indent: str
    newline: str
    is_broken: bool
    is_control_broken: bool
    reference: str
    width: int
    continuation: str = "  "
    is_aligned: bool = False
    is_spaced: bool = True
    pad: str = ""

    def laid_out(self, lines: list[str], base: str) -> str:
        """Return lines as the file has them.

        Each level of theirs is a tab, or a vertical tab where a call goes on.

        Args:
            lines: the lines; a `{` that ends one opens a block.
            base: the blanks that each of them begins with.
        """
        found = []
        columns = len(base.expandtabs(_TAB))
        for line in (part for whole in lines for part in self._broken(whole, columns)):
            inner = line.lstrip("\t\v")
            blanks = line[: len(line) - len(inner)]
            steps = {"\t": self.indent, "\v": self.continuation}
            indent = "".join(steps[each] for each in blanks)
            found.append(f"{base}{indent}{inner}" if inner else "")
        return "".join(f"{line}{self.newline}" for line in found)

    def _broken(self, line: str, columns: int) -> list[str]:
        """Return a call or a head in several lines where it is too long for one."""
        inner = line.lstrip("\t\v")
        if inner.lstrip().startswith(("//", "/*", "*")):
            return [line]
        tabs = line[: len(line) - len(inner)]
        widths = {"\t": len(self.indent.expandtabs(_TAB))}
        widths["\v"] = len(self.continuation.expandtabs(_TAB))
        room = self.width - columns - sum(widths[each] for each in tabs)
        if len(inner) <= room:
            return [line]
        if inner.startswith(("if (", "while (")) and " && " in inner:
            return self._condition(tabs, inner, room)
        parts = _call_of(inner)
        if parts is None or len(parts[0]) > room:
            return self._calculation(tabs, inner, room)
        head, arguments, tail = parts
        longest = max(len(each) for each in arguments)
        if self.is_aligned and len(head) + longest + len(tail) <= room:
            first, *more = _filled(arguments, tail, room - len(head))
            pad = " " * len(head)
            return [f"{tabs}{head}{first}", *(f"{tabs}{pad}{each}" for each in more)]
        lines = _filled(arguments, tail, room - widths["\v"])
        below = [f"{tabs}\v{each}" for each in lines]
        if len(lines) == len(arguments) and len(lines[-1]) > room - widths["\v"]:
            # What does not fit alone is a call itself: `std::bind(…)`.
            below[-1:] = self._broken(below[-1], columns)
        return [f"{tabs}{head}", *below]

    def _condition(self, tabs: str, line: str, room: int) -> list[str]:
        """Return an `if` in several lines, each but the last of which ends in `&&`."""
        first, *more = _together(re.split(r"(?<= &&) ", line), room)
        # What is asked stands out against what is done.
        step = "\v" if len(self.continuation) > len(self.indent) else "\v\v"
        return [f"{tabs}{first}", *(f"{tabs}{step}{each}" for each in more)]

    def _calculation(self, tabs: str, line: str, room: int) -> list[str]:
        """Return what is calculated in several lines, each but the last ending in an operator."""
        target, sign, value = line.partition(" = ")
        if not sign or '"' in value:
            return [f"{tabs}{line}"]
        begin, *parts = re.split(r"(?<= [-+*/]) ", value)
        first, *more = _together([f"{target} = {begin}", *parts], room)
        return [f"{tabs}{first}", *(f"{tabs}\v{each}" for each in more)]

    def opened(self, head: str) -> list[str]:
        """Return the line, or two, that begins a function."""
        return [head, "{"] if self.is_broken else [f"{head} {{"]

    def block(self, head: str, lines: list[str]) -> list[str]:
        """Return an `if` or a loop around lines."""
        first = [head, "{"] if self.is_control_broken else [f"{head} {{"]
        return [*first, *(f"\t{each}" for each in lines), "}"]


def _together(parts: list[str], room: int) -> list[str]:
    """Return parts in lines, as many in each as it has room for."""
    lines = parts[:1]
    for each in parts[1:]:
        if len(lines[-1]) + 1 + len(each) <= room:
            lines[-1] += f" {each}"
        else:
            lines.append(each)
    return lines


def _filled(arguments: list[str], tail: str, room: int) -> list[str]:
    """Return arguments in lines, as many in each as it has room for."""
    lines: list[str] = []
    for at, each in enumerate(arguments, 1):
        written = each + (tail if at == len(arguments) else ",")
        if lines and len(lines[-1]) + 1 + len(written) <= room:
            lines[-1] += f" {written}"
        else:
            lines.append(written)
    return lines


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
            is_last = line[start] == "(" and rest in _ENDS
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


def style_of(
    file: CppFile, ros_version: int, said: ClangFormat, files: Iterable[CppFile] = ()
) -> Style:
    """Return the layout of a file: as its lines show it, and else as settings say.

    How long a line may be is what the settings say first, and else the files around it.
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
        outer = indent_of(text, scope.node.start_byte).decode()
        if scope.kind == "function":
            start = line_start(text, body.start_byte)
            broken[not text[start : body.start_byte].strip()] += 1
        for each in body.named_children[:3]:
            if each.type == "access_specifier":
                continue
            inner = indent_of(text, each.start_byte).decode()
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
    width = said.width or 0
    if not width and ros_version == 2:
        width = LONGEST
    elif not width:
        texts = [each.syntax.text for each in (file, *files)]
        longest = max(len(line.rstrip()) for each in texts for line in each.split(b"\n"))
        width = min(max(longest, LONGEST), _LONGEST_OF_ROS1) if longest > _NARROW else _NARROW
    newline = newline_of(text).decode()
    continuation, is_aligned = _continuation((file, *files), indent, said)
    return Style(
        indent,
        newline,
        is_broken,
        is_control_broken,
        reference,
        width,
        continuation,
        is_aligned,
        _is_spaced(file),
        _pad(text, ros_version),
    )


def _continuation(files: Iterable[CppFile], indent: str, said: ClangFormat) -> tuple[str, bool]:
    """Return how a call goes on in the lines of files: by which blanks, or below its first.

    The first file that shows it says so.
    """
    steps = next((found for each in files if (found := _continuations(each))), Counter())
    # One odd line, such as `   `, is no manner.
    known = [
        each
        for each, count in steps.most_common()
        if each is not None and (count > 1 or "\t" in each or len(each) % 2 == 0)
    ]
    is_aligned = steps[None] * 2 > sum(steps.values()) if steps else bool(said.is_aligned)
    usual = said.continuation or indent
    if said.continuation and "\t" in indent:
        usual = indent
    return known[0] if known else usual, is_aligned


def _continuations(file: CppFile) -> Counter[str | None]:
    """Count what lines that go on with a call begin with; None is below its first argument."""
    text = file.syntax.text
    steps: Counter[str | None] = Counter()
    for call in file.calls:
        listed = call.node.child_by_field_name("arguments")
        given = listed.named_children if listed is not None else []
        if listed is None or not given or given[-1].start_point.row == listed.start_point.row:
            continue
        first, last = given[0], given[-1]
        if first.start_point.row > listed.start_point.row:
            outer = indent_of(text, listed.start_byte).decode()
            inner = indent_of(text, first.start_byte).decode()
            if inner.startswith(outer) and inner != outer and first.type != "comment":
                steps[inner.removeprefix(outer)] += 1
        elif last.start_point.column == first.start_point.column:
            steps[None] += 1
    return steps


def _pad(text: bytes, ros_version: int) -> str:
    """Return the blank in `{ f(); }`, as a file has it; the style of ROS 2 has none."""
    found = Counter(each[1] for each in _ONE_LINE.finditer(text))
    return found.most_common(1)[0][0].decode() if found else "" if ros_version == 2 else " "


def _is_spaced(file: CppFile) -> bool:
    """Tell whether empty lines stand between the functions of a file."""
    text = file.syntax.text
    found: Counter[bool] = Counter()
    for scope in file.scopes:
        following = scope.node.next_named_sibling
        if scope.kind != "function" or following is None:
            continue
        rows = scope.node.end_point.row - scope.node.start_point.row
        rows += following.end_point.row - following.start_point.row
        if following.type == "function_definition" and rows:
            between = text[scope.node.end_byte : following.start_byte]
            found[between.count(b"\n") > 1] += 1
    return found[True] >= found[False]
