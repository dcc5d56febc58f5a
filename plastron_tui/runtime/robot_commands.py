"""What `xacro` says in a launch file of ROS 2, by which robot_state_publisher gets a robot.

Source: `launch.substitutions.Command`: words as a shell splits them, and what the command prints.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from pathlib import Path

from plastron_tui.boundary import find_boundary
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.sources.urdf.reach import find_reach
from plastron_tui.sources.xml.outline import MOST_BYTES

XACRO = "xacro"
_IS = ":="


class RobotCommands:
    """Expands the robots of a launch file where their projects are trusted.

    Attributes:
        problem: why the last one is not expanded, "" where it is.
    """

    def __init__(self, allows: Callable[[Path], bool], environ: Mapping[str, str]) -> None:
        """Set what may be read.

        Args:
            allows: tells whether a file is one that the launch file may lead to.
            environ: the environment variables.
        """
        self._allows = allows
        self._environ = environ
        self.problem = ""
        self._known: dict[str, str | None] = {}

    def __call__(self, command: str) -> str | None:
        """Return what a command says, None for one that is not `xacro`, or that fails."""
        # What is not known is asked for again, to tell it.
        if command not in self._known:
            self._known[command] = self._said(command)
        return self._known[command]

    def _said(self, command: str) -> str | None:
        try:
            name, file, *given = shlex.split(command)
        except ValueError:
            return None
        if Path(name).name != XACRO or not all(_IS in each for each in given):
            return None
        pairs = (each.partition(_IS) for each in given)
        text, self.problem = self._expanded(Path(file), tuple((x, value) for x, _, value in pairs))
        return text

    def _expanded(self, path: Path, given: tuple[tuple[str, str], ...]) -> tuple[str | None, str]:
        from .xacro import expand, find_xacro, remedy

        if not self._allows(path):
            return None, f"`{path.name}` is neither in the project nor installed"
        boundary = find_boundary(path.absolute().parent)
        if not boundary.is_trusted:
            return None, f"the macros of `{path.name}` are not expanded: {boundary.remedy}"
        modules = find_xacro(self._environ)
        if modules is None:
            return None, f"the package `xacro` is not installed: {remedy(self._environ)}"
        try:
            text = read_regular(path, MOST_BYTES)
        except OSError as error:
            return None, f"`{path.name}` cannot be read: {reason(error)}"
        path = path.absolute()
        reach = find_reach(boundary, path, self._environ)
        expanded = expand(path, text, reach, modules, given)
        if expanded.text is None:
            return None, f"the macros of `{path.name}` are not expanded: {expanded.reason}"
        return expanded.text.decode("utf-8", "replace"), ""
