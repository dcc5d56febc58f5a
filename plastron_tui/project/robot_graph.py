"""A robot's file, and its picture, without a program that loads it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.robot_arguments import unused_arguments
from plastron_tui.model.robots import LoadedRobot, Robot, file_stem
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.output.manifest import load_manifest
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.robots.macros import Arguments

from .named_texts import NamedTexts
from .robot_expansion import said_by_command
from .robot_files import RobotFiles


class RobotGraph(NamedTuple):
    """The robot of a file, None where it cannot be read, and what is doubtful."""

    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...] = ()


class RobotFile(NamedTuple):
    """What became of a robot's file, what is doubtful in it, and what reads such files."""

    loaded: LoadedRobot
    diagnostics: tuple[Diagnostic, ...]
    files: RobotFiles


def read_robot_file(
    path: Path, boundary: Boundary, environ: Mapping[str, str], arguments: Arguments = ()
) -> RobotFile:
    """Read a robot's file, which is there; the arguments are those of `robot_graph`."""
    # A program would take `~` for a home folder.
    name = f"./{path.name}" if path.name.startswith("~") else path.name
    texts = NamedTexts(path.absolute().parent, boundary, "", b"", load_manifest)
    files = RobotFiles(texts, environ, say=said_by_command)
    loaded = files.read(name, arguments)
    told = (*loaded.diagnostics, *unused_arguments(path.name, arguments, loaded))
    return RobotFile(loaded, told, files)


def robot_graph(
    path: Path,
    boundary: Boundary,
    environ: Mapping[str, str],
    arguments: Arguments = (),
    *,
    is_drawn: bool = False,
) -> RobotGraph:
    """Read a robot's file.

    Args:
        path: the file.
        boundary: the project, which has to be trusted for macros to be expanded.
        environ: the environment variables that say which ROS is sourced.
        arguments: what its macros are given.
        is_drawn: whether its meshes are to be measured.
    """
    try:
        read_regular(path, LARGEST_FILE)
    except OSError as error:
        message = f"`{path.name}` cannot be read: {reason(error)}"
        return RobotGraph(None, (Diagnostic(codes.UNREADABLE_FILE, message, file=path),))
    read = read_robot_file(path, boundary, environ, arguments)
    found = tuple(each._replace(file=each.file or path) for each in read.diagnostics)
    source = read.loaded.source
    if source is None:
        return RobotGraph(None, found)
    robot = Robot(file_stem(path.name), Span(0, 0), source.description, source)
    if is_drawn:
        read.files.measure(robot)
    return RobotGraph(robot, found)
