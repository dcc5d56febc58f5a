"""The messages of ROS 1 that an action is made of.

Source: `genaction.py` of actionlib_msgs.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

NEEDED = {
    "actionlib_msgs": ("GoalID", "GoalStatus"),
    "std_msgs": ("Header",),
}
"""The messages of other packages that those of each action hold, by package."""

_SEPARATOR = re.compile(r"^---.*$", re.MULTILINE)


def action_messages(name: str, definition: str) -> Iterator[tuple[str, str]]:
    """Yield the name and the definition of each message of an action."""
    parts = zip(("Goal", "Result", "Feedback"), _SEPARATOR.split(definition), strict=True)
    heads = {"Goal": "actionlib_msgs/GoalID goal_id"}
    whole = ""
    for part, text in parts:
        word = part.lower()
        head = heads.get(part, "actionlib_msgs/GoalStatus status")
        yield f"{name}{part}", text.lstrip("\n")
        yield f"{name}Action{part}", f"Header header\n{head}\n{name}{part} {word}\n"
        whole += f"{name}Action{part} action_{word}\n"
    yield f"{name}Action", whole


def needed_messages(distribution: str) -> Iterator[tuple[InterfaceName, str]]:
    """Yield what is in `NEEDED`, with its definition in a distribution."""
    catalog = Catalog(distribution)
    for package, names in NEEDED.items():
        for each in names:
            name = InterfaceName(package, each)
            interface = catalog.find(name, InterfaceKind.MESSAGE)
            assert interface is not None, f"the catalog has {name}"
            yield name, format_definition(interface, catalog.ros_version)
