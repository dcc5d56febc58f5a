"""What was read of a package that exists."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True, slots=True)
class PackageSource:
    """The files of a package that it is made of.

    Attributes:
        folder: where it is.
        name: what its package.xml calls it.
        ros_version: the generation of ROS that it is for.
        build_type: `catkin`, `ament_python`, `ament_cmake`, …, as its package.xml says.
        texts: its package.xml, CMakeLists.txt, setup.py and the like, by their names.
        executables: what it installs for people to start, each with its file where that is known.
        launches: the names of its launch files.
    """

    folder: Path
    name: str
    ros_version: int
    build_type: str
    texts: dict[str, bytes] = field(default_factory=dict)
    executables: dict[str, Path | None] = field(default_factory=dict)
    launches: tuple[str, ...] = ()
