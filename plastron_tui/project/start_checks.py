"""Names that a program's launch files give to what is not there.

A launch file that is started says little of such a mistake, or nothing. What is judged here is
known for sure: the nodes of the program itself, and the packages that it makes or loads.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Severity, codes, guess, write
from plastron_tui.model.launches import Included, Launch, Start
from plastron_tui.model.packages import Package
from plastron_tui.model.workspace import Node

if TYPE_CHECKING:
    from plastron_tui.generating.generation import Generated
    from plastron_tui.model.workspace import Generation, Workspace

    from .run_setup import RunNode

_ENDINGS = {1: (".launch",), 2: (".launch.xml", ".launch.py")}
"""How a program's launch files end, in each generation of ROS."""

_SCRIPT = ".py"

_UNSEEN = frozenset(("clock", "diagnostics", "parameter_events", "rosout", "tf", "tf_static"))
"""Topics that client libraries and their helpers give a node, which its file need not name."""


def start_problems(
    workspace: Workspace,
    generate: Callable[[Generation], Generated],
    output: Path,
    library: str,
) -> Iterator[Diagnostic]:
    """Yield what launch files name in nodes and packages of the program that these do not have.

    Args:
        workspace: what the program built.
        generate: makes the files of a node.
        output: the output folder.
        library: the client library of a node that names none.
    """
    packages = {each.name: each for each in workspace.packages.values()}
    for launch in workspace.launches.values():
        for start in launch.starts.values():
            if start.node is not None and (start.remaps or start.settings):
                node = _node(start, start.node, workspace, generate, output, library)
                yield from _unmet(start, node)
            elif start.node is None and start.package in packages:
                yield from _no_executable(start, packages[start.package])
        for each in launch.includes.values():
            if each.package in packages:
                yield from _no_launch_file(launch, each, packages[each.package])


def _node(
    start: Start,
    node: Node,
    workspace: Workspace,
    generate: Callable[[Generation], Generated],
    output: Path,
    library: str,
) -> RunNode:
    """Return what is known of a node's names, as it is started."""
    from plastron_tui.targets import ros_version

    from .run_setup import generated_node, run_node

    made = [each for each in workspace.generations if each.node.variable == node.variable]
    if made:
        found = generated_node(generate(made[-1]), output)
    else:
        found = run_node(node, ros_version(node.library or library), node.source)
    # Where parameters and private names are, hangs on the name that it runs under.
    return found._replace(name=start.run_name)


def _unmet(start: Start, node: RunNode) -> Iterator[Diagnostic]:
    from plastron_tui.ros.parameter_values import Assignment
    from plastron_tui.ros.run_names import Remap, RunNames

    from .run_setup import RunSetup

    namespace = None if start.namespace is None else f"/{start.namespace.strip('/')}"
    for (old, new), where in zip(start.remaps, start.remaps_where, strict=True):
        if old.lstrip("/") in _UNSEEN:
            continue
        setup = RunSetup(RunNames(namespace, (Remap(old, new),)))
        for found in setup.unmet([node]):
            remedy, fix = guess(old, node.names or (), where, is_quoted=True)
            message = f"`{old}` is the name of no topic or service of `{node.variable}`, so that "
            message += f"remapping it to `{new}` changes nothing"
            yield found._replace(message=message, span=where, help=remedy, fix=fix)
    for (name, value), where in zip(start.settings, start.settings_where, strict=True):
        setup = RunSetup(settings=(Assignment(node.name, name, value),))
        for found in setup.problems([node], None):
            remedy, fix = guess(name, node.parameters or (), where, is_quoted=True)
            message = (
                f"`{node.variable}` has no parameter `{name}`, so that its value changes nothing"
            )
            yield found._replace(message=message, span=where, help=remedy, fix=fix)


def _no_executable(start: Start, package: Package) -> Iterator[Diagnostic]:
    """Yield an error where a package that the program makes has no such executable.

    What a package installs that is only loaded is not known for sure: CMake decides it.
    """
    nodes = [each for each in package.contents.values() if isinstance(each.item, Node)]
    names = [each.name for each in nodes]
    if package.source is not None or start.container is not None:
        return
    if start.executable in (*names, *(f"{name}{_SCRIPT}" for name in names)):
        return
    words = dict(zip(names, (f"{package.name}/{name}" for name in names), strict=True))
    remedy, fix = guess(start.executable, names, start.where)
    near = next((word for name, word in words.items() if remedy and f"`{name}`" in remedy), None)
    if near is not None:
        remedy, fix = f"did you mean `{near}`?", write(f"'{near}'", start.where)
    yield Diagnostic(
        codes.NOT_IN_PACKAGE,
        f"`{package.variable}` has no executable `{start.executable}`",
        start.where,
        help=remedy or f"put it there: `{package.variable} contains NODE as '{start.executable}'`",
        fix=fix,
    )


def _no_launch_file(launch: Launch, included: Included, package: Package) -> Iterator[Diagnostic]:
    """Yield what says that a package has no such launch file.

    A package that is loaded may install it from elsewhere: then it is no more than likely.
    """
    files = list(_launch_files(package))
    others = (each for each in files if not each.startswith(f"launch/{launch.name}.launch"))
    is_loaded = package.source is not None
    if included.path in files:
        return
    if package.source is not None and _is_there(package.source.folder, included.path):
        return
    known = [f"{package.name}/{file.removeprefix('launch/')}" for file in others]
    remedy, fix = guess(f"{package.name}/{included.file}", known, included.where, is_quoted=True)
    yield Diagnostic(
        codes.NOT_IN_PACKAGE,
        f"`{package.variable}` has no launch file `{included.file}`",
        included.where,
        help=remedy or f"put it there: `{package.variable} contains LAUNCH`",
        fix=fix,
        severity=Severity.WARNING if is_loaded else Severity.ERROR,
    )


def _launch_files(package: Package) -> Iterator[str]:
    """Yield the launch files of a package, by their paths in it."""
    if package.source is not None:
        yield from (
            each for each in package.source.launches if each not in package.removed_launches
        )
    for each in package.contents.values():
        if not isinstance(each.item, Node):
            source = each.item.source
            if isinstance(each.item, Launch) and source is not None:
                yield f"launch/{source.path.name}"
                continue
            # A robot in a package has a launch file of its name.
            for ending in (ending for endings in _ENDINGS.values() for ending in endings):
                yield f"launch/{each.name}{ending}"


def _is_there(folder: Path, file: str) -> bool:
    return os.path.isfile(folder / file)  # noqa: PTH113 - a path that is too long is not there
