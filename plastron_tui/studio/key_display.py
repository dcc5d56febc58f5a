"""What keys are called: as it stands on a keyboard, not as Textual writes them."""

from __future__ import annotations

import unicodedata

_NAMES = {
    "escape": "Esc",
    "pageup": "PgUp",
    "pagedown": "PgDn",
    "up": "↑",
    "down": "↓",
    "left": "←",
    "right": "→",
    "plus": "+",
    "minus": "-",
    "slash": "/",
    "full_stop": ".",
    **{f"f{number + 12}": f"Shift-F{number}" for number in range(1, 13)},
    "ctrl+underscore": "Ctrl-/",
    "ctrl+at": "Ctrl-Space",
    "ctrl+@": "Ctrl-Space",
}
"""Names that do not follow from Textual's. Terminals send Shift-F3 as F15, and Ctrl-/ as Ctrl-_."""


def key_name(key: str) -> str:
    """Return what a key is called: `Ctrl-Q` for `ctrl+q`, `Alt-?` for `alt+question_mark`."""
    if key in _NAMES:
        return _NAMES[key]
    *held, last = key.split("+")
    return "-".join([*(each.capitalize() for each in held), _plain(last, is_upper=bool(held))])


def _plain(key: str, *, is_upper: bool) -> str:
    """Return the name of a key that is pressed alone, or, as upper case, together with others."""
    if key in _NAMES:
        return _NAMES[key]
    if len(key) == 1:
        return key.upper() if is_upper else key
    try:
        character = unicodedata.lookup(key.replace("_", " "))
    except KeyError:
        character = ""
    # Some keys are called as characters that nobody sees: Tab, Space, Delete.
    return character if character.strip() and character.isprintable() else key.capitalize()
