"""Renaming the links and joints of a robot, everywhere in a program."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from plastron_tui.diagnostics import Edit
from plastron_tui.language import DECLARATIONS, Program, SlotKind
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.names import NAME_RULE, is_name

from .panels.entry import Entry, Subject

PARTS = {
    Subject.LINK: frozenset({SlotKind.LINK}),
    Subject.JOINT: frozenset({SlotKind.JOINT, SlotKind.FOLLOWED}),
}
"""The parts of a robot, and the slots that name one."""


def part_edits(program: Program, entry: Entry, old: str, new: str) -> Iterator[Edit]:
    """Yield what gives a link or a joint another name in all statements about its robot."""
    kinds = PARTS[Subject(entry.subject)]
    for statement in program.statements:
        if getattr(statement, "robot", None) != entry.robot:
            continue
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind in kinds and getattr(statement, slot.name) == old:
                yield Edit(statement.span_of(slot.name), f"'{new}'")


def file_of_part(workspace: Workspace, entry: Entry) -> str | None:
    """Return the file that gives a part its name, None where the program does."""
    robot = workspace.robots.get(entry.robot or "")
    if robot is None or robot.source is None:
        return None
    there = parts_of(robot.source.description, entry)
    return robot.source.path.name if entry.text in there else None


def wrong_part_name(workspace: Workspace, entry: Entry, new: str) -> str | None:
    """Return why a link or a joint cannot have a name, None when it can."""
    robot = workspace.robots.get(entry.robot or "")
    if robot is not None and new in parts_of(robot.description, entry):
        return f"the robot has a {entry.subject.word} `{new}` already"
    return wrong_robot_name(new)


def parts_of(description: Description, entry: Entry) -> Collection[str]:
    """Return the names of all parts of a robot that are of an entry's kind."""
    return description.links if entry.subject is Subject.LINK else description.joints


def wrong_robot_name(new: str) -> str | None:
    """Return why nothing of a robot can have a name, None when it can."""
    return None if is_name(new) else NAME_RULE
