"""The robot of a file, without a program that loads it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.robot_arguments import unused_arguments
from plastron_tui.model.robots import Robot, file_stem
from plastron_tui.output.manifest import load_manifest
from plastron_tui.ros.robots.macros import Arguments

from .named_texts import NamedTexts
from .robot_expansion import said_by_command
from .robot_files import RobotFiles


class RobotFile(NamedTuple):
    """The robot of a file, None where it cannot be read, and what is doubtful."""

    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_robot_file(
    path: Path,
    text: bytes,
    boundary: Boundary,
    environ: Mapping[str, str],
    arguments: Arguments = (),
    *,
    is_drawn: bool = False,
) -> RobotFile:
    """Read a robot's file.

    Args:
        path: the file, as it was named; so diagnostics name it too.
        text: what it holds.
        boundary: the project, which has to be trusted for macros to be expanded.
        environ: the environment variables that say which ROS is sourced.
        arguments: what its macros are given.
        is_drawn: whether its meshes are to be measured.
    """
    place = path.absolute()
    texts = NamedTexts(place.parent, boundary, "", b"", load_manifest)
    files = RobotFiles(texts, environ, say=said_by_command)
    loaded = files.read.read_given(path.name, place, text, arguments)
    told = (*loaded.diagnostics, *unused_arguments(path.name, arguments, loaded))
    found = tuple(x._replace(file=path) if x.file in (None, place) else x for x in told)
    source = loaded.source
    if source is None:
        return RobotFile(None, found)
    robot = Robot(file_stem(path.name), Span(0, 0), source.description, source)
    if is_drawn:
        files.measure(robot)
    return RobotFile(robot, found)
