"""Read the text of a `.msg`, `.srv` or `.action` file, as ROS 1 and as ROS 2 write them.

Sources: the ROS 1 wiki pages "msg" and "srv", the ROS 2 documentation "Interfaces". The two
differ in the shorthand `Header` and the types `time` and `duration` (ROS 1), in bounded
sequences and strings, `wstring` and default values (ROS 2), in the letters of names, and in
string constants, which reach to the end of the line in ROS 1 and are quoted in ROS 2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes

from .definition_literals import is_separator, parse_array, parse_literal, split_comment
from .definition_members import (
    TYPE_PATTERN,
    MemberMistake,
    MemberPart,
    Value,
    field_type,
    make_member,
)
from .interfaces import Constant, Field, Interface, InterfaceKind, InterfaceName, Section

MAX_DEFINITION_BYTES = 1_000_000
"""A longer file is no definition, whatever its name ends in."""

MOST_MISTAKES = 20
"""The most lines of a definition that are reported one by one; the rest is counted."""

SECTION_COUNT = {InterfaceKind.MESSAGE: 1, InterfaceKind.SERVICE: 2, InterfaceKind.ACTION: 3}
"""How many sections each kind of interface has."""

_LINE = re.compile(
    TYPE_PATTERN + r"(?P<space>[ \t]+)(?P<name>[A-Za-z0-9_]+)[ \t]*(?P<rest>.*)",
    re.ASCII | re.DOTALL,
)
_LONGEST_COMMENT = 160
_SENTENCE_END = re.compile(r"(?<!e\.g)(?<!i\.e)\.(?=\s)")


class Definition(NamedTuple):
    """What a definition says; `interface` is None when a diagnostic is an error."""

    interface: Interface | None
    diagnostics: tuple[Diagnostic, ...] = ()


def parse_definition(
    source: str | bytes,
    name: InterfaceName,
    kind: InterfaceKind,
    ros_version: int,
    file: Path | None = None,
    *,
    is_new: bool = False,
) -> Definition:
    """Read a definition; a line that is wrong is a diagnostic with its place in `file`.

    One that a program makes (`is_new`) has no word of a language that is generated for a name.
    """
    size = len(source)
    if size > MAX_DEFINITION_BYTES:
        message = f"a definition of {size} bytes is too long (up to {MAX_DEFINITION_BYTES})"
        return Definition(None, (Diagnostic(codes.BAD_DEFINITION, message, file=file),))
    text = source if isinstance(source, str) else source.decode("utf-8", "surrogateescape")
    reader = _Reader(name, kind, ros_version, file, is_new=is_new)
    reader.read(text.removeprefix("\ufeff"), 3 if text.startswith("\ufeff") else 0)
    if reader.diagnostics:
        return Definition(None, tuple(reader.diagnostics))
    sections = tuple(Section(tuple(part.fields), tuple(part.constants)) for part in reader.sections)
    return Definition(Interface(name, kind, sections, reader.comment))


def member_spans(text: str, ros_version: int) -> dict[tuple[int, str], Span]:
    """Return where the members of a definition stand, by the numbers of their sections and names.

    A span has the type and the name, in bytes.
    """
    found: dict[tuple[int, str], Span] = {}
    section = start = 0
    for line in text.split("\n"):
        match = _LINE.match(line, len(line) - len(line.lstrip(" \t\ufeff")))
        if match is not None:
            first, last = (
                start + len(line[:at].encode("utf-8", "surrogateescape"))
                for at in (match.start(), match.end("name"))
            )
            found.setdefault((section, match["name"]), Span(first, last))
        elif is_separator(line.rstrip(" \t\r"), ros_version):
            section += 1
        start += len(line.encode("utf-8", "surrogateescape")) + 1
    return found


@dataclass(slots=True)
class _Part:
    """A section as it grows."""

    fields: list[Field] = field(default_factory=list)
    constants: list[Constant] = field(default_factory=list)
    names: set[str] = field(default_factory=set)


class _Mistake(Exception):  # noqa: N818 - it never leaves this module
    """A line that is wrong, from character `start` to `end` of it."""

    def __init__(self, message: str, start: int, end: int, remedy: str | None = None) -> None:
        super().__init__(message)
        self.message, self.start, self.end, self.remedy = message, start, end, remedy


class _Reader:
    """One pass over a definition, line by line."""

    def __init__(
        self,
        name: InterfaceName,
        kind: InterfaceKind,
        ros_version: int,
        file: Path | None,
        *,
        is_new: bool,
    ) -> None:
        self.is_new = is_new
        self.name = name
        self.kind = kind
        self.ros_version = ros_version
        self.file = file
        self.sections = [_Part()]
        self.diagnostics: list[Diagnostic] = []
        self.comment = ""
        self._block: list[str] = []
        self._is_leading = True
        self._mistakes = 0

    def read(self, text: str, start: int) -> None:
        """Read the text, whose first byte is the byte `start` of the file."""
        for raw in text.split("\n"):
            try:
                self._read_line(raw.rstrip(" \t\r"))
            except _Mistake as mistake:
                self._report(mistake, raw, start)
            start += len(raw.encode("utf-8", "surrogateescape")) + 1
        self._end_leading_block()
        if self._mistakes > MOST_MISTAKES:
            message = f"… and {self._mistakes - MOST_MISTAKES} more lines are wrong"
            self.diagnostics.append(Diagnostic(codes.BAD_DEFINITION, message, file=self.file))
        wanted = SECTION_COUNT[self.kind]
        if len(self.sections) != wanted and not self.diagnostics:
            message = (
                f"a `.{self.kind.value}` definition has {wanted - 1} `---` "
                f"line{'' if wanted == 2 else 's'}, and this one {len(self.sections) - 1}"
            )
            self.diagnostics.append(Diagnostic(codes.BAD_DEFINITION, message, file=self.file))

    def _report(self, mistake: _Mistake, raw: str, start: int) -> None:
        self._mistakes += 1
        if self._mistakes > MOST_MISTAKES:
            return

        def offset(column: int) -> int:
            return start + len(raw[:column].encode("utf-8", "surrogateescape"))

        span = Span(offset(mistake.start), offset(mistake.end))
        self.diagnostics.append(
            Diagnostic(codes.BAD_DEFINITION, mistake.message, span, self.file, mistake.remedy)
        )

    def _end_leading_block(self) -> None:
        if self._is_leading:
            self.comment = first_sentence(self._block)
            self._is_leading = False
            self._block = []

    def _read_line(self, line: str) -> None:
        stripped = line.lstrip(" \t")
        if stripped.startswith("#"):
            self._block.append(stripped.lstrip("#").strip())
            return
        if not stripped:
            # A file may start with empty lines, and its description follows them.
            if self._block:
                self._end_leading_block()
            self._block = []
            return
        self._end_leading_block()
        if is_separator(line, self.ros_version):
            self.sections.append(_Part())
        else:
            self._read_member(line, len(line) - len(stripped))
        self._block = []

    def _read_member(self, line: str, indent: int) -> None:
        match = _LINE.match(line, indent)
        if match is None:
            raise _Mistake(
                "this line is neither a field, a constant, nor a comment",
                indent,
                len(split_comment(line, self.ros_version)[0].rstrip()) or len(line),
                "write `type name`, such as `float64 x`",
            )
        self._check_layout(match, indent)
        is_constant = match["rest"].startswith("=")
        part = self.sections[-1]
        if match["name"] in part.names:
            raise _Mistake(f"`{match['name']}` is there twice", *match.span("name"))
        part.names.add(match["name"])
        made, comment = self._make_member(match, is_constant)
        if isinstance(made, Constant):
            part.constants.append(made)
        else:
            comment = first_sentence([comment] if comment else self._block)
            part.fields.append(made._replace(comment=comment))

    def _check_layout(self, match: re.Match[str], indent: int) -> None:
        """Refuse the white space that the builders do not take for what it looks like."""
        if self.ros_version == 2 and indent:
            message = "a field or constant of ROS 2 starts in the first column"
            raise _Mistake(message, 0, indent, "remove the space before it")
        if self.ros_version == 1 and " " not in match["space"]:
            message = "ROS 1 wants a space between type and name, not a tab"
            raise _Mistake(message, *match.span("space"), "write a space")

    def _make_member(self, match: re.Match[str], is_constant: bool) -> tuple[Field | Constant, str]:
        """Return the member of a line, and the comment behind it."""
        type_text = match.string[match.start("type") : match.start("space")]
        type_name = match["type"] if is_constant else ""
        text, comment = split_comment(match["rest"], self.ros_version, type_name)
        start, end = match.start("rest"), match.start("rest") + len(text)
        if is_constant:
            text, start = text[1:], start + 1
        if text.strip():
            start += len(text) - len(text.lstrip())
            text = text.strip()
            end = start + len(text)
        else:
            text = ""
        if self.ros_version == 2:
            # As `rosidl_adapter` does before it looks for quotes.
            text = text.replace("\t", " ")
        wrong: ValueError | None = None
        value: Value | None = None
        if text or is_constant:
            parsed = self._value(type_text, text, is_constant)
            wrong, value = (parsed, None) if isinstance(parsed, ValueError) else (None, parsed)
        checked = value if wrong is None else 0  # what it is instead is told below
        made = make_member(
            type_text,
            match["name"],
            checked,
            is_constant,
            self.ros_version,
            self.name.package,
            is_new=self.is_new,
        )
        if isinstance(made, list):
            spans = {
                MemberPart.TYPE: match.span("type"),
                MemberPart.BOUND: match.span("bound"),
                MemberPart.ARRAY: match.span("array"),
                MemberPart.NAME: match.span("name"),
                MemberPart.VALUE: (start, end),
            }
            first = made[0]
            if wrong is None or first.part is not MemberPart.VALUE:
                raise _Mistake(first.message, *spans[first.part], first.help)
        if wrong is not None:
            raise _Mistake(str(wrong), start, end)
        assert not isinstance(made, list)
        return made, comment

    def _value(self, type_text: str, text: str, is_constant: bool) -> Value | ValueError:
        """Return the value of a literal; what is no value for want of a type is 0."""
        read = field_type(type_text, self.ros_version, self.name.package)
        if isinstance(read, MemberMistake) or read.package is not None:
            return 0
        if self.ros_version == 1 and not is_constant:
            return 0
        parse = parse_array if read.is_array else parse_literal
        return parse(read.name, text, self.ros_version)


def first_sentence(lines: list[str]) -> str:
    """Return the first sentence of a comment, as one line of at most 160 characters."""
    joined = " ".join(_first_lines(lines))
    end = _SENTENCE_END.search(joined)
    sentence = joined[: end.start()] if end else joined.removesuffix(".").removesuffix(":")
    if len(sentence) > _LONGEST_COMMENT:
        sentence = sentence[: _LONGEST_COMMENT - 1].rsplit(" ", 1)[0] + "…"
    return sentence


def _first_lines(lines: list[str]) -> Iterator[str]:
    """Yield the first line that says something, and the lines that go on with it.

    A line that starts with a capital letter is a remark of its own more often than not.
    """
    has_text = False
    for line in lines:
        text = "".join(c if c.isprintable() else " " if c == "\t" else "" for c in line)
        text = " ".join(text.split())
        is_ornament = text.startswith("==") or not text.strip("-*#/ ")
        if has_text and (is_ornament or text[0].isupper()):
            return
        if not is_ornament:
            has_text = True
            yield text
