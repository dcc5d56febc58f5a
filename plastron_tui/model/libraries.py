"""What a program has to know of a client library that it names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple


class ClientLibrary(NamedTuple):
    """A client library.

    Attributes:
        name: its name, as programs write it.
        ros_version: the generation of ROS that it is for, 1 or 2.
        language: the language of its nodes, as people call it.
        is_keyword: tells whether a word is reserved in that language.
        is_built: whether a package has to build its nodes before they can be started.
        is_loaded: whether another process loads its nodes: nodelets, components.
        purpose: what its nodes are and when to take it, in a phrase; "" where nobody says it.
        built_with: the packages without which its nodes cannot be built and started.
    """

    name: str
    ros_version: int
    language: str
    is_keyword: Callable[[str], bool]
    is_built: bool = False
    is_loaded: bool = False
    purpose: str = ""
    built_with: tuple[str, ...] = ()


Libraries = Mapping[str, ClientLibrary]
"""Client libraries by name; the first of a ROS is its default."""


def default_library(libraries: Libraries, ros_version: int) -> str:
    """Return the client library of a generation of ROS where nobody names one."""
    return next(each.name for each in libraries.values() if each.ros_version == ros_version)
