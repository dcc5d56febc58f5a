"""What a package depends on: the rosdep keys of modules, and the licenses that have a name.

The tables are `data/rosdep_keys.yaml` and `data/licenses.yaml`, which name their sources.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from functools import cache
from pathlib import Path
from string import ascii_letters, digits
from typing import Any

from plastron_tui.diagnostics.suggest import nearest

from .catalog.data import load

PROPRIETARY = "Proprietary"
"""The license of a package that nobody else may use, as packages of ROS write it."""

_OWN_LICENSE = "LicenseRef-"
_OWN_LICENSE_LETTERS = frozenset(f"{ascii_letters}{digits}-.")
_DATA = Path(__file__).parent / "data"


@cache
def licenses() -> Mapping[str, str]:
    """Return the full names of the licenses that a package can have, by SPDX identifier."""
    table: Mapping[str, str] = _table("licenses.yaml")
    return table


def find_license(written: str) -> str | None:
    """Return the SPDX identifier that is written, in its own spelling; None where it is none.

    SPDX identifiers are compared without regard to capitals (SPDX specification, annex on license
    expressions).
    """
    return next((each for each in licenses() if each.lower() == written.lower()), None)


def find_own_license(written: str) -> str | None:
    """Return what stands for a license that is not in the SPDX list; None where it does not.

    REP 149 wants a license named, whatever it is: closed packages say `Proprietary`. A text of
    one's own is a `LicenseRef-NAME` (SPDX specification, annex on license expressions).
    """
    if written.lower() == PROPRIETARY.lower():
        return PROPRIETARY
    name = written.removeprefix(_OWN_LICENSE)
    is_named = name != written and name and not set(name) - _OWN_LICENSE_LETTERS
    return written if is_named else None


def license_help(written: str) -> tuple[str, str | None]:
    """Return how to write a license that is unknown, and what is probably meant, if anything."""
    if written.startswith(_OWN_LICENSE):
        return f"behind `{_OWN_LICENSE}` stand letters, digits, `-` and dots", None
    right = nearest(written, [*licenses(), PROPRIETARY])
    if right is not None:
        return f"did you mean `{right}`?", right
    return f'closed code is "{PROPRIETARY}", a license of your own "{_OWN_LICENSE}NAME"', None


def key_of_module(module: str, ros_version: int, packages: Container[str]) -> str | None:
    """Return the ROS package or rosdep key that brings a module, None where that is not known.

    Args:
        module: the module's full name, such as `std_msgs.msg`.
        ros_version: the generation of ROS, 1 or 2.
        packages: the packages with interface types that are known.
    """
    table = _table("rosdep_keys.yaml")
    name = module
    while name:
        key: str | None = table["ros"][ros_version].get(name) or table["system"].get(name)
        if key is not None or name in packages:
            return key or name
        name = name.rpartition(".")[0]
    return None


def key_of_header(header: str, ros_version: int, packages: Container[str]) -> str | None:
    """Return the ROS package or rosdep key that brings a header, None where that is not known.

    Args:
        header: the header's path as it is included, such as `std_msgs/msg/string.hpp`.
        ros_version: the generation of ROS, 1 or 2.
        packages: the packages with interface types that are known.
    """
    table = _table("header_keys.yaml")
    folder = header.partition("/")[0]
    for name in (header, folder):
        key: str | None = table["ros"][ros_version].get(name) or table["system"].get(name)
        if key is not None:
            return key
    return folder if folder in packages or folder in table["packages"][ros_version] else None


def package_of_module(module: str, ros_version: int, packages: Container[str]) -> str | None:
    """Return the package of ROS that a module is of, None where that is not known.

    Args:
        module: the module's full name, such as `std_msgs.msg`.
        ros_version: the generation of ROS, 1 or 2.
        packages: further packages that are known, with a module of their name.
    """
    name = module.partition(".")[0]
    key = _table("rosdep_keys.yaml")["ros"][ros_version].get(name)
    return name if name in packages or key == name else None


def package_of_header(header: str, ros_version: int, packages: Container[str]) -> str | None:
    """Return the package of ROS that a header is of, None where that is not known.

    Args:
        header: the header's path as it is included, such as `std_msgs/msg/string.hpp`.
        ros_version: the generation of ROS, 1 or 2.
        packages: further packages that are known, with headers in a folder of their name.
    """
    name = header.partition("/")[0]
    own = _table("header_keys.yaml")["packages"][ros_version]
    return name if name in packages or name in own else None


def is_ros_package(key: str, ros_version: int, packages: Container[str]) -> bool:
    """Tell whether what a header is of is a package of ROS, which CMake finds by its name."""
    table = _table("header_keys.yaml")
    named = (*table["packages"][ros_version], *table["ros"][ros_version].values())
    return key in packages or key in named


@cache
def _table(name: str) -> Any:
    return load(_DATA / name)
