"""Which packages the ROS of this machine has: folders are looked at, and nothing is started."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from .catalog import installed_folders
from .installations import Installation, Origin, present

_EVERYWHERE = "std_msgs"
"""A package that each ROS has: where it is not found, nobody knows where to look."""


class InstalledPackages(NamedTuple):
    """A ROS, and the folders in which its packages are.

    Attributes:
        installation: the ROS.
        folders: a package is in one of them, in a folder of its name.
    """

    installation: Installation
    folders: tuple[Path, ...]

    def has(self, package: str) -> bool:
        """Tell whether a package is installed at this moment."""
        return any(os.path.isdir(folder / package) for folder in self.folders)  # noqa: PTH112 - a name may be too long


def installed_packages(
    ros_version: int,
    environ: Mapping[str, str] = os.environ,
    packages: Sequence[str] = sys.path,
    root: Path = Path("/"),
) -> InstalledPackages | None:
    """Return the ROS that nodes of a generation run with, None where nobody knows its packages.

    Args:
        ros_version: the generation of ROS.
        environ: the environment variables that say which ROS is sourced.
        packages: the folders of this Python's packages, as in `sys.path`.
        root: the root of the file system.
    """
    for each in present(environ):
        if each.ros_version == ros_version and each.origin is not Origin.UNSOURCED:
            folders = tuple(dict.fromkeys(_folders(each, environ, packages, root)))
            found = InstalledPackages(each, folders)
            return found if found.has(_EVERYWHERE) else None
    return None


def _folders(
    installation: Installation, environ: Mapping[str, str], packages: Sequence[str], root: Path
) -> Iterator[Path]:
    if installation.origin is Origin.EXTRA:
        yield from (Path(each) for each in packages if each)
    if installation.origin is Origin.SOURCED:
        yield from installed_folders(environ, installation.ros_version)
        yield from map(Path, filter(None, environ.get("PYTHONPATH", "").split(os.pathsep)))
    if installation.ros_version == 1:
        yield root / "usr/lib/python3/dist-packages"
        yield from (root / "usr/local/lib").glob("python3*/dist-packages")
