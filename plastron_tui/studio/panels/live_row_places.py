"""Where the cursor of the live panel may stand, and which row what is done there is about."""

from __future__ import annotations

from collections.abc import Sequence

from .live_rows import Kind, LiveRow


def branch_at(rows: Sequence[LiveRow], at: int) -> int | None:
    """Return the place of a row that can be folded, or of the one that a row belongs to."""
    while 0 < at < len(rows) and rows[at].depth:
        at -= 1
    return at if 0 <= at < len(rows) and rows[at].is_branch else None


def target_at(rows: Sequence[LiveRow], at: int, kind: Kind) -> LiveRow | None:
    """Return the row of a kind at a place: the row there, or the one that it belongs to."""
    if not 0 <= at < len(rows) or rows[at].kind is kind:
        return rows[at] if 0 <= at < len(rows) else None
    above = at - 1 if rows[at].kind is Kind.ANSWER else branch_at(rows, at)
    return rows[above] if above is not None and rows[above].kind is kind else None


def stop_near(rows: Sequence[LiveRow], to: int, before: int) -> int:
    """Return the place that the cursor goes to: behind a heading, in the direction it takes."""
    forward = range(to, len(rows))
    back = range(min(to, len(rows) - 1), -1, -1)
    ways = (*forward, *back) if to >= before else (*back, *forward)
    return next((at for at in ways if rows[at].kind is not Kind.HEADING), to)
