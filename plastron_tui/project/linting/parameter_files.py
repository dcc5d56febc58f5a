"""The parameter files of a workspace, and which nodes may get them from launch files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.lint.tree import LaunchFacts, SettingPlace
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.launch import Container, Group, Item, LaunchFile
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Resolved, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_blocks import ParameterBlock, read_blocks
from plastron_tui.sources.not_text import not_utf_8, without_nul

from .kept_diagnostics import Kept, is_template, kept, unread

LARGEST = 256 * 1024
"""In bytes; a parameter file has some kilobytes."""


def is_parameter_file(path: str) -> bool:
    """Tell whether a file may have parameters of ROS 2, by its name."""
    return path.endswith((".yaml", ".yml"))


class ParameterFileRead(NamedTuple):
    """What was read of a parameter file of ROS 2.

    Attributes:
        blocks: what it says, None where it is none that a node can take.
        wrong: why no node can take it, or why it is not read here.
    """

    blocks: tuple[ParameterBlock, ...] | None
    wrong: Kept = ()


def text_of(path: str, limit: int) -> bytes | None:
    """Return what a file holds, None where it cannot be read, or has more bytes than may be."""
    with suppress(OSError, ValueError):
        return read_regular(path, limit)
    return None


def read_parameter_file(name: str) -> ParameterFileRead | None:
    """Return what a file says of parameters, None where it is no parameter file of ROS 2."""
    text, path = text_of(name, LARGEST), Path(name)
    if text is None or b"ros__parameters" not in without_nul(text):
        return None
    blocks = read_blocks(text)
    return ParameterFileRead(blocks, kept(() if blocks is not None else _wrong(text, path)))


def _wrong(text: bytes, path: Path) -> Iterator[Diagnostic]:
    other = not_utf_8(text, path)
    if is_template(path) or b"{{" in text or b"{%" in text:
        return
    error = _mistake(text)
    if error is not None and other is not None:
        yield other
    elif error is not None:
        mark = getattr(error, "problem_mark", None)
        why = getattr(error, "problem", None) or "it cannot be read"
        span = None if mark is None else _line(text, mark.line)
        yield Diagnostic(codes.BAD_PARAMETERS, f"this is no YAML: {why}", span, path)
    elif other is not None:
        yield unread(other)


def _line(text: bytes, row: int) -> Span:
    """Return what a line says, counted from 0; behind the last one it is that."""
    lines = text.split(b"\n")
    row = min(row, len(lines) - 1)
    start = sum(map(len, lines[:row])) + row
    return Span(start, start + len(lines[row].rstrip()))


def is_no_yaml(text: bytes) -> bool:
    """Tell whether the parser that ROS uses refuses a text."""
    return _mistake(text) is not None


def _mistake(text: bytes) -> Exception | None:
    import yaml

    loader = yaml.CBaseLoader if yaml.__with_libyaml__ else yaml.BaseLoader
    try:
        for _ in yaml.parse(text, Loader=loader):
            pass
    except (yaml.YAMLError, ValueError) as error:
        return error
    return None


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
    ros_version: int,
    scope: Scope,
    file: str,
    open_include: Callable[[str], Opened],
    started: Resolved,
) -> Iterator[Started]:
    """Yield the nodes that a launch file starts only where it is given other arguments.

    Args:
        launch: what it says.
        ros_version: the generation of ROS that it is for.
        scope: the arguments that it is given, and what else substitutions ask for.
        file: its path.
        open_include: reads a file that it includes.
        started: what it starts.
    """

    def opened(name: str) -> Opened:
        found = open_include(name)
        return found if found.launch is None else found._replace(launch=_always(found.launch))

    known = {(each.file, each.place) for each in started.started}
    resolved = resolve(_always(launch), ros_version, scope, file, opened)
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
