"""A panel of entries that can be acted on."""

from __future__ import annotations

from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message

from .entry import Entry, Subject
from .entry_list import EntryList

_NODE_PARTS = (
    Subject.NODE,
    Subject.PUBLISHER,
    Subject.SUBSCRIPTION,
    Subject.SERVICE,
    Subject.CLIENT,
)


class ProgramPanel(EntryList):
    """Entries of a program, with what can be done about them: each becomes a statement."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding(
            "delete,d", "ask('end')", "Stop it", id="panel.end",
            tooltip="Write the statement that ends it: unsubscribe, stop_publishing, …",
        ),
        Binding(
            "f2,r", "ask('rename')", "Rename", id="panel.rename",
            tooltip="Give it another name, everywhere",
        ),
        Binding(
            "g", "ask('generate')", "Generate", id="panel.generate",
            tooltip="Write the `generate_node` of its node",
        ),
        Binding(
            "f,alt+enter", "ask('fix')", "Mend", id="panel.fix",
            tooltip="Apply the remedy",
        ),
    ]  # fmt: skip

    class Asked(Message):
        """Something shall be done about an entry."""

        def __init__(self, what: str, entry: Entry) -> None:
            super().__init__()
            self.what = what
            self.entry = entry

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Offer what can be done about the entry under the cursor."""
        if action != "ask":
            return True
        entry = self.current
        if entry is None:
            return False
        match parameters[0]:
            case "end":
                return entry.statement is not None
            case "rename":
                return entry.subject in (*_NODE_PARTS, Subject.TOPIC, Subject.SERVICE_NAME,
                                         Subject.MESSAGE)  # fmt: skip
            case "generate":
                return entry.subject in _NODE_PARTS
            case _:
                return bool(entry.edits)

    def watch_index(self, old: int, new: int) -> None:
        """Offer other actions with another entry."""
        super().watch_index(old, new)
        if self.has_focus:
            self.refresh_bindings()

    def action_ask(self, what: str) -> None:
        """Ask for something to be done."""
        if self.current is not None:
            self.post_message(self.Asked(what, self.current))
