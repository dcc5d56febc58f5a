"""Renaming a variable, a topic or a service everywhere in a program."""

from __future__ import annotations

from plastron_tui.diagnostics import Edit
from plastron_tui.language import DECLARATIONS, Program, SlotKind
from plastron_tui.ros.names import check_service_name, check_topic_name, resolved_name
from plastron_tui.session import Session
from plastron_tui.targets import LIBRARIES

from .editor.names import wrong_name as wrong_variable
from .panels.entry import Subject

_TOPICS = (Subject.TOPIC, Subject.PUBLISHER, Subject.SUBSCRIPTION)


def _kinds(subject: Subject) -> tuple[SlotKind, ...]:
    if subject is Subject.MESSAGE:
        return tuple(kind for kind in SlotKind if kind.is_variable)
    return (SlotKind.TOPIC,) if subject in _TOPICS else (SlotKind.SERVICE,)


def renamed(
    program: Program, subject: Subject, old: str, new: str, node: str | None = None
) -> list[Edit]:
    """Return the edits that give something another name, wherever statements write it.

    A topic or a service is found by its full name, and by its name as it is written.
    """
    kinds = _kinds(subject)
    same = {old, old.lstrip("/"), resolved_name(node or "", old)}
    edits = []
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind not in kinds:
                continue
            written = getattr(statement, slot.name)
            if subject is Subject.MESSAGE:
                if written == old:
                    edits.append(Edit(statement.span_of(slot.name), new))
            elif written in same:
                edits.append(Edit(statement.span_of(slot.name), f"'{new}'"))
    return edits


def wrong_name(subject: Subject, new: str, session: Session) -> str | None:
    """Return why something cannot have a name, None when it can."""
    if subject is Subject.MESSAGE:
        return wrong_variable(session.document, new)
    version = LIBRARIES.get(session.library, 1)
    check = check_topic_name if subject in _TOPICS else check_service_name
    problem = check(new, version)
    return None if problem is None else problem.message
