"""The statement that writes files."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from .shared import LIBRARY_HELP


@statement(
    "generate_node_statement",
    "generate_node {node} [using {library}]",
    summary="Write a node to its source file.",
    example="generate_node talker",
    purpose="write a node to its file",
    ros_term="source file",
    about="The file is Python that you can read, run and go on with by hand.",
    writes_file=True,
)
class GenerateNode(Statement):
    """Write a node to its source file."""

    node: str = slot(SlotKind.NODE, "the node that is written")
    library: str | None = slot(SlotKind.LIBRARY, LIBRARY_HELP)
