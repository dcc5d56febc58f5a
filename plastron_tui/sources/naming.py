"""Names in source code for what a program calls by ROS names, in any language."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from plastron_tui.model.unique_names import numbered

_LONGEST = 40
"""Names that are derived stay short enough for a line to hold them."""

_PLAIN = re.compile(rf"[A-Za-z0-9_/~.\-]{{1,{_LONGEST}}}")


class Scope:
    """The names of one scope, each given once.

    Attributes:
        is_keyword: tells whether a word is reserved in the language.
    """

    def __init__(self, taken: Iterable[str], is_keyword: Callable[[str], bool]) -> None:
        self._taken = set(taken)
        self.is_keyword = is_keyword

    def __contains__(self, name: str) -> bool:
        return name in self._taken

    def add(self, name: str) -> None:
        """Take a name that is given."""
        self._taken.add(name)

    def new(self, wanted: str) -> str:
        """Take an identifier: `wanted`, or the first of `wanted_2`, `wanted_3`, … that is free."""
        free = (each for each in numbered(wanted) if each not in self and not self.is_keyword(each))
        name = next(free)
        self._taken.add(name)
        return name


def words(ros_name: str) -> str:
    """Return a ROS name as an identifier of small letters: `/arm/joint_1` is `arm_joint_1`."""
    text = re.sub(r"[^a-z0-9]+", "_", ros_name.lower()).strip("_")
    if not text or text[0].isdigit():
        text = f"number_{text}" if text else "unnamed"
    return text[:_LONGEST].rstrip("_")


def class_name(node_name: str) -> str:
    """Return the name of a node's class: `arm_driver` becomes `ArmDriverNode`."""
    name = capitals(words(node_name))
    return name if name.endswith("Node") else f"{name}Node"


def capitals(name: str) -> str:
    """Return a snake-case name in capitals: `std_msgs` becomes `StdMsgs`."""
    return "".join(part[:1].upper() + part[1:] for part in name.split("_"))


def label(ros_name: str, otherwise: str) -> str:
    """Return a ROS name as prose and log messages may hold it, or `otherwise`.

    What stands in prose is no literal, so that only a name of plain characters may stand there.
    """
    return ros_name if _PLAIN.fullmatch(ros_name) else otherwise
