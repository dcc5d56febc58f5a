"""The robot of a file, without a program that loads it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.robots import Robot, file_stem
from plastron_tui.output.manifest import load_manifest

from .named_texts import NamedTexts
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
    *,
    is_drawn: bool = False,
) -> RobotFile:
    """Read a robot's file.

    Args:
        path: the file, as it was named; so diagnostics name it too.
        text: what it holds.
        boundary: the project, which has to be trusted for macros to be expanded.
        environ: the environment variables that say which ROS is sourced.
        is_drawn: whether its meshes are to be measured.
    """
    place = path.absolute()
    files = RobotFiles(NamedTexts(place.parent, boundary, "", b"", load_manifest), environ)
    loaded = files.read.read_text(path.name, place, text)
    found = tuple(
        each._replace(file=path) if each.file in (None, place) else each
        for each in loaded.diagnostics
    )
    source = loaded.source
    if source is None:
        return RobotFile(None, found)
    robot = Robot(file_stem(path.name), Span(0, 0), source.description, source)
    if is_drawn:
        files.measure(robot)
    return RobotFile(robot, found)
