"""The picture of a robot's file, without a program that loads it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.robots import Robot, file_stem
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.output.manifest import load_manifest
from plastron_tui.regular_files import read_regular, reason

from .named_texts import NamedTexts
from .robot_files import RobotFiles


class RobotGraph(NamedTuple):
    """The robot of a file, None where it cannot be read, and what is doubtful."""

    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...] = ()


def robot_graph(
    path: Path, boundary: Boundary, environ: Mapping[str, str], *, is_drawn: bool = False
) -> RobotGraph:
    """Read a robot's file.

    Args:
        path: the file.
        boundary: the project, which has to be trusted for macros to be expanded.
        environ: the environment variables that say which ROS is sourced.
        is_drawn: whether its meshes are to be measured.
    """
    try:
        read_regular(path, LARGEST_FILE)
    except OSError as error:
        message = f"`{path.name}` cannot be read: {reason(error)}"
        return RobotGraph(None, (Diagnostic(codes.UNREADABLE_FILE, message, file=path),))
    texts = NamedTexts(path.absolute().parent, boundary, "", b"", load_manifest)
    files = RobotFiles(texts, environ)
    loaded = files.read(path.name)
    found = tuple(each._replace(file=each.file or path) for each in loaded.diagnostics)
    source = loaded.source
    if source is None:
        return RobotGraph(None, found)
    robot = Robot(file_stem(path.name), Span(0, 0), source.description, source)
    if is_drawn:
        files.measure(robot)
    return RobotGraph(robot, found)
