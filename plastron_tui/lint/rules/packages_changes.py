"""Changes of types that break the code that uses them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Code, Diagnostic, Fix, Label, Severity, Span, write
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import Earlier, SourceTree, UnitFacts
from plastron_tui.model.code_facts import MessageType
from plastron_tui.ros.interfaces import (
    Field,
    FieldType,
    Interface,
    InterfaceKind,
    InterfaceName,
    Section,
)

from .package_examples import SPEED_USER, TYPES_PACKAGE

_FLOATS = frozenset({"float32", "float64"})
_TEXTS = frozenset({"string", "wstring"})

_Key = tuple[InterfaceKind, InterfaceName]


class _Use(NamedTuple):
    """A field that code names."""

    unit: UnitFacts
    file: Path
    span: Span


_Uses = Mapping[tuple[_Key, int, str], list[_Use]]
"""The uses by type, section and field."""


@rule(
    "RK508",
    "breaking-interface-change",
    "A type is not what it was at another revision, and code that uses it breaks.",
    why="It is looked for with `--against REV`, where REV is what git calls a revision. A field "
    "that is gone, or has a type of another kind, is told where nodes of the workspace use it, "
    "else at the definition, as a warning: nodes elsewhere may. A field that got another type is "
    "told of files that did not change since.",
    before=TYPES_PACKAGE,
    bad=TYPES_PACKAGE | {"demo/msg/Speed.msg": "float64 speed\n", "user.py": SPEED_USER},
    good=TYPES_PACKAGE | {"user.py": SPEED_USER},
)
def breaking_interface_change(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find what a change of a type breaks."""
    earlier = tree.earlier
    if earlier is None:
        return
    uses = _uses(tree, earlier)
    for (kind, name), old in sorted(earlier.interfaces.items(), key=lambda each: str(each[0])):
        package = tree.packages.get(name.package)
        if package is None:
            continue
        catalog = tree.catalogs.get(package.ros_versions[0])
        now = None if catalog is None else catalog.find(name, kind)
        if catalog is None or (now is None and name in catalog.names(kind)):
            continue
        file = package.folder / kind.value / f"{name.name}.{kind.value}"
        if now is None:
            yield from _gone(tree, code, earlier, kind, name)
            continue
        for at, (before, after) in enumerate(zip(old.sections, now.sections, strict=True)):
            for change in _changes(before, after):
                found = uses.get(((kind, name), at, change.field), [])
                if not change.is_gone:
                    found = [each for each in found if each.unit.path in earlier.unchanged]
                spans = earlier.places.get(file, {})
                place = spans.get((at, change.renamed or change.field), Span(0, 0))
                yield from _told(code, earlier, name, change, found, file, place)


class _Change(NamedTuple):
    """A field that is not what it was.

    Attributes:
        field: its name.
        message: what happened to it.
        is_gone: whether it is not there any more.
        renamed: the name that it surely has got, "" for none.
    """

    field: str
    message: str
    is_gone: bool
    renamed: str = ""


def _changes(before: Section, after: Section) -> Iterator[_Change]:
    old, new = ({each.name: each for each in part.fields} for part in (before, after))
    gone = [each for each in before.fields if each.name not in new]
    came = [each for each in after.fields if each.name not in old]
    for each in gone:
        same = [other.name for other in came if other.type == each.type]
        is_one = len(same) == 1 and [other.type for other in gone].count(each.type) == 1
        yield _Change(each.name, "is gone", True, same[0] if is_one else "")
    for each in before.fields:
        other = new.get(each.name)
        if other is not None and _is_other(each, other):
            yield _Change(each.name, f"was `{each.type}`, and is `{other.type}`", False)
    constants = {each.name for each in after.constants} | new.keys()
    for constant in before.constants:
        if constant.name not in constants:
            yield _Change(constant.name, "is gone", True)


def _is_other(one: Field, other: Field) -> bool:
    """Tell whether values of a field's type are of another kind than they were."""
    return _kind(one.type) != _kind(other.type) or one.type.length != other.type.length


def _kind(type_: FieldType) -> tuple[bool, str]:
    name = type_.name
    if type_.package is not None:
        name = str(type_.message)
    elif name in _FLOATS:
        name = "float"
    elif name in _TEXTS:
        name = "text"
    elif "int" in name or name in ("byte", "char"):
        name = "int"
    return type_.is_array, name


def _told(
    code: Code,
    earlier: Earlier,
    name: InterfaceName,
    change: _Change,
    uses: list[_Use],
    file: Path,
    place: Span,
) -> Iterator[Diagnostic]:
    message = f"`{change.field}` of `{name}` {change.message} since `{earlier.revision}`"
    help_ = f"it may be called `{change.renamed}` now" if change.renamed else None
    for use in uses:
        yield Diagnostic(
            code,
            message,
            use.span,
            use.file,
            help=help_,
            fix=_renamed(change, use),
            labels=(Label(place, "the definition", file),),
        )
    if not uses:
        message += ", which breaks whoever uses it"
        yield Diagnostic(code, message, place, file, help_, severity=Severity.WARNING)


def _renamed(change: _Change, use: _Use) -> Fix | None:
    is_name = use.span.end - use.span.start == len(change.field.encode())
    return write(change.renamed, use.span) if change.renamed and is_name else None


def _gone(
    tree: SourceTree, code: Code, earlier: Earlier, kind: InterfaceKind, name: InterfaceName
) -> Iterator[Diagnostic]:
    message = f"`{name}` is gone since `{earlier.revision}`"
    count = 0
    for unit in tree.built:
        for node in unit.nodes:
            for each in node.endpoints:
                if each.kind.facts.interface is kind and each.type == name:
                    count += 1
                    yield Diagnostic(code, message, each.span, unit.path_of(each))
    package = tree.packages[name.package]
    if not count and package.build is not None:
        message += ", which breaks whoever uses it"
        file = package.folder / "package.xml"
        yield Diagnostic(code, message, package.build.name_span, file, severity=Severity.WARNING)


def _uses(tree: SourceTree, earlier: Earlier) -> _Uses:
    """Return where code names fields of the types that there were."""
    found: dict[tuple[_Key, int, str], list[_Use]] = defaultdict(list)
    seen: set[tuple[Path, Span]] = set()
    for unit in tree.built:
        for use in unit.code.fields:
            for key, span in _steps(earlier, use.type, use.path, use.spans):
                _note(found, seen, key, _Use(unit, unit.file(use.file), span))
        for built in unit.code.built:
            for name, span in built.keywords:
                at = built.type.part.section
                key = ((built.type.kind, built.type.name), at, name)
                _note(found, seen, key, _Use(unit, unit.file(built.file), span))
    return found


def _note(
    found: dict[tuple[_Key, int, str], list[_Use]],
    seen: set[tuple[Path, Span]],
    key: tuple[_Key, int, str],
    use: _Use,
) -> None:
    if (use.file, use.span) not in seen:
        seen.add((use.file, use.span))
        found[key].append(use)


def _steps(
    earlier: Earlier, type_: MessageType, path: tuple[str, ...], spans: tuple[Span, ...]
) -> Iterator[tuple[tuple[_Key, int, str], Span]]:
    """Yield each name of a path with the type that it is a field of, as the types were."""
    key: _Key | None = (type_.kind, type_.name)
    at = type_.part.section
    for name, span in zip(path, spans, strict=False):
        if key is None:
            return
        yield (key, at, name), span
        key, at = _type_of(earlier.interfaces.get(key), at, name), 0


def _type_of(interface: Interface | None, at: int, name: str) -> _Key | None:
    """Return the message type of a field, None for any other, and where it is not known."""
    fields = () if interface is None else interface.sections[at].fields
    field = next((each for each in fields if each.name == name), None)
    message = None if field is None else field.type.message
    return None if message is None else (InterfaceKind.MESSAGE, message)
