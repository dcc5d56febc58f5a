"""The parameter files of a workspace, and which nodes may get them from launch files."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from plastron_tui.diagnostics import Span
from plastron_tui.lint.tree import LaunchFacts, SettingPlace
from plastron_tui.ros.launch import Container, Group, Item, LaunchFile, Place
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Resolved, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_blocks import ParameterBlock, read_blocks

LARGEST = 256 * 1024
"""In bytes; a parameter file has some kilobytes."""

_FOR_ALL = re.compile(rb"SetParameter|set_parameter")


def is_parameter_file(path: str) -> bool:
    """Tell whether a file may have parameters of ROS 2, by its name."""
    return path.endswith((".yaml", ".yml"))


def blocks_of(text: bytes | None) -> tuple[ParameterBlock, ...] | None:
    """Return what a file says of parameters, None where it is no parameter file of ROS 2."""
    return read_blocks(text) if text is not None and b"ros__parameters" in text else None


def setting_places(
    launches: Iterable[LaunchFacts],
    others: Iterable[Started],
    text_of: Callable[[str], bytes | None],
) -> Iterator[tuple[SettingPlace, Span]]:
    """Yield where launch files name the parameters that they set of nodes.

    A name that is found nowhere, or in several places of which each may be meant, has none.

    Args:
        launches: the launch files.
        others: the nodes that they start only where they are given other arguments.
        text_of: returns what a launch file holds.
    """
    for file, place, name in dict.fromkeys(_set(launches, others)):
        text = text_of(file)
        span = None if text is None else _named(text, place, name)
        if span is not None:
            yield SettingPlace(file, place.start, name), span


def _set(
    launches: Iterable[LaunchFacts], others: Iterable[Started]
) -> Iterator[tuple[str, Place, str]]:
    """Yield the names of parameters, each with the file that sets it and the node's place there."""
    started = [*others]
    for launch in launches:
        started += launch.resolved.started
        for each in launch.resolved.unresolved:
            if each.file is not None and each.place is not None and each.parameter:
                yield each.file, each.place, each.parameter
    for node in started:
        if node.file is not None and node.place is not None:
            for name, _ in node.parameters:
                yield node.file, node.place, name


def _named(text: bytes, place: Place, name: str) -> Span | None:
    """Return the place of a name that a node of a launch file sets."""
    last = re.escape(name.rpartition(".")[2].encode())
    word = re.compile(
        rb"""(?P<quote>["'])(?:[\w.]+\.)?%s(?P=quote)(?!\w)|\bname:\s*%s\s*$""" % (last, last), re.M
    )
    within = list(word.finditer(text, place.start, place.end))
    # `{'rate': 10}` names a parameter, `LaunchConfiguration('rate')` does not.
    keys = [each for each in within if text[each.end() : each.end() + 2].lstrip().startswith(b":")]
    found = keys or within
    if not found and not _FOR_ALL.search(text):
        found = list(word.finditer(text))
    return Span(*found[0].span()) if len(found) == 1 else None


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
