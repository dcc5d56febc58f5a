"""Definitions of types that no build makes types of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity, listed, write
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import PackageFacts, SourceTree
from plastron_tui.model.package_facts import DefinitionMistake
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .package_examples import TYPES_PACKAGE


@rule(
    "RK507",
    "definition-not-built",
    "A definition that the build does not take, or that it takes and that is not there.",
    why="A definition that no command of CMake names has no type: who imports it gets an error. "
    "Types are built where `rosidl_generate_interfaces` (in ROS 1 `add_message_files` and "
    "`generate_messages`) names the files and the packages that they are made of, what generates "
    "them is found, and, in ROS 2, the package is a member of `rosidl_interface_packages`. Lists "
    "that are computed are not followed. It is an error where a node of the workspace uses the "
    "type, or a definition that is built is made of it, and where the commands or package.xml "
    "themselves lack something. A definition that is left out, and that nothing of the "
    "workspace uses, is a warning, as it may be there for later: it is told once for all of a "
    "package where they are many, and not where a comment in the command "
    "has its name. Messages that the build makes of an action are left alone.",
    bad=TYPES_PACKAGE | {"demo/msg/Angle.msg": "float64 value\n"},
    good=TYPES_PACKAGE,
)
def definition_not_built(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find what keeps types from being built."""
    used = cache(lambda: _used(tree))
    for package in tree.packages.values():
        left: list[DefinitionMistake] = []
        for each in () if package.build is None else package.build.definitions:
            catalog = tree.catalogs.get(package.ros_versions[0])
            if each.package and (catalog is None or _comes_along(each, catalog)):
                continue
            if each.type and InterfaceName(package.name, each.type) not in used():
                left.append(each)
            else:
                yield _told(code, package, each)
        left = [each for each in left if not each.is_taken_out]
        for each in left if len(left) <= _FEW else ():
            told = _told(code, package, each)
            remedy = f"{each.help}, or take the file out: nothing uses it"
            yield told._replace(help=remedy, severity=Severity.WARNING)
        if len(left) > _FEW:
            yield _told_at_once(code, package, left)


_FEW = 3
"""As many definitions may each have been forgotten; more of a package are left of an older one."""


def _told_at_once(
    code: Code, package: PackageFacts, left: Sequence[DefinitionMistake]
) -> Diagnostic:
    first, *others = left
    told = _told(code, package, first)
    return told._replace(
        message=f"{first.message}, nor {len(others)} more: {listed(each.type for each in others)}",
        help="name them in the commands that build types, or take the files out: nothing uses them",
        severity=Severity.WARNING,
    )


def _told(code: Code, package: PackageFacts, mistake: DefinitionMistake) -> Diagnostic:
    other = mistake.other
    return Diagnostic(
        code,
        mistake.message,
        mistake.place.span,
        package.folder / mistake.place.file,
        help=mistake.help,
        fix=write(mistake.remedy, mistake.place.span) if mistake.remedy else None,
        labels=()
        if other is None
        else (Label(other.span, "the command", package.folder / other.file),),
    )


def _used(tree: SourceTree) -> frozenset[InterfaceName]:
    """Return the types that nodes of the workspace use, and those that built ones are made of."""
    found = {
        endpoint.type for unit in tree.built for node in unit.nodes for endpoint in node.endpoints
    } | {each.type.name for unit in tree.built for each in unit.code.built}
    used = {each for each in found if each is not None}
    for package in tree.packages.values():
        left = {each.type for each in (package.build.definitions if package.build else ())}
        catalog = tree.catalogs.get(package.ros_versions[0])
        # ROS 1 makes messages of actions, of which copies may lie there that no build takes.
        if catalog is None or 1 in package.ros_versions or not left - {""}:
            continue
        for kind in InterfaceKind:
            own = [each for each in catalog.names(kind) if each.package == package.name]
            for interface in (catalog.find(each, kind) for each in own if each.name not in left):
                used.update(
                    each.type.message
                    for section in (interface.sections if interface else ())
                    for each in section.fields
                    if each.type.message is not None
                )
    return frozenset(used)


def _comes_along(mistake: DefinitionMistake, catalog: Catalog) -> bool:
    """Tell whether a package that the build is told of may bring the one that it is not told of."""
    seen: set[str] = set()
    waiting = list(mistake.named)
    names = {kind: catalog.names(kind) for kind in InterfaceKind}
    while waiting:
        package = waiting.pop()
        if package in seen:
            continue
        seen.add(package)
        own = [(kind, one) for kind in names for one in names[kind] if one.package == package]
        if not own or package == mistake.package:
            return True
        for kind, name in own:
            interface = catalog.find(name, kind)
            if interface is None:
                return True
            for section in interface.sections:
                waiting.extend(x.type.package for x in section.fields if x.type.package)
    return False
