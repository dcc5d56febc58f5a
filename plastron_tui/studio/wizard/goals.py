"""What somebody may want, from the declarations: the menu that the wizard begins with."""

from __future__ import annotations

from enum import Enum
from functools import lru_cache
from typing import NamedTuple

from plastron_tui.language import DECLARATIONS, Declaration, SlotKind, Statement
from plastron_tui.language import statements as st


class Aim(Enum):
    """What a statement is wanted for, in the order of the menu."""

    NODE = "a node that does not exist yet"
    MORE = "what a node does"
    CHANGE = "a node that exists as a file"
    MESSAGE = "a message"
    TYPE = "a type of one's own"
    PACKAGE = "a package"
    LAUNCH = "a launch file"
    ROBOT = "a robot"
    WRITE = "files"


class Group(NamedTuple):
    """A menu of its own, and the entry that leads to it.

    Attributes:
        title: what one wants.
        term: what ROS calls it.
        about: a sentence about it.
        question: the title of the menu.
    """

    title: str
    term: str
    about: str
    question: str


GROUPS = {
    Aim.MORE: Group(
        "give a node something more to do",
        "",
        "Let it send, listen, ask, answer, and more; or let it do so no longer.",
        "What shall it do?",
    ),
    Aim.TYPE: Group(
        "make a type of message, service or action",
        "interface definition",
        "Where no type has the fields that you need, you make one that has.",
        "What about types?",
    ),
    Aim.PACKAGE: Group(
        "make it a package",
        "package",
        "A folder for a robot's workspace, with the nodes and all that they need.",
        "What about packages?",
    ),
    Aim.LAUNCH: Group(
        "start several nodes together",
        "launch file",
        "A launch file starts nodes, each with its names and parameters.",
        "What about launch files?",
    ),
    Aim.ROBOT: Group(
        "describe a robot",
        "robot description (URDF)",
        "What it is made of, and how its parts move.",
        "What about robots?",
    ),
}
"""The aims that have a menu of their own."""

DRIVE = (
    "drive until something is near",
    "subscriber and publisher",
    "Goes ahead as long as a laser says that nothing is near, and otherwise stops. "
    "It does not notice when the laser falls silent.",
)
"""The entry that drives a robot by its laser: its words, the word of ROS, a sentence."""

_ABOUT_TYPES = frozenset({SlotKind.TYPE_NAME, SlotKind.NEW_TYPE, SlotKind.OWN_TYPE})
_ABOUT_PACKAGES = frozenset({SlotKind.NEW_PACKAGE, SlotKind.PACKAGE})
_ABOUT_ROBOTS = frozenset({SlotKind.NEW_ROBOT, SlotKind.ROBOT})
_ABOUT_LAUNCHES = frozenset({SlotKind.NEW_LAUNCH, SlotKind.LAUNCH})


def aim_of(declaration: Declaration) -> Aim:
    """Tell what a statement is wanted for, by what it makes or writes."""
    kinds = {slot.kind for slot in declaration.slots}
    if kinds & _ABOUT_TYPES:
        return Aim.TYPE
    if kinds & _ABOUT_PACKAGES:
        return Aim.PACKAGE
    if kinds & _ABOUT_ROBOTS:
        return Aim.ROBOT
    if kinds & _ABOUT_LAUNCHES:
        return Aim.LAUNCH
    if declaration.writes_file:
        return Aim.WRITE
    if SlotKind.FILE in kinds:
        return Aim.CHANGE
    if SlotKind.NEW_NODE in kinds:
        return Aim.NODE
    if SlotKind.NEW_MESSAGE in kinds:
        return Aim.MESSAGE
    return Aim.MORE


def told(declaration: Declaration) -> str:
    """Return what a statement is in one sentence; its help has the rest."""
    return declaration.about.partition(". ")[0].removesuffix(".") + "."


def declarations_of(aim: Aim) -> tuple[Declaration, ...]:
    """Return the statements of an aim.

    What makes sense where there is nothing else yet, to send a message, comes first; what takes
    something back comes last.
    """
    return _sorted(aim, tuple(DECLARATIONS))


# It is asked for each candidate of each slot.
@lru_cache(maxsize=len(Aim))
def _sorted(aim: Aim, types: tuple[type[Statement], ...]) -> tuple[Declaration, ...]:
    found = [declaration for each in types if aim_of(declaration := DECLARATIONS[each]) is aim]
    return tuple(sorted(found, key=_rank))


def _rank(declaration: Declaration) -> tuple[bool, bool]:
    sends = any(slot.kind is SlotKind.MESSAGE for slot in declaration.slots)
    return declaration.undoes is not None, not sends


def maker_of(kind: SlotKind) -> Declaration | None:
    """Return the statement that makes, from nothing, what fills a kind of slot."""
    if kind is SlotKind.LINK:
        return DECLARATIONS[st.HasLink]
    if kind is SlotKind.TRIGGER:
        return DECLARATIONS[st.Subscribe]
    for declaration in DECLARATIONS.values():
        kinds = [slot.kind for slot in declaration.slots]
        if SlotKind.FILE not in kinds and any(each.makes is kind for each in kinds):
            return declaration
    return None


def generating() -> Declaration | None:
    """Return the statement that writes a node to its file."""
    return next((each for each in declarations_of(Aim.WRITE)), None)


def answering() -> Declaration:
    """Return the statement that sends something for each message that arrives."""
    return next(
        each
        for each in DECLARATIONS.values()
        if any(slot.kind is SlotKind.TRIGGER for slot in each.slots)
    )
