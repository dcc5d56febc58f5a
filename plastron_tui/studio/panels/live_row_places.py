"""Where the cursor of the live panel may stand, and which row what is done there is about."""

from __future__ import annotations

from collections.abc import Sequence

from .live_row import Kind, LiveRow


def branch_at(rows: Sequence[LiveRow], at: int) -> int | None:
    """Return the place of a row that can be folded, or of the one that a row belongs to."""
    while 0 < at < len(rows) and rows[at].depth:
        at -= 1
    return at if 0 <= at < len(rows) and rows[at].is_branch else None


def target_at(rows: Sequence[LiveRow], at: int, kind: Kind) -> LiveRow | None:
    """Return the row of a kind at a place: the row there, or the one that it belongs to."""
    while 0 < at < len(rows) and rows[at].kind is not kind and rows[at].depth:
        at -= 1
    return rows[at] if 0 <= at < len(rows) and rows[at].kind is kind else None


def field_of(row: LiveRow | None, topic: LiveRow) -> tuple[str, ...]:
    """Return the names of the field that a row is of a topic, the outermost first; () for none."""
    if row is None or row.kind is not Kind.FIELD or row.owner != topic.owner:
        return ()
    return tuple(row.name.split("."))


def cancelable_at(rows: Sequence[LiveRow], at: int) -> LiveRow | None:
    """Return the row of what is sent again and again, or of a goal that is worked on."""
    topic, action = target_at(rows, at, Kind.TOPIC), target_at(rows, at, Kind.ACTION)
    if topic is not None:
        return topic if topic.is_sent_to else None
    if action is None:
        return None
    # At a goal that is over nothing is left to be canceled.
    chosen = rows[at] if rows[at].kind is Kind.GOAL else action
    return chosen if chosen.goal else None


def cancels_at(rows: Sequence[LiveRow], at: int) -> str:
    """Return what to cancel is called at a row: of a goal it is another thing than of a message."""
    found = cancelable_at(rows, at) if 0 <= at < len(rows) else None
    return "Cancel the goal" if found is not None and found.goal else "Stop sending"


def last_sent_at(rows: Sequence[LiveRow], at: int) -> int:
    """Return the place of the last row with what came of what was sent, below a row; or its own."""
    sent = (Kind.SENDING, Kind.ANSWER, Kind.GOAL)
    while at + 1 < len(rows) and rows[at + 1].kind in sent:
        at += 1
    return at


def stop_near(rows: Sequence[LiveRow], to: int, before: int) -> int:
    """Return the place that the cursor goes to: behind a heading, in the direction it takes."""
    forward = range(to, len(rows))
    back = range(min(to, len(rows) - 1), -1, -1)
    ways = (*forward, *back) if to >= before else (*back, *forward)
    return next((at for at in ways if rows[at].kind is not Kind.HEADING), to)
