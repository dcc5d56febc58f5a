"""Small C++ nodes, each in a manner of its own, that endpoints are added to.

A line `=== x.hpp` begins the header of a node; the first text is its source.
"""

from __future__ import annotations

from rclcpp_manners import RCLCPP
from roscpp_manners import ROSCPP

from plastron_tui.model.source import FileSet

__all__ = ["RCLCPP", "ROSCPP", "files"]


def files(text: str) -> FileSet:
    """Return the files of a node."""
    source, *headers = text.removeprefix("\n").split("=== ")
    others = [each.split("\n", 1) for each in headers]
    return FileSet((("{}.cpp", source.encode()), *((n, each.encode()) for n, each in others)))
