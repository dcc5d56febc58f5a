"""Robots, as programs describe them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.macros import Macros

if TYPE_CHECKING:
    from .source import TextOrigin


class RobotSource(NamedTuple):
    """A robot's file.

    Attributes:
        path: where it is.
        text: what the program starts from: what the file holds, without what it wrote itself.
        description: what that text says.
        origin: where the text comes from if it is not simply what the file holds.
        expanded: what the file's macros make of it, None for a file without macros, or where they
            are not expanded; then it is only looked at.
        macros: what the file leaves to macros, None for a file without them. A file with macros
            may have links and joints besides those of its description.
    """

    path: Path
    text: bytes
    description: Description
    origin: TextOrigin | None = None
    expanded: Description | None = None
    macros: Macros | None = None

    @property
    def present(self) -> bytes:
        """What the file holds."""
        return self.text if self.origin is None else self.origin.present


class LoadedRobot(NamedTuple):
    """What a reader made of the path of a robot's file; None with the reason."""

    source: RobotSource | None
    diagnostics: tuple[Diagnostic, ...] = ()


RobotReader = Callable[[str], LoadedRobot]


def no_robot(source: str) -> LoadedRobot:
    """Find no robot: where a program has no folder, there is none."""
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program")
    return LoadedRobot(None, (found,))


class Places(NamedTuple):
    """The statements that say something of a robot's part, the last of each.

    Attributes:
        made: the one that made it, None for what a file has.
        changed: the one that changed it last.
        limited: the one that limits it, of a joint.
    """

    made: Span | None = None
    changed: Span | None = None
    limited: Span | None = None


@dataclass(slots=True)
class Robot:
    """A robot, as the program has it so far.

    Attributes:
        variable: the program's variable for it.
        span: the statement that created or loaded it.
        description: what it consists of by now. What the program changes in a loaded one is what
            differs from the source's.
        source: what a loaded one came from, None for one that was created.
        links: where the program speaks of its links, by name.
        joints: where it speaks of its joints, by name.
        home: the package that the program puts it into, "" for none.
    """

    variable: str
    span: Span
    description: Description
    source: RobotSource | None = None
    links: dict[str, Places] = field(default_factory=dict)
    joints: dict[str, Places] = field(default_factory=dict)
    home: str = ""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.description.name

    @property
    def shown(self) -> Description:
        """What there is to see of it: with its macros expanded, where they are."""
        expanded = None if self.source is None else self.source.expanded
        return self.description if expanded is None else expanded

    @property
    def stem(self) -> str:
        """What its file is called, without its ending."""
        return self.name if self.source is None else file_stem(self.source.path.name)

    def snapshot(self) -> Robot:
        """Return the robot as it is now, untouched by what later statements do to it."""
        return replace(self, links=dict(self.links), joints=dict(self.joints))


def file_stem(name: str) -> str:
    """Return the name of a robot's file without its endings: `rover` of `rover.urdf.xacro`."""
    for ending in (".xml", ".xacro", ".urdf"):
        name = name.removesuffix(ending) or name
    return name


class RobotGeneration(NamedTuple):
    """A `generate_robot`: the robot as it was then."""

    robot: Robot
    span: Span
