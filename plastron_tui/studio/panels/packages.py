"""What a program makes beside nodes: packages, launch files, types of its own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from plastron_tui.language import DECLARATIONS
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import NoLongerContains, NoLongerStarts
from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries, Entry, Subject
from .entry_signs import SIGNS

if TYPE_CHECKING:
    from plastron_tui.model.launches import Launch
    from plastron_tui.model.own_types import OwnType
    from plastron_tui.model.packages import Package
    from plastron_tui.model.workspace import Generation, Workspace

    from ..analysis import Analysis

_EMPTY = "no packages, launch files or types of your own yet\ncreate_package 'rover' as rover"
_KINDS = {
    InterfaceKind.MESSAGE: "message",
    InterfaceKind.SERVICE: "service",
    InterfaceKind.ACTION: "action",
}


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    return Entries(_all(analysis), _EMPTY)


def _all(analysis: Analysis) -> Iterator[Entry]:
    workspace = analysis.workspace
    for name, nodes in _own(analysis).items():
        yield from _own_package(name, nodes)
    written = {each.package.variable for each in workspace.written_packages}
    for variable, package in workspace.packages.items():
        yield from _package(workspace, variable, package, variable in written)
    launched = {name for each in workspace.packages.values() for name in each.contents}
    launched |= {each.launch.variable for each in workspace.written_launches}
    for variable, launch in workspace.launches.items():
        yield from _launch(workspace, variable, launch, variable in launched)
    for name, own in workspace.types.items():
        yield _type(name, own)


def _own(analysis: Analysis) -> dict[str, dict[str, Generation]]:
    """Return the nodes by variable that are in a package which no statement makes, by its name."""
    from plastron_tui.targets import LIBRARIES

    # Only what has to be built is in one, or is beside it.
    names = {each.library for each in analysis.workspace.generations}
    libraries = map(LIBRARIES.get, names)
    if not any(each is not None and each.is_built for each in libraries):
        return {}
    found: dict[str, dict[str, Generation]] = {}
    for each in analysis.once("placed", analysis.session.placed):
        home = each.node.home
        if home is not None and home.is_own:
            found.setdefault(home.package, {})[each.node.variable] = each
    return found


def _own_package(package: str, nodes: Mapping[str, Generation]) -> Iterator[Entry]:
    first = next(iter(nodes.values()))
    is_there = first.node.home is not None and first.node.home.above is not None
    yield Entry(
        f"own package {package}",
        package,
        "around the output folder" if is_there else "of the program's own",
        *SIGNS[Subject.PACKAGE],
        span=first.span,
        is_branch=True,
    )
    for variable, each in nodes.items():
        yield Entry(
            f"own {package} {variable}",
            each.node.name,
            "" if each.node.name == variable else variable,
            *SIGNS[Subject.NODE],
            depth=1,
            span=each.span,
            node=variable,
            name=variable,
        )


def _package(
    workspace: Workspace, variable: str, package: Package, is_written: bool
) -> Iterator[Entry]:
    there = () if package.source is None else package.source.executables
    held = [name for name in there if name not in package.removed]
    parts = ["loaded" if package.source is not None else ""]
    if variable != package.name:
        parts.insert(0, variable)
    is_empty = not (package.contents or held)
    yield Entry(
        f"package {variable}",
        package.name,
        " · ".join(filter(None, parts)),
        *SIGNS[Subject.PACKAGE],
        warning="is empty" if is_empty else "" if is_written else "not written",
        span=package.span,
        subject=Subject.PACKAGE,
        name=variable,
        is_branch=not is_empty,
    )
    for item, contained in package.contents.items():
        is_node = item in workspace.nodes
        kind = Subject.ROBOT if item in workspace.robots else Subject.LAUNCH
        yield Entry(
            f"contained {variable} {item}",
            contained.name,
            "" if contained.name == item else item,
            *SIGNS[Subject.NODE if is_node else kind],
            depth=1,
            span=contained.span,
            node=item if is_node else None,
            name=item,
            ending=_ending(NoLongerContains, variable, item),
        )
    for name in held:
        yield Entry(
            f"there {variable} {name}",
            name,
            "in the package",
            "·",
            depth=1,
            name=name,
            ending=_ending(NoLongerContains, variable, f"'{name}'"),
        )


def _ending(type_: type[NoLongerContains], package: str, item: str) -> str:
    return sentence(DECLARATIONS[type_], {"package": package, "item": item})


def _launch(
    workspace: Workspace, variable: str, launch: Launch, is_written: bool
) -> Iterator[Entry]:
    yield Entry(
        f"launch {variable}",
        launch.name,
        "launch file" if variable == launch.name else f"{variable} · launch file",
        *SIGNS[Subject.LAUNCH],
        warning="" if is_written else "not written",
        span=launch.span,
        subject=Subject.LAUNCH,
        name=variable,
        is_branch=bool(launch.starts),
    )
    for name, started in launch.by_shortest_name.items():
        span = getattr(started, "span", None)
        namespace = getattr(started, "namespace", None)
        yield Entry(
            f"started {variable} {name}",
            name,
            f"in {namespace}" if namespace else "",
            *SIGNS[Subject.NODE],
            depth=1,
            span=span,
            name=name,
            ending=sentence(DECLARATIONS[NoLongerStarts], {"launch": variable, "name": name}),
        )


def _type(name: str, own: OwnType) -> Entry:
    return Entry(
        f"type {name}",
        name,
        f"{_KINDS[own.kind]} of your own",
        *SIGNS[Subject.TYPE],
        span=own.span,
        subject=Subject.TYPE,
        name=name,
    )


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    workspace = analysis.workspace
    own = len(_own(analysis))
    return own + len(workspace.packages) + len(workspace.launches) + len(workspace.types)
