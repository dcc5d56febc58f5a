"""The parameter files of a workspace, and which nodes may get them from launch files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import chain

from plastron_tui.diagnostics import Span
from plastron_tui.lint.tree import LaunchFacts, SettingPlace
from plastron_tui.ros.launch import Container, Group, Item, LaunchFile
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Resolved, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_blocks import ParameterBlock, read_blocks

LARGEST = 256 * 1024
"""In bytes; a parameter file has some kilobytes."""


def is_parameter_file(path: str) -> bool:
    """Tell whether a file may have parameters of ROS 2, by its name."""
    return path.endswith((".yaml", ".yml"))


def blocks_of(text: bytes | None) -> tuple[ParameterBlock, ...] | None:
    """Return what a file says of parameters, None where it is no parameter file of ROS 2."""
    return read_blocks(text) if text is not None and b"ros__parameters" in text else None


def setting_places(
    launches: Iterable[LaunchFacts], others: Iterable[Started]
) -> Iterator[tuple[SettingPlace, Span]]:
    """Yield where launch files name the parameters that they set of nodes.

    Args:
        launches: the launch files.
        others: the nodes that they start only where they are given other arguments.
    """
    resolved = (node for launch in launches for node in launch.resolved.started)
    for node in chain(others, resolved):
        if node.file is not None and node.place is not None:
            for name, span in node.setting_spans:
                yield SettingPlace(node.file, node.place.start, name), span


def unstarted(
    launch: LaunchFile,
    scope: Scope,
    file: str,
    open_include: Callable[[str], Opened],
    started: Resolved,
) -> Iterator[Started]:
    """Yield the nodes that a launch file of ROS 2 starts only where it is given other arguments.

    Args:
        launch: what it says.
        scope: the arguments that it is given, and what else substitutions ask for.
        file: its path.
        open_include: reads a file that it includes.
        started: what it starts.
    """

    def opened(name: str) -> Opened:
        found = open_include(name)
        return found if found.launch is None else found._replace(launch=_always(found.launch))

    known = {(each.file, each.place) for each in started.started}
    resolved = resolve(_always(launch), 2, scope, file, opened)
    yield from (each for each in resolved.started if (each.file, each.place) not in known)


def _always(launch: LaunchFile) -> LaunchFile:
    """Return a launch file without its conditions."""
    return LaunchFile(tuple(map(_unconditional, launch.items)))


def _unconditional(item: Item) -> Item:
    match item:
        case Group():
            items = tuple(map(_unconditional, item.items))
            return replace(item, condition=None, items=items)
        case Container():
            components = tuple(replace(each, condition=None) for each in item.components)
            return replace(item, condition=None, components=components)
        case _:
            return replace(item, condition=None)
