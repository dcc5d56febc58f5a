"""The statements that make interface types, change them, and write them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
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
from plastron_tui.ros.definition_edits import add_member, remove_member, replace_member
from plastron_tui.ros.definition_members import (
    check_type_length,
    check_type_name,
    check_type_package,
    generated_stems,
)
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName, Section
from plastron_tui.ros.packages import LONGEST_PACKAGE_NAME

from .field_lines import field_line
from .mistake import Mistake
from .other_things import another
from .own_type_changes import Make, in_use, settle, users_of
from .own_types import SECTIONS, Definition, DefinitionSource, OwnType
from .run import Run
from .type_members import Naming, members_of, section_of

_PARTS: dict[type[Statement], tuple[InterfaceKind, tuple[str, ...]]] = {
    st.CreateMessageType: (InterfaceKind.MESSAGE, ("fields",)),
    st.CreateServiceType: (InterfaceKind.SERVICE, ("request", "response")),
    st.CreateActionType: (InterfaceKind.ACTION, ("goal", "result", "feedback")),
}
"""The kind of interface that a statement makes, and the slots that have its fields."""


def create_type(run: Run, statement: Any) -> None:
    """Make a type of messages, services or actions."""
    package, name = check_type_named(run, statement)
    own = OwnType(name, package, _PARTS[type(statement)][0], statement.span)
    _check_hidden(run, statement, own)
    settle(run, statement, own, _maker(run, statement))


def _check_hidden(run: Run, statement: Any, own: OwnType) -> None:
    """Warn where a bare name means another type from here on than it did."""
    version = run.checks.version(None)
    owner = own.package or run.types.own_package(version)
    candidates = run.setting.catalog(version).candidates(own.name, own.kind)
    if len(candidates) == 1 and candidates[0].package != owner:
        message = f"`{own.name}` means this type from here on, and no longer `{candidates[0]}`"
        help_ = f"choose another name, or write the other one as `{candidates[0]}`"
        where = statement.span_of("type")
        run.report(statement, Diagnostic(codes.TYPE_HIDDEN, message, where, help=help_))


def _maker(run: Run, statement: Any) -> Make:
    kind, slots = _PARTS[type(statement)]
    package, name = _split(statement)
    sections = [(slot, getattr(statement, slot)) for slot in slots]

    def make(version: int) -> Definition | list[Diagnostic]:
        owner = package or run.types.own_package(version)
        return _made(run, statement, InterfaceName(owner, name), kind, sections, version)

    return make


def check_fields(run: Run, statement: Any) -> None:
    """Check the fields that a statement gives a type, in a generation of ROS that may have it."""
    found = [_maker(run, statement)(version) for version in _versions(run)]
    if all(isinstance(each, list) for each in found) and isinstance(found[0], list):
        raise Mistake(*found[0])


def _versions(run: Run) -> tuple[int, ...]:
    """Return the generations of ROS that types may be for, that of the program first."""
    first = run.checks.version(None)
    return (first, *run.messages.other_versions())


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


def check_type_named(run: Run, statement: Any) -> tuple[str, str]:
    """Return package and name of a type that may have them, and that is not there yet."""
    package, name = _split(statement)
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
    if problem is None and len(package) > LONGEST_PACKAGE_NAME:
        problem = (
            f"the name of a package has at most {LONGEST_PACKAGE_NAME} characters, and this one "
            f"{len(package)}"
        )
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
    _check_files(run, statement, package, name)
    owner = package or run.types.own_package(version)
    too_long = check_type_length(owner, name, _PARTS[type(statement)][0], version)
    if too_long is not None:
        raise Mistake(Diagnostic(codes.BAD_TYPE_NAME, too_long, where))
    is_there = any(each.name == owner for each in run.workspace.packages.values())
    if not is_there and run.types.is_of_ros(owner, version):
        message = f"`{owner}` is a package of ROS, which gets no types of yours"
        raise Mistake(Diagnostic(codes.TYPE_EXISTS, message, where, help="leave the package out"))
    return package, name


def _check_files(run: Run, statement: Any, package: str, name: str) -> None:
    """Check that nothing else of the package gets the files that are generated for a type."""
    kind = _PARTS[type(statement)][0]
    beside = [each for each in run.workspace.types.values() if each.package == package]
    for version in _versions(run):
        files = generated_stems(name, kind, version)
        earlier = next(
            (each for each in beside if files & generated_stems(each.name, each.kind, version)),
            None,
        )
        if earlier is not None:
            message = f"ROS {version} generates `{name}` and `{earlier.name}` into the same files"
            label = Label(earlier.span, "first here")
            where = statement.span_of("type")
            raise Mistake(
                Diagnostic(
                    codes.TYPE_EXISTS, message, where, help="choose another name", labels=(label,)
                )
            )


def _made(
    run: Run,
    statement: Any,
    name: InterfaceName,
    kind: InterfaceKind,
    parts: Sequence[tuple[str, Sequence[FieldText]]],
    version: int,
) -> Definition | list[Diagnostic]:
    own = name.name if kind is InterfaceKind.MESSAGE else ""
    types = run.types
    explain = partial(types.explain, statement)
    naming = Naming(version, name.package, types.resolver(version), own, types.is_broken, explain)
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
    _check_first(run, statement, kind, name)

    def make(version: int) -> Definition | list[Diagnostic]:
        read = parse_definition(text, name, kind, version, path)
        errors = [each for each in read.diagnostics if each.severity is Severity.ERROR]
        if read.interface is None:
            return errors
        return Definition(text, read.interface)

    source = DefinitionSource(path, text)
    own = OwnType(path.stem, package, kind, statement.span, source=source)
    settle(run, statement, own, make, variable=statement.variable)


def _check_first(
    run: Run, statement: st.LoadType, kind: InterfaceKind, name: InterfaceName
) -> None:
    """Check that the program has no type of the kind and name that a definition file has."""
    version = run.checks.version(None)
    for other in run.workspace.types.values():
        owner = other.package or run.types.own_package(version)
        if (other.kind, owner, other.name) != (kind, name.package, name.name):
            continue
        message = f"the program has a type `{name}` already"
        raise Mistake(
            Diagnostic(
                codes.TYPE_EXISTS,
                message,
                statement.span_of("source"),
                help="load it once, or a file of another package",
                labels=(Label(other.span, "first here"),),
            )
        )


def has_field(run: Run, statement: st.HasField) -> None:
    """Give a type a field, or a field another type."""
    own = _own_type(run, statement)
    section = _section(statement, own)
    where = statement.span_of("definition")

    def make(version: int) -> Definition | list[Diagnostic]:
        name = InterfaceName(own.package or run.types.own_package(version), own.name)
        line = field_line(run, statement, name, version)
        if isinstance(line, list):
            return line
        before = own.definitions[version]
        member = parse_definition(line, name, InterfaceKind.MESSAGE, version).interface
        assert member is not None  # it was read before
        [(added, new)] = members_of(member.sections[0]).items()
        old = members_of(before.interface.sections[section]).get(added)
        if old == new and own.source is not None:
            # An earlier run may have written it over the file.
            return before
        if old == new:
            message = f"`{own.name}` has `{line}` already"
            fix = Fix("take the statement away", (Edit(statement.span, ""),))
            return [Diagnostic(codes.FIELD_EXISTS, message, where, fix=fix)]
        if old is None:
            text = add_member(before.text, line, section)
        else:
            text = replace_member(before.text, added, line, section, ros_version=version)
        return _read_again(text, name, own.kind, version, where)

    settle(run, statement, own, make, variable=statement.type)


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
            found = Diagnostic(codes.NO_SUCH_FIELD, message, where, help=remedy, fix=fix)
            if own.source is None:
                return [found]
            if version == run.checks.version(None):
                run.report(statement, found._replace(severity=Severity.WARNING))
            return before
        text = remove_member(before.text, statement.field, section)
        return _read_again(text, before.interface.name, own.kind, version, where)

    settle(run, statement, own, make, variable=statement.type)


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
    users = list(dict.fromkeys(users_of(run, own)))
    if users:
        raise in_use(statement, own, users)
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
    near = guess(variable, run.workspace.types, where)
    remedy, fix = another(run.workspace, statement, variable) or near
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
