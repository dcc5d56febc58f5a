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

from plastron_tui.diagnostics import Diagnostic, Span, codes, did_you_mean

from .definition_literals import parse_array, parse_literal, split_comment
from .interfaces import (
    Constant,
    Field,
    FieldType,
    Interface,
    InterfaceKind,
    InterfaceName,
    Scalar,
    Section,
)
from .primitives import PRIMITIVES, primitive

MAX_DEFINITION_BYTES = 1_000_000
"""A longer file is no definition, whatever its name ends in."""

MOST_MISTAKES = 20
"""The most lines of a definition that are reported one by one; the rest is counted."""

SECTION_COUNT = {InterfaceKind.MESSAGE: 1, InterfaceKind.SERVICE: 2, InterfaceKind.ACTION: 3}
"""How many sections each kind of interface has."""

_LINE = re.compile(
    r"(?P<type>[A-Za-z][A-Za-z0-9_/]*)(?:<=(?P<chars>[0-9]{1,9}))?"
    r"(?P<array>\[(?P<bounded><=)?(?P<size>[0-9]{0,9})\])?"
    r"[ \t]+(?P<name>[A-Za-z0-9_]+)[ \t]*(?P<rest>.*)",
    re.ASCII | re.DOTALL,
)
_FIELD_NAME = {
    1: re.compile(r"[A-Za-z][A-Za-z0-9_]*"),
    2: re.compile(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*"),
}
_CONSTANT_NAME = {1: _FIELD_NAME[1], 2: re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*")}
_NAME_RULE = {
    1: "letters, digits and `_`, a letter first",
    2: "lower-case letters, digits and single `_`, a letter first",
}
_MESSAGE_NAME = {
    1: re.compile(r"[A-Za-z][A-Za-z0-9_]*"),
    2: re.compile(r"[A-Z][A-Za-z0-9]*"),
}
_PACKAGE_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
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
) -> Definition:
    """Read a definition; a line that is wrong is a diagnostic with its place in `file`."""
    size = len(source)
    if size > MAX_DEFINITION_BYTES:
        message = f"a definition of {size} bytes is too long (up to {MAX_DEFINITION_BYTES})"
        return Definition(None, (Diagnostic(codes.BAD_DEFINITION, message, file=file),))
    text = source if isinstance(source, str) else source.decode("utf-8", "surrogateescape")
    reader = _Reader(name, kind, ros_version, file)
    reader.read(text.removeprefix("\ufeff"), 3 if text.startswith("\ufeff") else 0)
    if reader.diagnostics:
        return Definition(None, tuple(reader.diagnostics))
    sections = tuple(Section(tuple(part.fields), tuple(part.constants)) for part in reader.sections)
    return Definition(Interface(name, kind, sections, reader.comment))


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
        self, name: InterfaceName, kind: InterfaceKind, ros_version: int, file: Path | None
    ) -> None:
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
        if stripped.startswith("---"):
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
        is_constant = match["rest"].startswith("=")
        self._check_member_name(match, is_constant)
        part = self.sections[-1]
        if is_constant:
            part.constants.append(self._constant(match))
        else:
            part.fields.append(self._field(match))
        part.names.add(match["name"])

    def _check_member_name(self, match: re.Match[str], is_constant: bool) -> None:
        name = match["name"]
        rules = _CONSTANT_NAME if is_constant else _FIELD_NAME
        what = "constant" if is_constant else "field"
        if rules[self.ros_version].fullmatch(name) is None:
            rule = _NAME_RULE[self.ros_version]
            if is_constant and self.ros_version == 2:
                rule = rule.replace("lower", "upper")
            raise _Mistake(f"`{name}` cannot name a {what}", *match.span("name"), f"use {rule}")
        if name in self.sections[-1].names:
            raise _Mistake(f"`{name}` is there twice", *match.span("name"))

    def _constant(self, match: re.Match[str]) -> Constant:
        type_name = match["type"]
        known = primitive(type_name, self.ros_version)
        if known is None or known.parts or match["array"] or match["chars"]:
            end = match.end("name") - len(match["name"])
            raise _Mistake("a constant is of a primitive type", match.start("type"), end)
        text, _ = split_comment(match["rest"], self.ros_version, type_name)
        value = parse_literal(type_name, text[1:].strip(), self.ros_version)
        if isinstance(value, Exception):
            raise _Mistake(str(value), match.start("rest") + 1, match.start("rest") + len(text))
        return Constant(match["name"], type_name, value)

    def _field(self, match: re.Match[str]) -> Field:
        field_type = self._type(match)
        text, comment = split_comment(match["rest"], self.ros_version)
        default: Scalar | tuple[Scalar, ...] | None = None
        if text.strip():
            default = self._default(match, field_type, text.strip())
        comment = first_sentence([comment] if comment else self._block)
        return Field(match["name"], field_type, default, comment)

    def _default(
        self, match: re.Match[str], field_type: FieldType, text: str
    ) -> Scalar | tuple[Scalar, ...]:
        start = match.start("rest")
        end = start + len(text)
        if self.ros_version == 1:
            raise _Mistake("a field of ROS 1 has no default value", start, end)
        if field_type.package is not None:
            raise _Mistake("only a field of a primitive type has a default value", start, end)
        parse = parse_array if field_type.is_array else parse_literal
        value = parse(field_type.name, text, 2)
        if isinstance(value, Exception):
            raise _Mistake(str(value), start, end)
        if isinstance(value, tuple):
            most = field_type.bound if field_type.length is None else field_type.length
            is_short = field_type.length is not None and len(value) < field_type.length
            if is_short or (most is not None and len(value) > most):
                message = f"{len(value)} elements do not fit `{field_type}`"
                raise _Mistake(message, start, end)
        return value

    def _type(self, match: re.Match[str]) -> FieldType:
        size = int(match["size"]) if match["size"] else None
        if match["bounded"] and size is None:
            raise _Mistake("the bound of this sequence is missing", *match.span("array"))
        chars = int(match["chars"]) if match["chars"] else None
        if self.ros_version == 1 and (match["bounded"] or chars is not None):
            end = match.end("array") if match["array"] else match.end("chars")
            raise _Mistake("ROS 1 has no bounded types", match.start("type"), end)
        name, package = self._base(match)
        if chars is not None and name not in ("string", "wstring"):
            span = (match.start("type"), match.end("chars"))
            raise _Mistake("only a string has a bound of characters", *span)
        return FieldType(
            name,
            package,
            is_array=match["array"] is not None,
            length=None if match["bounded"] else size,
            bound=size if match["bounded"] else None,
            string_bound=chars,
        )

    def _base(self, match: re.Match[str]) -> tuple[str, str | None]:
        """Return the name and package of the type, without what makes it an array."""
        written = match["type"]
        if primitive(written, self.ros_version) is not None:
            return written, None
        if written == "Header" and self.ros_version == 1:
            return "Header", "std_msgs"
        *packages, name = written.split("/")
        if len(packages) == 2 and packages[1] == "msg":
            packages.pop()
        package = packages[0] if packages else self.name.package
        is_message = (
            len(packages) < 2
            and _MESSAGE_NAME[self.ros_version].fullmatch(name)
            and _PACKAGE_NAME.fullmatch(package)
            and name not in ("time", "duration", "wstring")
        )
        if not is_message:
            raise _Mistake(
                f"`{written}` is no type of ROS {self.ros_version}",
                *match.span("type"),
                _type_help(written, self.ros_version),
            )
        return name, package


def _type_help(written: str, ros_version: int) -> str | None:
    if ros_version == 2 and written in ("time", "duration"):
        return f"write `builtin_interfaces/{written.capitalize()}`"
    if written == "wstring":
        return "write `string`"
    return did_you_mean(written, PRIMITIVES[ros_version])


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
