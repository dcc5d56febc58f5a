"""The statements that make interface types, change them, and write them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from plastron_tui.diagnostics import (
    Diagnostic,
    Edit,
    Fix,
    Label,
    Severity,
    Span,
    codes,
    guess,
    write,
)
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.definitions import FieldText
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_changes import find_circle
from plastron_tui.ros.definition_edits import add_member, remove_member, replace_member
from plastron_tui.ros.definition_members import check_type_name, check_type_package
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName, Section

from .mistake import Mistake
from .own_types import SECTIONS, Definition, DefinitionSource, OwnType, interfaces_of
from .run import Run
from .type_members import Naming, members_of, nested_names, section_of

_PARTS: dict[type[Statement], tuple[InterfaceKind, tuple[str, ...]]] = {
    st.CreateMessageType: (InterfaceKind.MESSAGE, ("fields",)),
    st.CreateServiceType: (InterfaceKind.SERVICE, ("request", "response")),
    st.CreateActionType: (InterfaceKind.ACTION, ("goal", "result", "feedback")),
}
"""The kind of interface that a statement makes, and the slots that have its fields."""

_Make = Callable[[int], "Definition | list[Diagnostic]"]
"""Makes what a type is in a generation of ROS, or says what is wrong there."""


def create_type(run: Run, statement: Any) -> None:
    """Make a type of messages, services or actions."""
    kind, slots = _PARTS[type(statement)]
    package, name = _split(statement)
    _check_name(run, statement, package, name)
    sections = [(slot, getattr(statement, slot)) for slot in slots]

    def make(version: int) -> Definition | list[Diagnostic]:
        owner = package or run.types.own_package(version)
        return _made(run, statement, InterfaceName(owner, name), kind, sections, version)

    own = OwnType(name, package, kind, statement.span)
    _settle(run, statement, own, make)


def _split(statement: Any) -> tuple[str, str]:
    """Return the package, "" where none is written, and the name of a type."""
    *packages, name = statement.type.split("/")
    if len(packages) > 1:
        where = statement.span_of("type")
        right = f"{packages[0]}/{name}"
        raise Mistake(
            Diagnostic(
                codes.BAD_TYPE_NAME,
                "a type is made by its package and its name alone",
                where,
                help=f"write `{right}`",
                fix=write(right, where),
            )
        )
    return "".join(packages), name


def _check_name(run: Run, statement: Any, package: str, name: str) -> None:
    """Check that a type may have its name, and that there is none such."""
    where = statement.span_of("type")
    version = run.checks.version(None)
    earlier = run.workspace.types.get(name)
    if earlier is not None:
        raise Mistake(
            Diagnostic(
                codes.TYPE_EXISTS,
                f"a type `{name}` exists already",
                where,
                help=f'change it with `{name} has_field "…"`, or choose another name',
                labels=(Label(earlier.span, "first here"),),
            )
        )
    run.checks.new_name(statement, "type", name)
    problem = check_type_package(package, version) if package else None
    problem = problem or check_type_name(name, version)
    if problem is not None:
        right = "".join(part[:1].upper() + part[1:] for part in name.split("_"))
        is_better = check_type_name(right, version) is None and not package
        raise Mistake(
            Diagnostic(
                codes.BAD_TYPE_NAME,
                problem,
                where,
                help=f"write `{right}`" if is_better else None,
                fix=write(right, where) if is_better else None,
            )
        )
    owner = package or run.types.own_package(version)
    if run.types.is_of_ros(owner, version):
        message = f"`{owner}` is a package of ROS, which gets no types of yours"
        raise Mistake(Diagnostic(codes.TYPE_EXISTS, message, where, help="leave the package out"))


def _made(
    run: Run,
    statement: Any,
    name: InterfaceName,
    kind: InterfaceKind,
    parts: Sequence[tuple[str, Sequence[FieldText]]],
    version: int,
) -> Definition | list[Diagnostic]:
    own = name.name if kind is InterfaceKind.MESSAGE else ""
    naming = Naming(version, name.package, run.types.resolver(version), own)
    sections: list[Section] = []
    wrong: list[Diagnostic] = []
    for _, fields in parts:
        found = section_of(statement, fields, naming)
        if isinstance(found, Section):
            sections.append(found)
        else:
            wrong += found
    if wrong:
        return wrong
    interface = Interface(name, kind, tuple(sections))
    # A definition names the types of its own package without the package.
    prefix = f"{name.package}/"
    lines = format_definition(interface, version).split("\n")
    text = "\n".join(each.removeprefix(prefix) for each in lines)
    return Definition(b"" if text == "\n" else text.encode(), interface)


def load_type(run: Run, statement: st.LoadType) -> None:
    """Read a definition, to change it."""
    run.checks.new_variable(statement, statement.variable)
    loaded = run.setting.read_definition(statement.source)
    if loaded.definition is None:
        where = statement.span_of("source")
        raise Mistake(*(each._replace(span=where) for each in loaded.diagnostics))
    path, text, package, kind = loaded.definition
    name = InterfaceName(package, path.stem)

    def make(version: int) -> Definition | list[Diagnostic]:
        read = parse_definition(text, name, kind, version, path)
        errors = [each for each in read.diagnostics if each.severity is Severity.ERROR]
        if read.interface is None:
            return errors
        return Definition(text, read.interface)

    source = DefinitionSource(path, text)
    own = OwnType(path.stem, package, kind, statement.span, source=source)
    _settle(run, statement, own, make, variable=statement.variable)


def has_field(run: Run, statement: st.HasField) -> None:
    """Give a type a field, or a field another type."""
    own = _own_type(run, statement)
    section = _section(statement, own)
    where = statement.span_of("definition")

    def make(version: int) -> Definition | list[Diagnostic]:
        name = InterfaceName(own.package or run.types.own_package(version), own.name)
        line = _line(run, statement, name, version)
        if isinstance(line, list):
            return line
        before = own.definitions[version]
        member = parse_definition(line, name, InterfaceKind.MESSAGE, version).interface
        assert member is not None  # it was read before
        [(added, new)] = members_of(member.sections[0]).items()
        old = members_of(before.interface.sections[section]).get(added)
        if old == new:
            message = f"`{own.name}` has `{line}` already"
            fix = Fix("take the statement away", (Edit(statement.span, ""),))
            return [Diagnostic(codes.FIELD_EXISTS, message, where, fix=fix)]
        if old is None:
            text = add_member(before.text, line, section)
        else:
            text = replace_member(before.text, added, line, section)
        return _read_again(text, name, own.kind, version, where)

    _settle(run, statement, own, make, variable=statement.type)


def _line(
    run: Run, statement: st.HasField, name: InterfaceName, version: int
) -> str | list[Diagnostic]:
    """Return the line of a definition that a statement has in quotes, its type in full."""
    where = statement.span_of("definition")
    written = statement.definition.strip()
    words = written.split(maxsplit=1)
    if len(words) < 2 or "\n" in written:
        message = "this is neither a field nor a constant"
        return [Diagnostic(codes.BAD_FIELD, message, where, help='write "float64 x", say')]
    naming = Naming(version, name.package, run.types.resolver(version), name.name)
    full = naming.full(words[0])
    if not isinstance(full, str):
        start = where.start + 1 + statement.definition.index(words[0])
        span = Span(start, start + len(words[0].encode()))
        return [Diagnostic(full.code, full.message, span, help=full.help)]
    line = f"{full} {words[1]}"
    read = parse_definition(line, name, InterfaceKind.MESSAGE, version)
    if read.interface is None:
        return [_in_string(each, where) for each in read.diagnostics]
    return line


def _in_string(found: Diagnostic, where: Span) -> Diagnostic:
    return Diagnostic(codes.BAD_FIELD, found.message, where, help=found.help)


def no_longer_has_field(run: Run, statement: st.NoLongerHasField) -> None:
    """Take a field away from a type."""
    own = _own_type(run, statement)
    section = _section(statement, own)
    where = statement.span_of("field")

    def make(version: int) -> Definition | list[Diagnostic]:
        before = own.definitions[version]
        names = members_of(before.interface.sections[section])
        if statement.field not in names:
            part = SECTIONS[own.kind][section]
            of = f"`{own.name}`" if not part else f"the {part} of `{own.name}`"
            remedy, fix = guess(statement.field, names, where, is_quoted=True)
            message = f"{of} has no field `{statement.field}`"
            return [Diagnostic(codes.NO_SUCH_FIELD, message, where, help=remedy, fix=fix)]
        text = remove_member(before.text, statement.field, section)
        return _read_again(text, before.interface.name, own.kind, version, where)

    _settle(run, statement, own, make, variable=statement.type)


def _read_again(
    text: bytes, name: InterfaceName, kind: InterfaceKind, version: int, where: Span
) -> Definition | list[Diagnostic]:
    read = parse_definition(text, name, kind, version)
    if read.interface is None:
        return [_in_string(each, where) for each in read.diagnostics]
    return Definition(text, read.interface)


def drop_type(run: Run, statement: st.DropType) -> None:
    """Take a type of the program away."""
    own = _own_type(run, statement)
    users = list(dict.fromkeys(_users(run, own)))
    if users:
        raise _in_use(statement, own, users)
    del run.workspace.types[statement.type]
    run.workspace.written_types.pop(statement.type, None)
    run.types.changed()


def generate_type(run: Run, statement: st.GenerateType) -> None:
    """Note that a type is to be written for its own sake."""
    _own_type(run, statement)
    run.workspace.written_types[statement.type] = statement.span


def _own_type(run: Run, statement: Any) -> OwnType:
    """Return the type that a statement is about."""
    variable: str = statement.type
    own = run.workspace.types.get(variable)
    if own is not None:
        return own
    if run.consequences.declares(variable):
        raise Mistake
    where = statement.span_of("type")
    other = run.workspace.what(variable)
    remedy, fix = guess(variable, run.workspace.types, where)
    if other is not None:
        remedy, fix = f"`{variable}` is a {other[0]}", None
    remedy = remedy or f"make it first: `create_message_type {variable} with …`"
    message = f"the program has no type `{variable}` of its own"
    raise Mistake(Diagnostic(codes.UNKNOWN_OWN_TYPE, message, where, help=remedy, fix=fix))


def _section(statement: Any, own: OwnType) -> int:
    """Return the part of a type that a statement means, from 0."""
    names = SECTIONS[own.kind]
    if statement.section is None:
        return 0
    if statement.section in names:
        return names.index(statement.section)
    where = statement.span_of("section")
    message = f"`{own.name}` has no part `{statement.section}`"
    known = [each for each in names if each]
    remedy, fix = guess(statement.section, known, where)
    if not known:
        remedy = "a message has one part only: leave it out"
    elif remedy is None:
        remedy = f"its parts are {', '.join(known)}"
    raise Mistake(Diagnostic(codes.NO_SUCH_FIELD, message, where, help=remedy, fix=fix))


def _settle(
    run: Run, statement: Any, own: OwnType, make: _Make, variable: str | None = None
) -> None:
    """Let a type mean in each generation of ROS what it is there now.

    What is wrong in the generation that the program is for is told here; in the other one, where
    a node of it uses the type.
    """
    first = run.checks.version(None)
    others = run.messages.other_versions()
    definitions: dict[int, Definition] = {}
    wrong: dict[int, list[Diagnostic]] = {}
    for version in (first, 3 - first):
        if own.definitions and version not in own.definitions:
            wrong[version] = [own.wrong[version]]
            continue
        made = make(version)
        if isinstance(made, list):
            wrong[version] = made
        else:
            definitions[version] = made
    if first in wrong and not (definitions and others):
        raise Mistake(*wrong[first])
    kept = {version: found[0] for version, found in wrong.items() if found}
    changed = own.with_definitions(definitions, kept)
    types, key = run.workspace.types, variable or own.name
    before = types.get(key)
    types[key] = changed
    try:
        run.types.changed()
        for version in definitions:
            _check_circle(run, statement, changed, version)
        if before is not None:
            broken = list(run.types.broken_uses())
            if broken:
                raise _in_use(statement, own, broken)
    except Mistake:
        if before is None:
            del types[key]
        else:
            types[key] = before
        run.types.changed()
        raise


def _check_circle(run: Run, statement: Any, own: OwnType, version: int) -> None:
    package = run.types.own_package(version)
    interfaces = interfaces_of(run.workspace.types.values(), version, package)
    messages = {
        name: each for (kind, name), each in interfaces.items() if kind is InterfaceKind.MESSAGE
    }
    circle = find_circle(messages)
    if circle:
        names = [each.name for each in circle]
        shown = " in ".join(f"`{each}`" for each in (*names, names[0]))
        slot = "definition" if isinstance(statement, st.HasField) else "type"
        if own.source is not None and isinstance(statement, st.LoadType):
            slot = "source"
        message = f"`{names[0]}` contains itself: {shown}"
        if len(names) == 1:
            message = f"`{names[0]}` contains itself"
        raise Mistake(Diagnostic(codes.CIRCULAR_TYPE, message, statement.span_of(slot)))


def _users(run: Run, own: OwnType) -> Iterator[Span]:
    """Yield the statements that use a type."""
    names = {each.interface.name for each in own.definitions.values()}
    for node in run.workspace.nodes.values():
        for endpoint in node.endpoints.values():
            if endpoint.type in names and endpoint.span is not None:
                yield endpoint.span
    for message in run.workspace.messages.values():
        if message.value.type in names:
            yield message.span
    for other in run.workspace.types.values():
        sections = (
            section for each in other.definitions.values() for section in each.interface.sections
        )
        if other is not own and any(names & nested_names(section) for section in sections):
            yield other.span


def _in_use(statement: Any, own: OwnType, users: Sequence[Span]) -> Mistake:
    message = f"something of the program uses `{own.name}` as it is"
    return Mistake(
        Diagnostic(
            codes.TYPE_IN_USE,
            message,
            statement.span,
            help="change first what uses it",
            labels=tuple(Label(span, "used here") for span in users[:5]),
        )
    )
