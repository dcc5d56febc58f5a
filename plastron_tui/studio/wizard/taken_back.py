"""What a statement takes away from a node again."""

from __future__ import annotations

from plastron_tui.language import SlotKind

from .ask import Ask, Choice


def taken_back(ask: Ask) -> list[Choice]:
    """Return what the node has of the kind that the statement takes away."""
    found = []
    for name in ask.scene.ended_by(ask.node, ask.form.declaration.type):
        tried = ask.try_out(name, frozenset())
        if tried.slot != ask.slot.name:
            found.append(Choice(name, closed=tried.reason or ""))
    return found


def nothing_to_take(ask: Ask) -> str:
    """Tell why there is nothing that the statement could take away."""
    for choice in (each for each in taken_back(ask) if each.closed):
        return f"`{choice.text}` has to stay: {choice.closed}"
    slot = ask.form.slot_of(SlotKind.NODE)
    if slot is None or slot.name not in {**ask.form.entered, **ask.form.given}:
        ended_by, nodes = ask.form.declaration.type, ask.scene.workspace.nodes
        if any(ask.scene.ended_by(each, ended_by) for each in nodes):
            return "all that there is of it is needed, and has to stay"
        return "no node does that, so there is nothing to take away"
    return f"`{ask.node}` does not do that, so there is nothing to take away"
