"""The robots that a program loads: their files, their macros, and their meshes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from plastron_tui.model.robots import Robot

from .mesh_sizes import KnownMeshes, MeshSizes
from .named_texts import NamedTexts
from .robot_expansion import KnownExpansions, RobotExpander, said_by_program
from .robot_reader import RobotReader


@dataclass(slots=True)
class KnownRobots:
    """What was found out about robots' files, for what comes later.

    Attributes:
        expansions: what macros made of files.
        meshes: how large meshes are.
    """

    expansions: KnownExpansions = field(default_factory=dict)
    meshes: KnownMeshes = field(default_factory=KnownMeshes)


class RobotFiles:
    """Reads the files of robots.

    Attributes:
        read: reads a file by its path.
        sizes: measures meshes by their URIs.
    """

    def __init__(
        self,
        texts: NamedTexts,
        environ: Mapping[str, str],
        known: KnownRobots | None = None,
        say: Callable[[str], str] = said_by_program,
    ) -> None:
        """Set where files are looked for.

        Args:
            texts: finds and reads files.
            environ: the environment variables that say which ROS is sourced.
            known: what was found out before.
            say: says how an argument of macros without a value gets one.
        """
        known = known or KnownRobots()
        self.sizes = MeshSizes(texts.folder, texts.boundary, environ, known.meshes, texts.text)
        expander = RobotExpander(texts.boundary, environ, known.expansions, say)
        self.read = RobotReader(texts, expander, self.sizes.add_folder)

    def measure(self, robot: Robot) -> None:
        """Measure the meshes of a robot, for its picture; it may take a second."""
        if robot.source is not None:
            self.sizes.add_folder(robot.source.path.parent)
        robot.meshes = self.sizes.outermost(robot.shown)
