"""What a package depends on: the rosdep keys of modules, and the licenses that have a name.

The tables are `data/rosdep_keys.yaml` and `data/licenses.yaml`, which name their sources.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from .catalog.data import load

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


@cache
def _table(name: str) -> Any:
    return load(_DATA / name)
