"""Choices that are tried out: which of them work, and why others do not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from .ask import Ask, Trial

MOST_TRIALS = 12
"""So many choices are tried out before they are offered; the rest is checked when it is taken."""


def trials(ask: Ask, names: Sequence[str]) -> Iterator[tuple[str, Trial]]:
    """Yield choices for a slot, each with what comes of it; some of them more than once.

    Where a mistake in another slot spoils them all, they are tried once more without that: what
    is suggested stays the same while somebody is still writing elsewhere.
    """
    without: frozenset[str] = frozenset()
    while True:
        tried: dict[str, Trial] = {}
        for name in names[:MOST_TRIALS]:
            tried[name] = ask.try_out(name, without)
            yield name, tried[name]
        spoilt = _spoilt_by(ask, tried)
        if not spoilt or spoilt in without:
            return
        without |= {spoilt}


def first_that_works(ask: Ask, names: Sequence[str]) -> str | None:
    """Return the first choice that works, None where none does."""
    return next((name for name, trial in trials(ask, names) if trial.reason is None), None)


def closed_by(ask: Ask, names: Sequence[str]) -> dict[str, str]:
    """Return why some of the choices for a slot cannot be taken."""
    tried = dict(trials(ask, names))
    return {name: each.reason for name, each in tried.items() if each.reason is not None}


def _spoilt_by(ask: Ask, tried: Mapping[str, Trial]) -> str:
    """Return the other slot in which what was entered is wrong whatever is taken, or ""."""
    common = {(each.reason, each.slot) for each in tried.values()}
    if len(common) != 1:
        return ""
    ((reason, slot),) = common
    is_entered = slot != ask.slot.name and ask.form.has_entered(slot)
    if reason is None or not is_entered or any(f"`{name}`" in reason for name in tried):
        return ""
    return slot
