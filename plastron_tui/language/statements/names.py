"""The statement about names."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement


@statement(
    "rename_statement",
    "{node} renames {what} {old} to {new}",
    summary="Give something of a node another name.",
    example="driver renames topic 'scan' to 'front/scan'",
    purpose="use another topic, or rename something",
    ros_term="name",
    about="Nodes meet by names; everything else about what is renamed stays as it is.",
)
class Rename(Statement):
    """Give something of a node another name."""

    node: str = slot(SlotKind.NODE, "the node whose name for it changes")
    what: str = slot(SlotKind.NAMED, "what has the name")
    old: str = slot(SlotKind.OLD_NAME, "the name that it has")
    new: str = slot(SlotKind.NEW_NAME, "the name that it gets")
