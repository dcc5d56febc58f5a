"""What can be done with an entry, wherever it is shown: gone to, or acted on."""

from __future__ import annotations

from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.message import Message
from textual.widget import Widget

from .entry import Entry, Subject

_HUBS = (Subject.TOPIC, Subject.SERVICE_NAME, Subject.ACTION_NAME)
_ROBOT_PARTS = (Subject.ROBOT, Subject.LINK, Subject.JOINT)
_MADE = (Subject.PACKAGE, Subject.LAUNCH, Subject.TYPE, *_ROBOT_PARTS)


class EntryMessage(Message):
    """Something about an entry."""

    def __init__(self, entry: Entry) -> None:
        super().__init__()
        self.entry = entry


class Chosen(EntryMessage):
    """An entry was chosen, by Enter or with the mouse."""


class Lit(EntryMessage):
    """The panel's cursor is on another entry."""


class Asked(EntryMessage):
    """Something shall be done about an entry: `end`, `rename`, `generate`, `fix` or `code`."""

    def __init__(self, what: str, entry: Entry) -> None:
        super().__init__(entry)
        self.what = what


class Pointing(Widget):
    """Has a cursor on an entry: as it moves the program goes along, and Enter goes there."""

    takes_bursts = True
    """Of a text that comes as keys no letter does anything."""

    @property
    def current(self) -> Entry | None:
        """The entry that the cursor is on."""
        return None

    def tell_current(self) -> None:
        """Tell what the cursor is on now."""
        if self.current is not None:
            self.post_message(Lit(self.current))

    def action_choose(self) -> None:
        """Go to the first statement about the entry."""
        if self.current is not None:
            self.post_message(Chosen(self.current))

    def on_focus(self) -> None:
        """Show the cursor."""
        self.refresh()

    def on_blur(self) -> None:
        """Show that the cursor is elsewhere."""
        self.refresh()


def _asking(what: str, keys: str, title: str, tooltip: str) -> Binding:
    return Binding(keys, f"ask('{what}')", title, id=f"panel.{what}", tooltip=tooltip)


class Acting(Pointing):
    """Offers what can be done about the entry under its cursor: each becomes a statement."""

    BINDINGS: ClassVar[list[BindingType]] = [
        _asking("end", "delete,d", "End it",
                "Write the statement that ends it: unsubscribe, stop_publishing, …"),
        _asking("rename", "f2,r", "Rename", "Give it another name, everywhere"),
        _asking("generate", "g", "Generate", "Write the statement that writes it to its files"),
        _asking("fix", "f,alt+enter", "Fix", "Change the text as its help says"),
        _asking("code", "c", "Code", "Show the file that it is in, or becomes, at its line"),
    ]  # fmt: skip

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
                return _has_name(entry)
            case "generate":
                return _is_of_node(entry) or entry.subject in _MADE
            case "code":
                return entry.span is not None or entry.subject is not Subject.OTHER
            case _:
                return bool(entry.edits)

    def action_ask(self, what: str) -> None:
        """Ask for something to be done."""
        if self.current is not None:
            self.post_message(Asked(what, self.current))


def _is_of_node(entry: Entry) -> bool:
    """Tell whether an entry is about a node, or an endpoint of one."""
    return entry.subject is Subject.NODE or not isinstance(entry.subject, Subject)


def _has_name(entry: Entry) -> bool:
    """Tell whether what an entry is about has a name that can be another one."""
    if _is_of_node(entry):
        from plastron_tui.model.kinds import EndpointKind

        return entry.subject is not EndpointKind.TIMER
    return entry.subject in (*_HUBS, Subject.MESSAGE, *_MADE)
