"""The variables of what statements make."""

from __future__ import annotations

from pathlib import PurePath

from plastron_tui.language import SlotKind
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.ros.names import mended_node_name

from .ask import Ask
from .form import is_variable
from .kind import Kind

_NAMES = (
    SlotKind.NODE_NAME,
    SlotKind.NODE_OF_FILE,
    SlotKind.PACKAGE_NAME,
    SlotKind.LAUNCH_NAME,
    SlotKind.ROBOT_NAME,
)
"""The slots whose text is a name that the variable has as well."""

_PATHS = (
    *(SlotKind.FILE, SlotKind.TYPE_FILE, SlotKind.PACKAGE_FOLDER, SlotKind.LAUNCH_FILE),
    SlotKind.ROBOT_FILE,
)

_WORDS = {
    SlotKind.NEW_NODE: "node",
    SlotKind.NEW_MESSAGE: "message",
    SlotKind.NEW_TYPE: "MyType",
    SlotKind.NEW_PACKAGE: "package",
    SlotKind.NEW_LAUNCH: "bringup",
    SlotKind.NEW_ROBOT: "robot",
}
"""What it is called where nothing says it."""

_SUFFIXES = {
    SlotKind.NEW_PACKAGE: "package",
    SlotKind.NEW_LAUNCH: "launch",
    SlotKind.NEW_ROBOT: "robot",
}
"""What is put behind a name that is taken; behind others comes a number."""


class NewVariableKind(Kind):
    """The variable of something that the statement makes."""

    def suggest(self, ask: Ask) -> str:
        """Return what fits the rest of the form and of the program."""
        name = next((text for kind in _NAMES if (text := ask.text(kind))), "")
        name = name or PurePath(ask.text(*_PATHS)).name.partition(".")[0]
        if not name and ask.form.parent is not None:
            topic = ask.parent_text(SlotKind.TOPIC).strip("~/").rpartition("/")[2]
            name = f"{topic}_message" if topic else ""
        wanted = mended_node_name(name, 1) or name
        if not is_variable(wanted):
            wanted = _WORDS[ask.slot.kind]
        # What several nodes send on one topic is told apart by who sends it.
        if ask.form.parent is not None and wanted in ask.scene.taken and ask.node:
            wanted = f"{ask.node}_{wanted}"
        if wanted in ask.scene.taken and ask.slot.kind in _SUFFIXES:
            wanted = f"{wanted}_{_SUFFIXES[ask.slot.kind]}"
        return ask.scene.free(f"{wanted}_node" if wanted in KEYWORDS else wanted)

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "it needs a name by which the program can speak of it"
        if not text[0].isascii() or not text[0].isalpha():
            return "a variable starts with a letter"
        if not is_variable(text):
            return "a variable has letters, digits and `_`, and no space"
        if text in KEYWORDS:
            return f"`{text}` is a word of the language: choose another one"
        known = ask.scene.workspace.what(text)
        if known is not None:
            return f"a {known[0]} is called `{text}` already: choose another name"
        return None
