"""The graph of what a launch file starts: each node with the names that it gets there."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary, holds_home
from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes
from plastron_tui.model.loading import add_found
from plastron_tui.model.source import LARGEST_FILE, SourceUnit
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.run_names import Remap, RunNames
from plastron_tui.sources.launch.around import own_package, packages_around, packages_root
from plastron_tui.sources.launch.reader import file_content, open_included, read_launch
from plastron_tui.sources.launch.unresolved import warnings_of, wrong_arguments
from plastron_tui.sources.packages.folder import read_executables

from .loader import read_node, with_others

_SCRIPTS = ("scripts", "nodes", "src", "bin")


class LaunchGraph(NamedTuple):
    """The nodes that a launch file starts, None where it cannot be read, and what is doubtful."""

    workspace: Workspace | None
    diagnostics: tuple[Diagnostic, ...] = ()


def launch_graph(path: Path, arguments: Mapping[str, str], boundary: Boundary) -> LaunchGraph:
    """Read a launch file, and the nodes that it starts as far as they are found in the project.

    Args:
        path: the launch file.
        arguments: the values that it is given.
        boundary: the project: of what is beyond it, the packages around the launch file count.
    """
    try:
        text = read_regular(path, LARGEST_FILE)
    except OSError as error:
        message = f"`{path.name}` cannot be read: {reason(error)}"
        return LaunchGraph(None, (Diagnostic(codes.UNREADABLE_FILE, message, file=path),))
    read = read_launch(text, path)
    if read.launch is None:
        return LaunchGraph(None, read.diagnostics)
    boundary, root = _around(path, boundary)
    packages = packages_around(path.absolute(), root, boundary.allows)
    # The folder that is installed as the share is, in the source, the package's own.
    folders = {name: str(folder) for name, folder in packages.items()}

    def beyond(file: Path) -> str:
        return "" if boundary.allows(file) else f"it is {boundary.place_of(file)}"

    def content(path: str) -> str | None:
        return file_content(path, beyond)

    scope = Scope(arguments, {}, str(path.absolute().parent), folders.get, content)

    def opened(name: str) -> Opened:
        return open_included(Path(name), beyond)

    resolved = resolve(read.launch, read.format.ros_version, scope, str(path), opened)
    # A graph needs no value: what hangs on it is left out, and told.
    doubtful = (x for x in wrong_arguments(read.launch, path, arguments) if x.file is None)
    found = [*read.diagnostics, *doubtful, *warnings_of(resolved)]
    whole = Workspace()
    sources: dict[tuple[str, str], SourceUnit | None] = {}
    for started in resolved.started:
        key = started.package, started.executable
        if key not in sources:
            sources[key] = _source(packages.get(started.package), started, boundary)
            if sources[key] is None:
                found.append(_unseen(started))
        node = _node(started, sources[key], whole)
        whole.nodes[node.variable] = node
    return LaunchGraph(whole, tuple(found))


def _around(file: Path, boundary: Boundary) -> tuple[Boundary, Path]:
    """Return how far a launch file may lead, and the folder that its packages are in.

    Who names a launch file names the packages around it, too: `run` starts them. Of the home
    folder and those above it only the file's own package counts.
    """
    whole = file.absolute()
    if not boundary.allows(whole):
        return boundary, whole.parent
    root = Path(os.path.realpath(packages_root(whole)))
    if boundary.root in (root, *root.parents):
        return boundary, root
    if holds_home(root):
        root = Path(os.path.realpath(own_package(whole) or whole.parent))
    return replace(boundary, named=(*boundary.named, root)), root


def _source(package: Path | None, started: Started, boundary: Boundary) -> SourceUnit | None:
    """Return what is read of the file that an executable is made of, None where none is found."""
    if package is None:
        return None
    for path in _candidates(package, started.executable, boundary):
        if path.is_file() and boundary.allows(path):
            try:
                files = with_others(path, read_regular(path, LARGEST_FILE))
            except OSError:
                continue
            return read_node(path, files).source
    return None


def _candidates(package: Path, executable: str, boundary: Boundary) -> Iterator[Path]:
    known = read_executables(package, boundary.allows).get(executable)
    if known is not None and known.file is not None:
        yield package / known.file
    if "/" in executable:
        return
    for folder in (*_SCRIPTS, package.name, ""):
        for ending in ("", ".py"):
            yield package / folder / f"{executable}{ending}"


def _node(started: Started, source: SourceUnit | None, whole: Workspace) -> Node:
    """Return a node of the workspace, of which all names are the full ones that it gets."""
    own = None if source is None else next((x.name for x in source.nodes if x.name), None)
    name = started.name or own or started.executable
    full = f"{started.namespace}/{name}"
    variable, count = full.lstrip("/"), 1
    while variable in whole.nodes:
        count += 1
        variable = f"{full.lstrip('/')}_{count}"
    place = started.place
    span = Span(0, 0) if place is None else Span(place.start, place.end)
    shown = full if started.namespace else name
    node = Node(shown, variable, span, None if source is None else source.library, source)
    names = RunNames(started.namespace, tuple(Remap(a, b) for a, b in started.remaps))
    for endpoint in () if source is None else source.endpoints:
        if endpoint.label is not None and endpoint.kind.facts.interface is not None:
            add_found(node, endpoint, names.resolved(name, endpoint.label))
    return node


def _unseen(started: Started) -> Diagnostic:
    place = started.place
    return Diagnostic(
        codes.UNRESOLVED_LAUNCH,
        f"`{started.package}/{started.executable}` is not found as a file of the project that "
        "can be read, and is shown without topics",
        None if place is None else Span(place.start, place.end),
        None if started.file is None else Path(started.file),
        severity=Severity.WARNING,
    )
