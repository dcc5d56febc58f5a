"""The keys of the actions, as terminals without a protocol of their own send them."""

from __future__ import annotations

import pytest
from textual import events
from textual._xterm_parser import XTermParser

from plastron_tui.studio.actions import ACTIONS, Action
from plastron_tui.studio.terminal_keys import teach

# xterm's sequences, which tmux, screen and the terminals of today's desktops send as well.
FUNCTIONS = {
    "f1": "OP", "f2": "OQ", "f3": "OR", "f4": "OS", "f5": "[15~", "f6": "[17~", "f7": "[18~",
    "f8": "[19~", "f9": "[20~", "f10": "[21~", "f12": "[24~", "shift+f5": "[15;2~",
    "shift+f8": "[19;2~", "ctrl+pageup": "[5;5~", "ctrl+pagedown": "[6;5~",
    "alt+up": "[1;3A", "alt+down": "[1;3B",
}  # fmt: skip
SIGNS = {
    "plus": "+", "minus": "-", "equals_sign": "=", "question_mark": "?", "enter": "\r",
    "comma": ",", "full_stop": ".",
}  # fmt: skip
CONTROL = {"space": "\0", "underscore": "\x1f"}
SAME = {"ctrl+space": "ctrl+@"}


def sent(key: str) -> str:
    """Return what a terminal sends for a key."""
    if key in FUNCTIONS:
        return f"\x1b{FUNCTIONS[key]}"
    held, _, name = key.partition("+")
    if held == "ctrl":
        return CONTROL.get(name) or chr(ord(name) & 31)
    assert held == "alt", key
    return f"\x1b{SIGNS.get(name, name)}"


def arrived(sequence: str) -> list[str]:
    teach()
    return [event.key for event in XTermParser().feed(sequence) if isinstance(event, events.Key)]


@pytest.mark.parametrize("action", ACTIONS, ids=lambda one: one.id)
def test_an_action_has_a_key_that_arrives(action: Action) -> None:
    # Shift+F3 is also how a terminal says where its cursor is.
    keys = [key for key in action.keys.split(",") if key != "shift+f3"]
    assert keys
    assert [arrived(sent(key)) for key in keys] == [[SAME.get(key, key)] for key in keys]


@pytest.mark.parametrize("text", ["¡", "§", "™", "-", "+", "z"])
def test_characters_stay_characters(text: str) -> None:
    teach()
    [event] = XTermParser().feed(text)
    assert event.character == text


@pytest.mark.parametrize("sequence", ["\x1b[A", "\x1b[Z", "\x1bOP", "\x1b[200~x\x1b[201~"])
def test_longer_sequences_are_none_of_them(sequence: str) -> None:
    assert not any(key.startswith("alt+") for key in arrived(sequence))
