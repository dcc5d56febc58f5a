"""The names of keys: as people write them, as Textual does, and which of them a terminal sends."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from enum import Enum
from string import ascii_lowercase, digits
from typing import NamedTuple

from textual.keys import KEY_NAME_REPLACEMENTS

from plastron_tui.diagnostics import did_you_mean

from .key_display import ARROWS, key_name
from .key_table import SENT, SIGNS, name_of_sign
from .terminal_keys import ALT_CHORDS

_HELD = {
    **dict.fromkeys(("c", "ctl", "ctrl", "control", "strg"), "ctrl"),
    **dict.fromkeys(("a", "m", "alt", "meta", "option", "opt"), "alt"),
    **dict.fromkeys(("s", "shift"), "shift"),
    **dict.fromkeys(("super", "cmd", "command", "win", "windows"), "super"),
    "hyper": "hyper",
}
"""What is held with a key, as Textual calls it."""
_ORDER = ("alt", "ctrl", "hyper", "shift", "super")
"""The order in which Textual names what is held."""
_SAME = {
    "esc": "escape", "return": "enter", "ret": "enter", "cr": "enter", "del": "delete",
    "ins": "insert", "pgup": "pageup", "page_up": "pageup", "pgdn": "pagedown",
    "pgdown": "pagedown", "page_down": "pagedown", "spacebar": "space", "spc": "space",
    "bs": "backspace", "bksp": "backspace", "back_space": "backspace", "hyphen": "minus",
    "dash": "minus", "equals": "equals_sign", "equal": "equals_sign", "dot": "full_stop",
    "period": "full_stop", "question": "question_mark", "hash": "number_sign",
    "commercial_at": "at", "backtick": "grave_accent",
    **{arrow: key for key, arrow in ARROWS.items()},
}  # fmt: skip
_MOVING = ("up", "down", "left", "right", "home", "end", "pageup", "pagedown")
_NAMED = frozenset(
    {
        *_MOVING,
        *("insert", "delete", "escape", "enter", "tab", "backspace", "space"),
        *(f"f{number}" for number in range(1, 25)),
    }
)
_FUNCTIONS = frozenset(f"f{number}" for number in range(1, 13))
_WITH_SHIFT_OR_CTRL = frozenset((*_MOVING, "delete"))
_CTRL_SIGNS = frozenset({"@", "underscore", "backslash", "right_square_bracket"})
_OTHER_KEYS = {
    "ctrl+i": "Tab", "ctrl+m": "Enter", "ctrl+j": "Enter", "ctrl+h": "Backspace",
    "ctrl+left_square_bracket": "Esc", "ctrl+3": "Esc", "ctrl+8": "Backspace",
    "alt+f": "Ctrl and Right", "alt+b": "Ctrl and Left",
    "alt+left_square_bracket": "Esc", "alt+O": "Esc",
}  # fmt: skip
"""What reaches a program for a key, as if another one had been pressed."""


class Arrival(Enum):
    """How a key comes from the terminal."""

    ALWAYS = "always"
    SOMETIMES = "sometimes"
    AS_ANOTHER = "as another"
    NEVER = "never"


class WrittenKeys(NamedTuple):
    """What was written for the keys of an action.

    Attributes:
        keys: the keys in Textual's notation.
        problems: what cannot be read as a key, in words.
    """

    keys: tuple[str, ...]
    problems: tuple[str, ...]


def read_keys(texts: Iterable[str]) -> WrittenKeys:
    """Read keys as people write them: `ctrl+k`, `Ctrl-K`, `^K`, `C-k`, `<M-x>`, `F5, Alt+R`."""
    keys: list[str] = []
    problems: list[str] = []
    for text in texts:
        # A comma is a key too, behind what is held with it.
        for word in re.split(r"(?<![A-Za-z][+-]),", text):
            key = read_key(word)
            if key is None:
                hint = did_you_mean(word.strip().lower(), _NAMED)
                problems.append(f"no key `{word.strip()}`" + (f"; {hint}" if hint else ""))
            else:
                # What is pressed and what is sent for it: terminals do either.
                key = "ctrl+space" if key == "ctrl+at" else key
                keys += (key, SENT[key]) if key in SENT else (key,)
    return WrittenKeys(tuple(dict.fromkeys(keys)), tuple(problems))


def read_key(text: str) -> str | None:
    """Return one key in Textual's notation; None where it names no key."""
    word = text.strip()
    if len(word) > 3 and word[0] == "<" and word[-1] == ">":
        word = word[1:-1]
    held: set[str] = set()
    while True:
        if len(word) > 1 and word[0] == "^":
            held.add("ctrl")
            word = word[1:]
            continue
        front = re.match(r"([A-Za-z]+)\s*[+-]\s*(?=.)", word)
        if front is None or front[1].lower() not in _HELD:
            break
        held.add(_HELD[front[1].lower()])
        word = word[front.end() :]
    name = _name_of(word, held)
    if name is None:
        return None
    return "+".join([*(each for each in _ORDER if each in held), name])


def _name_of(word: str, held: set[str]) -> str | None:
    """Return the name of the key itself; with Shift alone a letter is its capital."""
    if len(word) == 1 and word not in _SAME:
        return _name_of_character(word, held)
    name = re.sub(r"[ -]+", "_", word.lower())
    name = _SAME.get(name, name)
    name = KEY_NAME_REPLACEMENTS.get(name, name)
    if name in _NAMED or name in SIGNS:
        return name
    return None


def _name_of_character(character: str, held: set[str]) -> str | None:
    if character.isalpha() and character.isascii():
        if held == {"shift"}:
            held.clear()
            return character.upper()
        return character.lower() if held else character
    if character.isalnum():
        return character
    return name_of_sign(character) if "!" <= character <= "~" else None


def types_text(key: str) -> bool:
    """Tell whether a key writes a character where there is a text."""
    return "+" not in key and (len(key) == 1 or key == "space" or key in SIGNS)


def arrival(key: str) -> Arrival:
    """Tell how a key in Textual's notation comes from most terminals, tmux and browsers."""
    *held, name = key.split("+")
    if key in _OTHER_KEYS:
        return Arrival.AS_ANOTHER
    if "super" in held or "hyper" in held:
        return Arrival.NEVER
    if _comes_from_all(held, name):
        return Arrival.ALWAYS
    is_digit = name in digits or name in ("plus", "minus", "equals_sign", "comma", "full_stop")
    return Arrival.NEVER if held == ["ctrl"] and is_digit else Arrival.SOMETIMES


def _comes_from_all(held: list[str], name: str) -> bool:
    match held:
        case []:
            return name not in _NAMED or name in _FUNCTIONS or not name[1:].isdigit()
        case ["ctrl"]:
            return name in {*ascii_lowercase, *_CTRL_SIGNS, *_WITH_SHIFT_OR_CTRL}
        case ["alt"]:
            return f"alt+{name}" in ALT_CHORDS or name in _MOVING[:4]
        case ["shift"]:
            return name in _WITH_SHIFT_OR_CTRL or name in _FUNCTIONS or name == "tab"
        case ["ctrl", "shift"]:
            return name in _MOVING[:6]
        case _:
            return False


def shown_keys(keys: Iterable[str]) -> str:
    """Return keys as a message has them: of those that are the same to a hand one is enough."""
    return ", ".join(dict.fromkeys(f"`{key_name(key)}`" for key in keys))


def arrives_as(key: str) -> str:
    """Return the name of the key that a terminal sends for one that it has no code for."""
    return _OTHER_KEYS[key]


def another_key(key: str, taken: Collection[str]) -> str:
    """Return a key that comes from every terminal, that nothing has, and that is like a key."""
    letter = key.rpartition("+")[2].lower()
    wished = [f"alt+{letter}", f"ctrl+{letter}"] if letter in ascii_lowercase else []
    # The window of many a terminal takes F11 for itself.
    others = [*(f"alt+{each}" for each in ascii_lowercase + digits), "f11"]
    free = (each for each in [*wished, *others] if each not in taken)
    return next((each for each in free if arrival(each) is Arrival.ALWAYS), "f11")
