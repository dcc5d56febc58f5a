"""What is said about each row of a form."""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.language import Slot, SlotKind
from plastron_tui.language.declaration import Form as Written

from .ask import Ask
from .computed_values import sources_of
from .definition_rows import row_path
from .filling import Filled
from .kinds import unanswered
from .libraries import explained
from .sent_already import sent_already
from .values import Entry, Path

_WORDS = {
    SlotKind.NEW_NODE: "what this text calls the node; it follows the name",
    SlotKind.NODE_NAME: "what other programs see the node by",
    SlotKind.MANAGED: "it waits until another program switches it on (ROS 2)",
    SlotKind.FUNCTION: "the function of the node's code that is called; made for you",
    SlotKind.TRIGGER: "instead of a rate: it is sent when something arrives on this topic",
    SlotKind.CONDITION: "only where this holds of what arrives; without it, each time",
    SlotKind.QOS: "delivery (quality of service): how messages are to arrive; empty is as usual",
}
"""What is said of slots to who meets them for the first time."""

FIELD_HELP = "a type and a name: `float64 left`, `string[] names`, `uint8 OK = 1`"


def helps_of(filled: Filled, ask: Callable[[Slot], Ask]) -> dict[tuple[str, Path | None], str]:
    """Return what is said about the slots of a form, and about the fields of its values."""
    said: dict[tuple[str, Path | None], str] = {}
    for slot in filled.form.declaration.slots:
        said[slot.name, None] = _WORDS.get(slot.kind, slot.help)
        if slot.kind is SlotKind.CONDITION and filled.form.drives:
            said[slot.name, None] = "it drives as long as this holds, and stops where it does not"
        if slot.kind is SlotKind.RATE:
            said[slot.name, None] = _rate(filled, slot)
        if slot.kind is SlotKind.MESSAGE and filled.cells[slot.name].is_new:
            said[slot.name, None] += "; a later page asks what a new one says"
        if slot.kind is SlotKind.TOPIC and (sent := sent_already(filled)):
            said[slot.name, None] += f"; {sent}"
        if slot.kind in (SlotKind.SERVICE, SlotKind.ACTION):
            said[slot.name, None] += unanswered(ask(slot))
        if slot.kind is SlotKind.LIBRARY:
            said[slot.name, None] = explained(ask(slot))
        for number in range(len(filled.rows.get(slot.name, ()))):
            said[slot.name, row_path(slot, number)] = FIELD_HELP
        for part in filled.parts.get(slot.name, ()):
            said[slot.name, part.path] = slot.help
        if slot.kind.form is Written.VALUES and slot.name not in filled.parts:
            sources = sources_of(ask(slot))
            for each in filled.entries:
                if isinstance(each, Entry):
                    known = each.meaning.said if each.meaning is not None else each.comment
                    about = f": {known}" if known else ""
                    # Nobody drives as fast as a laser's angles say.
                    is_driving = filled.form.parent is not None and filled.form.parent[0].drives
                    others = "" if is_driving else sources.example(each)
                    others = f", or {others}" if others else ""
                    said[slot.name, each.path] = f"{each.name} ({each.note}){others}{about}"
    return said


def _rate(filled: Filled, slot: Slot) -> str:
    """Return what is said of how often something is sent, or done."""
    if slot.name not in filled.form.optional:
        return "how many times a second"
    trigger = filled.form.slot_of(SlotKind.TRIGGER)
    arrives = "" if trigger is None else filled.cells[trigger.name].text
    if arrives:
        return (
            f"how many times a second; it needs none, as it is sent for each message of `{arrives}`"
        )
    if filled.form.slot_of(SlotKind.INPUT) is not None:
        return "how many times a second; without it once"
    node = filled.form.slot_of(SlotKind.NODE)
    name = "" if node is None else filled.cells[node.name].text
    found = filled.scene.workspace.nodes.get(name)
    if found is None or found.source is None:
        return "how many times a second; without it 10"
    return "how many times a second; without it as often as the file's loop, or 10"
