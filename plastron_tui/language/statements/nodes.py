"""The statements that nodes come from."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from .shared import LIBRARY_HELP

NAME_HELP = "what the node is called in the ROS graph"
MANAGED_HELP = "configured, activated and stopped from outside (ROS 2)"


@statement(
    "create_node_statement",
    "create_node {name} as {variable} [{managed}] [using {library}]",
    summary="Make a new node.",
    example="create_node 'talker' as talker",
    purpose="make a node",
    ros_term="node",
    about="A node is a program of its own that does one thing; a robot runs many.",
)
class CreateNode(Statement):
    """Make a new node."""

    name: str = slot(SlotKind.NODE_NAME, NAME_HELP)
    variable: str = slot(SlotKind.NEW_NODE, "what the program calls the node")
    managed: bool = slot(SlotKind.MANAGED, MANAGED_HELP)
    library: str | None = slot(SlotKind.LIBRARY, LIBRARY_HELP)


@statement(
    "load_statement",
    "load {source} [node {name}] as {variable}",
    summary="Read a node from a source file, to change it.",
    example="load 'scripts/driver.py' as driver",
    purpose="change a node file that exists",
    ros_term="node file",
    about="Only what you ask for changes; the result goes to the output folder.",
)
class Load(Statement):
    """Read a node from a source file."""

    source: str = slot(
        SlotKind.FILE,
        "a file in the output folder by its name, or a path from the program's folder",
    )
    name: str | None = slot(
        SlotKind.NODE_OF_FILE,
        "which node, where the file holds several: the name that it has there",
    )
    variable: str = slot(SlotKind.NEW_NODE, "what the program calls the node")

    @property
    def is_path(self) -> bool:
        """Whether the file is given as a path in quotes, not as a bare name."""
        child = self.syntax.child_by_field_name("source")
        return child is not None and child.type == "path"
