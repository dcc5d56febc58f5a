"""Packages: what holds nodes, launch files and types, and what a workspace builds."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span

from .robots import Robot

if TYPE_CHECKING:
    from .launches import Launch
    from .package_source import PackageSource
    from .workspace import Node


class Contained(NamedTuple):
    """Something that a package contains.

    Attributes:
        item: the node, the launch file or the robot.
        executable: what one starts a node by, None for its own name.
        span: the statement that put it there.
    """

    item: Node | Launch | Robot
    executable: str | None
    span: Span

    @property
    def name(self) -> str:
        """What one starts it by."""
        own = self.item.stem if isinstance(self.item, Robot) else self.item.name
        return self.executable or own


SCRIPTS_FOLDER = "scripts"
"""The folder of the nodes that a package installs as they are, where it builds others."""


BUILT_FOLDER = "src"
"""The folder of the nodes that a package builds."""


def nodes_folder(package: str) -> str:
    """Return where the nodes of a ROS 2 package are that builds its own types too.

    rosidl_generator_py makes the Python module of the package's name, with the types in it.
    """
    return f"{package}_nodes"


@dataclass(slots=True)
class Package:
    """A package, as the program has it so far.

    Attributes:
        name: its name.
        variable: the program's variable for it.
        span: the statement that created or loaded it.
        description: what is in it, "" where the program does not say.
        maintainer: who looks after it, as `Name <mail>`, "" where the program does not say.
        license: the SPDX name of its license, "" where the program does not say.
        source: the files that a loaded package came from, None for one that was created.
        contents: what the program put into it, by variable, in that order.
        removed: what the program took out of it that it did not put there, by executable.
        removed_launches: the launch files that it took out likewise, by their paths.
    """

    name: str
    variable: str
    span: Span
    description: str = ""
    maintainer: str = ""
    license: str = ""
    source: PackageSource | None = None
    contents: dict[str, Contained] = field(default_factory=dict)
    removed: dict[str, Span] = field(default_factory=dict)
    removed_launches: dict[str, Span] = field(default_factory=dict)

    def snapshot(self) -> Package:
        """Return the package as it is now, untouched by what later statements do to it."""
        return replace(
            self,
            contents=dict(self.contents),
            removed=dict(self.removed),
            removed_launches=dict(self.removed_launches),
        )


class PackageGeneration(NamedTuple):
    """A `generate_package`: the package as it was then."""

    package: Package
    span: Span
