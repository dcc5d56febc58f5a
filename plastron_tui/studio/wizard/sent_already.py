"""What the file of a loaded node sends already, for who lets the node send something more."""

from __future__ import annotations

from plastron_tui.diagnostics import listed
from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.model.kinds import Publisher
from plastron_tui.ros.names import spelled

from .filling import Filled


def sent_already(filled: Filled) -> str:
    """Return the sentence that the file sends to other topics already, "" where it does not.

    Of the topic itself a warning says so.
    """
    form = filled.form
    node_slot, topic_slot = form.slot_of(SlotKind.NODE), form.slot_of(SlotKind.TOPIC)
    if form.declaration.type is not st.Publish or node_slot is None or topic_slot is None:
        return ""
    node = filled.base.workspace.nodes.get(filled.cells[node_slot.name].text)
    if node is None or node.source is None:
        return ""
    topic = spelled(filled.cells[topic_slot.name].text)
    # What a statement made has a place in the program.
    sent = [name for name, each in node.of(Publisher).items() if each.span is None]
    if not sent or topic in sent:
        return ""
    names = listed([f"`{name}`" for name in sent])
    return f"{node.source.path.name} sends to {names} already; this is one more"
