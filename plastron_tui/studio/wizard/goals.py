"""What somebody may want, from the declarations: the menu that the wizard begins with."""

from __future__ import annotations

from enum import Enum

from plastron_tui.language import DECLARATIONS, Declaration, SlotKind
from plastron_tui.language import statements as _statements  # noqa: F401 - declares the statements


class Aim(Enum):
    """What a statement is wanted for, in the order of the menu."""

    NODE = "a node that does not exist yet"
    MORE = "what a node does"
    CHANGE = "a node that exists as a file"
    MESSAGE = "a message"
    WRITE = "files"


MORE_TITLE = "give a node something more to do"
MORE_ABOUT = (
    "Let a node of the program send, listen, ask, answer, and more; or let it do so no longer."
)


def aim_of(declaration: Declaration) -> Aim:
    """Tell what a statement is wanted for, by what it makes or writes."""
    if declaration.writes_file:
        return Aim.WRITE
    kinds = {slot.kind for slot in declaration.slots}
    if SlotKind.FILE in kinds:
        return Aim.CHANGE
    if SlotKind.NEW_NODE in kinds:
        return Aim.NODE
    if SlotKind.NEW_MESSAGE in kinds:
        return Aim.MESSAGE
    return Aim.MORE


def declarations_of(aim: Aim) -> list[Declaration]:
    """Return the statements of an aim.

    What makes sense where there is nothing else yet, to send a message, comes first; what takes
    something back comes last.
    """
    found = [each for each in DECLARATIONS.values() if aim_of(each) is aim]
    return sorted(found, key=_rank)


def _rank(declaration: Declaration) -> tuple[bool, bool]:
    sends = any(slot.kind is SlotKind.MESSAGE for slot in declaration.slots)
    return declaration.undoes is not None, not sends


def maker_of(kind: SlotKind) -> Declaration | None:
    """Return the statement that makes, from nothing, what fills a kind of slot."""
    for declaration in DECLARATIONS.values():
        kinds = [slot.kind for slot in declaration.slots]
        if SlotKind.FILE not in kinds and any(each.makes is kind for each in kinds):
            return declaration
    return None


def generating() -> Declaration | None:
    """Return the statement that writes a node to its file."""
    return next((each for each in DECLARATIONS.values() if each.writes_file), None)


def answering() -> Declaration:
    """Return the statement that sends something for each message that arrives."""
    return next(
        each
        for each in DECLARATIONS.values()
        if any(slot.kind is SlotKind.TRIGGER for slot in each.slots)
    )
