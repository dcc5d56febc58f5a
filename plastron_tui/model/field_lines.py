"""The line of a definition that `has_field` has in quotes, and where its parts stand."""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes, write
from plastron_tui.language import statements as st
from plastron_tui.language.text_places import span_in_text
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_literals import split_comment
from plastron_tui.ros.definition_members import Value
from plastron_tui.ros.interfaces import Constant, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import NO_TEXT, has_surrogate

from .run import Run
from .type_members import (
    TYPE_FIRST,
    Naming,
    base_of,
    changed_by_builders,
    is_field_name,
    members_of,
    type_before,
    with_default,
)
from .types import TypeProblem


class _Written(NamedTuple):
    """A line as the statement has it: what is written for its type, and what follows.

    Attributes:
        statement: the statement.
        type: the type.
        rest: the name, and what stands behind it.
        start: where the type starts in the text.
        next: where `rest` does.
    """

    statement: st.HasField
    type: str
    rest: str
    start: int
    next: int

    @property
    def default(self) -> str | None:
        """A field with a default value, where a constant is written whose name is a field's."""
        name, equals, value = (part.strip() for part in self.rest.partition("="))
        is_constant = equals and "#" not in value
        return f"{self.type} {name} {value}" if is_constant and is_field_name(name) else None

    def span(self, start: int, end: int) -> Span:
        """Return where characters of the text stand in the program."""
        return span_in_text(self.statement, "definition", start, end)

    def span_of(self, found: Diagnostic, full: str) -> Span:
        """Return where a mistake stands that was found in the line.

        Args:
            found: the mistake.
            full: the type as the line has it: with its package, where the text may have none.
        """
        if found.span is None:
            return self.statement.span_of("definition")
        line = f"{full} {self.rest}".encode()
        start, end = (
            self._offset(len(line[:at].decode(errors="ignore")), full)
            for at in (found.span.start, found.span.end)
        )
        return self.span(start, end)

    def _offset(self, at: int, full: str) -> int:
        if at > len(full):
            return self.next + at - len(full) - 1
        # Only what stands before the type's own name differs.
        return self.start + max(0, len(self.type) - (len(full) - at))


def written_type(statement: st.HasField) -> Span:
    """Return where the type of a field stands in a statement that has one in quotes."""
    text = statement.definition
    start = len(text) - len(text.lstrip())
    return span_in_text(statement, "definition", start, start + len(text.split(maxsplit=1)[0]))


def field_line(
    run: Run, statement: st.HasField, name: InterfaceName, version: int
) -> str | list[Diagnostic]:
    """Return the line of a definition that a statement has in quotes, its type in full.

    Args:
        run: the program so far.
        statement: the statement.
        name: the type that gets the field.
        version: the generation of ROS.
    """
    where = statement.span_of("definition")
    text = statement.definition
    words = text.split(maxsplit=1)
    if len(words) < 2 or "\n" in text.strip():
        message = "this is neither a field nor a constant"
        return [Diagnostic(codes.BAD_FIELD, message, where, help='write "float64 x", say')]
    if has_surrogate(text):
        return [Diagnostic(codes.BAD_FIELD, NO_TEXT, where)]
    type_, rest = words[0], words[1].rstrip()
    start = text.index(type_)
    written = _Written(statement, type_, rest, start, text.index(rest, start + len(type_)))
    types = run.types
    explain = partial(types.explain, statement)
    naming = Naming(
        version, name.package, types.resolver(version), name.name, types.is_broken, explain
    )
    full = naming.full(type_)
    if not isinstance(full, str):
        return [_unknown(written, naming, full)]
    line = f"{full} {rest}"
    read = parse_definition(line, name, InterfaceKind.MESSAGE, version, is_new=True)
    if read.interface is None:
        return [
            Diagnostic(
                codes.BAD_FIELD,
                each.message,
                written.span_of(each, full),
                help=with_default(each.help, written.default),
            )
            for each in read.diagnostics
        ]
    [member] = members_of(read.interface.sections[0]).values()
    value = member.value if isinstance(member, Constant) else member.default
    unsure = None if version == 1 else _unsure(written, member.name, value)
    return line if unsure is None else [unsure]


def _unknown(written: _Written, naming: Naming, problem: TypeProblem) -> Diagnostic:
    """Tell of a type that is not known."""
    first, name = written.type.removesuffix(":"), written.rest.split(maxsplit=1)[0]
    where = written_type(written.statement)
    is_unknown = problem.code == codes.UNKNOWN_TYPE
    type_ = type_before(first, name, naming) if is_unknown else None
    if type_ is not None:
        span = written.span(written.start, written.next + len(name))
        right = write(f"{type_} {first}", span)
        return Diagnostic(codes.BAD_FIELD, TYPE_FIRST, span, help=right.title, fix=right)
    base = written.span(written.start, written.start + len(base_of(written.type)))
    fix = None if problem.right is None else write(problem.right, base)
    return Diagnostic(
        problem.code, problem.message, where, help=problem.help, fix=fix, labels=problem.labels
    )


def _unsure(written: _Written, name: str, value: Value | None) -> Diagnostic | None:
    """Tell why the builders of ROS 2 would not keep a value as it is written."""
    behind = written.rest[len(name) :]
    code, _ = split_comment(behind, 2)
    bare = code.strip(" \t").removeprefix("=").strip(" \t")
    start = written.next + len(name) + (behind.index(bare) if bare else 0)
    tab = bare.find("\t")
    if tab >= 0:
        return Diagnostic(
            codes.BAD_FIELD,
            "ROS 2 takes a tab in a definition for a space",
            written.span(start + tab, start + tab + 1),
            help="write `\\\\t` for one in a text",
        )
    message = changed_by_builders(value)
    if message is None:
        return None
    return Diagnostic(codes.BAD_FIELD, message, written.span(start, start + len(bare)))
