"""Nodes that `plastron run` has to build before it can start them."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from posixpath import normpath
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.terminal import drawn_on

if TYPE_CHECKING:
    from plastron_tui.generating.generation import Generated
    from plastron_tui.model.workspace import Node
    from plastron_tui.project.run_setup import RunSetup
    from plastron_tui.runtime.build_output import Spans
    from plastron_tui.runtime.builds import BuiltPackage
    from plastron_tui.runtime.built_nodes import BuiltNode
    from plastron_tui.runtime.environment import Environment
    from plastron_tui.runtime.launch import NodeFile
    from plastron_tui.session import Session

_CONTAINERS = {1: "manager", 2: "container"}


def is_built_with(generated: Generated, chosen: Sequence[Generated]) -> bool:
    """Tell whether a node is in a package of which a chosen one has to be built."""
    home = generated.generation.node.home
    return home is not None and any(
        each.generation.node.home is not None
        and each.generation.node.home.package == home.package
        and _is_built(each)
        for each in chosen
    )


def built_files(
    session: Session,
    chosen: Sequence[Generated],
    environments: Mapping[str, Environment],
    setup: RunSetup,
) -> tuple[list[NodeFile], list[Diagnostic]]:
    """Build the packages of chosen nodes as they are on the disk, and return what starts each.

    Args:
        session: the program, which was written.
        chosen: the nodes that are started.
        environments: the environment of each client library.
        setup: what the user says about the run.
    """
    files: list[NodeFile] = []
    found: list[Diagnostic] = []
    nodes = [each for each in chosen if _is_built(each)]
    by_version: dict[int, list[Generated]] = {}
    for each in nodes:
        environment = environments.get(each.generation.library)
        if environment is not None:
            by_version.setdefault(environment.ros_version, []).append(each)
    # A build takes its time: what would keep the nodes from running anyway is told before it.
    wholes = []
    for those in by_version.values():
        environment = environments[those[0].generation.library]
        whole, problems = _whole(session, those, environment)
        wholes.append((environment, those, whole))
        found += problems
    if found:
        return [], found
    for environment, those, whole in wholes:
        made, problems = _built(session, those, environment, setup, whole)
        files += made
        found += problems
    return files, found


def _is_built(generated: Generated) -> bool:
    from plastron_tui.targets import LIBRARIES

    return LIBRARIES[generated.generation.library].is_built


class _Whole(NamedTuple):
    """What nodes are built as.

    Attributes:
        beside: the packages that have to be built before theirs.
        packages: their packages.
        loader: the program that loads them; None where each is a program, or there is none.
    """

    beside: Sequence[BuiltPackage]
    packages: Sequence[BuiltPackage]
    loader: Path | None


def _whole(
    session: Session, nodes: Sequence[Generated], environment: Environment
) -> tuple[_Whole, list[Diagnostic]]:
    """Return what nodes of one generation of ROS are built as, and what is missing for it."""
    from plastron_tui.runtime.built_nodes import LOADERS, find_loader

    packages = _packages(session, nodes)
    loaded = [each for each in nodes if _plugin_of(each) is not None]
    loader = find_loader(environment) if loaded else None
    if loaded and loader is None:
        missing = _no_loader(environment, LOADERS[environment.ros_version])
        return _Whole([], packages, None), [missing._replace(span=loaded[0].generation.span)]
    beside, problems = _beside(session, nodes, packages, environment)
    return _Whole(beside, packages, loader), problems


def _built(
    session: Session,
    nodes: Sequence[Generated],
    environment: Environment,
    setup: RunSetup,
    whole: _Whole,
) -> tuple[list[NodeFile], list[Diagnostic]]:
    from plastron_tui.runtime.build_progress import ProgressLine
    from plastron_tui.runtime.builds import overlay
    from plastron_tui.runtime.built_nodes import node_files

    version = environment.ros_version
    with ProgressLine(drawn_on(sys.stderr)) as line:
        built, problems = overlay(environment, [*whole.beside, *whole.packages], line.tell)
    if problems:
        first = nodes[0].generation.span
        return [], [x if x.span or x.file else x._replace(span=first) for x in problems]
    started = [_node(session, each, version, setup) for each in nodes]
    name = f"{whole.packages[-1].name}_{_CONTAINERS[version]}"
    return list(node_files(started, built, whole.loader, name)), []


def _plugin_of(generated: Generated) -> str | None:
    """Return the class that a node is loaded as, None for a program of its own."""
    from plastron_tui.targets import find_target

    target = find_target(generated.generation.library)
    return None if target is None else target.plugin_class(generated.generation.node)


def _node(session: Session, generated: Generated, version: int, setup: RunSetup) -> BuiltNode:
    from plastron_tui.runtime.built_nodes import BuiltNode

    node, path = generated.generation.node, generated.path(session.output)
    assert node.home is not None and path is not None, "it was written"
    return BuiltNode(
        node.name,
        node.home.package,
        path.stem if node.home.is_own else node.home.executable,
        _plugin_of(generated),
        setup.arguments(version, [node]),
        setup.names.namespace or "",
    )


def _packages(session: Session, nodes: Sequence[Generated]) -> list[BuiltPackage]:
    """Return the packages of nodes, as they are on the disk."""
    from plastron_tui.runtime.built_nodes import read_package

    spans: dict[tuple[str, Path], dict[str, Spans]] = {}
    for each in nodes:
        home, path = each.generation.node.home, each.path(session.output)
        assert home is not None and path is not None, "it was written"
        folder = session.output if home.is_output else session.output / home.package
        if home.above is not None:
            folder = Path(normpath(session.output / home.above))
        inner = path.relative_to(folder).as_posix()
        spans.setdefault((home.package, folder), {})[inner] = {0: each.generation.span}
    return [read_package(name, folder, those) for (name, folder), those in spans.items()]


def _beside(
    session: Session,
    nodes: Sequence[Generated],
    packages: Sequence[BuiltPackage],
    environment: Environment,
) -> tuple[list[BuiltPackage], list[Diagnostic]]:
    """Return the packages that have to be built before those of the nodes, or what is missing."""
    from plastron_tui.ros.interfaces import InterfaceKind
    from plastron_tui.runtime.build_needs import built_with, missing_for_build, not_found
    from plastron_tui.runtime.interface_packages import table_package

    version = environment.ros_version
    own, refused = own_packages(session, [each.generation.node for each in nodes], version)
    if refused:
        return [], refused
    named = {each.name for each in packages}
    beside = [each for each in own if each.name not in named]
    catalog = session.catalog(version)
    known = frozenset(each for kind in InterfaceKind for each in catalog.packages(kind))
    named |= {each.name for each in beside}
    needs = [
        need
        for each in (*packages, *beside)
        for need in built_with(each.files["package.xml"])
        if need not in named
    ]
    missing = missing_for_build(environment, needs, known)
    left = []
    for each in missing:
        definitions = catalog.table_package(each) if version == 2 else None
        if definitions is None:
            left.append(each)
        else:
            beside.insert(0, table_package(environment, each, definitions))
    if not left:
        return beside, []
    needing = _needing(nodes, left) or nodes[0]
    return [], [not_found(environment, left)._replace(span=needing.generation.span)]


def _needing(nodes: Sequence[Generated], packages: Sequence[str]) -> Generated | None:
    """Return the first node that includes a header of one of the packages, if any does."""
    from plastron_tui.targets import find_target

    folders = tuple(f"{each}/" for each in packages)
    for each in nodes:
        target = find_target(each.generation.library)
        if each.files is None or target is None:
            continue
        headers = (x for _, text in each.files.files.texts for x in target.language.imports(text))
        if any(header.startswith(folders) for header in headers):
            return each
    return None


def own_packages(
    session: Session, nodes: Sequence[Node], version: int
) -> tuple[list[BuiltPackage], list[Diagnostic]]:
    """Return the packages of the program's own types that nodes use, or why there are none."""
    from plastron_tui.runtime.builds import BuiltPackage

    packages = []
    refused: list[Diagnostic] = []
    for name, rendered in session.own_packages(nodes, version).items():
        if rendered.files is None:
            refused += rendered.diagnostics
            continue
        files = {path: file.text for path, file in rendered.files.items()}
        spans = {
            f"{type_.kind.value}/{type_.name}.{type_.kind.value}": {0: type_.span}
            for type_ in session.workspace.types.values()
            if (definition := type_.definitions.get(version)) is not None
            and definition.interface.name.package == name
        }
        executables = {path for path, file in rendered.files.items() if file.is_executable}
        packages.append(BuiltPackage(name, files, frozenset(executables), spans))
    return packages, refused


def _no_loader(environment: Environment, name: str) -> Diagnostic:
    """Say that nothing here loads nodes into its process."""
    from plastron_tui.ros.installations import Origin
    from plastron_tui.runtime import installing

    help_ = f"source a ROS that has `{name}`"
    if environment.origin is Origin.DEBIAN:
        help_ = "install it with `sudo apt install libnodeletlib-tools`"
    elif environment.origin is Origin.SOURCED:
        command = installing.of_distribution(name, environment.distribution)
        help_ = help_ if command is None else f"install it with `{command}`"
    message = f"`{name}` is not installed in {environment.words}, and it loads such nodes"
    return Diagnostic(codes.MISSING_ROS_PACKAGE, message, help=help_)
