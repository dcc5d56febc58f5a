"""Robots that are read from their own files, without a program."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import find_boundary
from plastron_tui.diagnostics import Diagnostic, LineIndex
from plastron_tui.model.robots import Robot
from plastron_tui.project.program_file import lines_of
from plastron_tui.project.robot_file import read_robot_file
from plastron_tui.ros.robots.macros import Arguments


class ReadRobot(NamedTuple):
    """A robot's file.

    Attributes:
        file: the file, as it was named.
        text: what it holds.
        robot: its robot, None where it cannot be read.
        diagnostics: what is doubtful.
    """

    file: Path
    text: bytes
    robot: Robot | None
    diagnostics: tuple[Diagnostic, ...]

    def lines(self, file: Path | None) -> LineIndex | None:
        """Return the lines of the file, or of one that it includes, for a diagnostic."""
        if file is None or file == self.file:
            return LineIndex(self.text)
        return lines_of(file)


def read_robot(
    file: Path, text: bytes, given: Arguments = (), *, is_drawn: bool = False
) -> ReadRobot:
    """Read the robot of a file that a user named; the meshes of one that is drawn are measured.

    Macros are expanded where the project of the file is trusted; else there is what stands in the
    file itself, and a diagnostic says why. They are given arguments as `NAME:=VALUE` has them.
    """
    boundary = find_boundary(file.absolute().parent)
    found = read_robot_file(file, text, boundary, os.environ, given, is_drawn=is_drawn)
    return ReadRobot(file, text, found.robot, found.diagnostics)
