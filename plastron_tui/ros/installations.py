"""Which ROS is sourced, and which are installed: folders are looked at, and nothing is started.

That is enough to say which ROS a program is for. With what its nodes can be run,
`runtime.environment` finds out: it asks each Python.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from enum import Enum
from functools import cache
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from typing import NamedTuple

from .catalog.distributions import DISTRIBUTIONS, stand_in, version_of_distribution

# The first number of rclpy's version tells the distribution (the release files of rosdistro).
_DISTRIBUTION_OF_RCLPY = {"3": "humble", "4": "iron", "7": "jazzy", "9": "kilted", "10": "lyrical"}

_DEBIAN_PACKAGES = "usr/lib/python3/dist-packages"


class Origin(str, Enum):
    """Where a ROS comes from, as a person says it, in the order in which they are preferred."""

    SOURCED = "sourced"
    EXTRA = "from the Python packages"
    DEBIAN = "Debian's"
    UNSOURCED = "in /opt/ros, not sourced"


class Installation(NamedTuple):
    """A ROS on this machine.

    Attributes:
        origin: where it comes from.
        ros_version: 1 or 2.
        distribution: its name (`kilted`, `noetic`), "" where nothing tells.
    """

    origin: Origin
    ros_version: int
    distribution: str

    @property
    def name(self) -> str:
        """What it is called: `ROS 2 kilted`."""
        return f"ROS {self.ros_version} {self.distribution}".rstrip()

    @property
    def words(self) -> str:
        """What it is, for a person: `ROS 2 kilted (from the Python packages)`."""
        return f"{self.name} ({self.origin.value})"


def present(environ: Mapping[str, str] = os.environ) -> Iterator[Installation]:
    """Yield the ROS that is sourced, then those that are installed, the preferred one first."""
    version = sourced_version(environ)
    if version is not None:
        yield Installation(Origin.SOURCED, version, _distribution(environ))
    yield from installed()


def sourced_version(environ: Mapping[str, str]) -> int | None:
    """Return the version of a sourced ROS; its setup files set these variables."""
    version = environ.get("ROS_VERSION", "").strip()
    if version in ("1", "2"):
        return int(version)
    if environ.get("AMENT_PREFIX_PATH"):
        return 2
    if environ.get("ROS_PACKAGE_PATH"):
        return 1
    distribution = _distribution(environ)
    return version_of_distribution(distribution) if distribution else None


def _distribution(environ: Mapping[str, str]) -> str:
    return environ.get("ROS_DISTRO", "").strip().lower()


@cache
def installed() -> tuple[Installation, ...]:
    """Return the ROS that are installed on this machine; it is looked at once a process."""
    return tuple(installed_in(Path("/"), sys.path, Path(sys.prefix)))


def installed_in(root: Path, packages: Sequence[str], prefix: Path) -> Iterator[Installation]:
    """Yield the ROS that are installed in folders: what runs as it is, then what is to be sourced.

    Args:
        root: the root of the file system.
        packages: the folders of a Python's packages, as in `sys.path`.
        prefix: the folder that this Python is installed in.
    """
    rclpy = _rclpy_version(packages)
    if rclpy is not None and _has_middleware(prefix):
        yield Installation(Origin.EXTRA, 2, distribution_of_rclpy(rclpy))
    if (root / _DEBIAN_PACKAGES / "rospy").is_dir():
        yield Installation(Origin.DEBIAN, 1, "noetic")
    names = (name for name in _names(root / "opt" / "ros") if setup_file(name, root).is_file())
    to_source = [
        Installation(Origin.UNSOURCED, version_of_distribution(name), name) for name in names
    ]
    yield from sorted(to_source, key=_age)


def distribution_of_rclpy(version: str) -> str:
    """Return the distribution that a version of rclpy belongs to, "" where none is known."""
    return _DISTRIBUTION_OF_RCLPY.get(version.partition(".")[0], "")


def rclpy_of_distribution(distribution: str) -> str:
    """Return the first number of a distribution's version of rclpy, "" where none is known."""
    numbers = (each for each, name in _DISTRIBUTION_OF_RCLPY.items() if name == distribution)
    return next(numbers, "")


def setup_file(distribution: str, root: Path = Path("/")) -> Path:
    """Return the file that one sources for a distribution in /opt/ros."""
    return root / "opt" / "ros" / distribution / "setup.bash"


def _age(installation: Installation) -> int:
    """Tell how many distributions of the catalog are newer; all of ROS 2 are newer than ROS 1."""
    nearest = stand_in(installation.distribution, installation.ros_version)
    return -list(DISTRIBUTIONS).index(nearest)


def _rclpy_version(packages: Sequence[str]) -> str | None:
    """Return the version of the rclpy that Python would import, None where it could not."""
    for folder in filter(None, packages):
        package = Path(folder, "rclpy")
        if not package.is_dir():
            continue
        if not any((package / f"_rclpy_pybind11{each}").exists() for each in EXTENSION_SUFFIXES):
            return None
        named = (name for name in _names(Path(folder)) if name.startswith("rclpy-"))
        return next(named, "").removeprefix("rclpy-")
    return None


def _has_middleware(prefix: Path) -> bool:
    listed = _names(prefix / "share" / "ament_index" / "resource_index" / "rmw_typesupport")
    return any(name != "rmw_implementation" for name in listed)


def _names(folder: Path) -> list[str]:
    with suppress(OSError):
        return [entry.name for entry in folder.iterdir()]
    return []
