"""What keys are called: as it stands on a keyboard, not as Textual writes them."""

from __future__ import annotations

from types import MappingProxyType

from .key_table import MEANT, sign_of_name

ARROWS = MappingProxyType({"up": "↑", "down": "↓", "left": "←", "right": "→"})
"""The signs of the keys that move by one."""
_NAMES = {"escape": "Esc", "pageup": "PgUp", "pagedown": "PgDn", **ARROWS}
"""Names that do not follow from Textual's."""


def key_name(key: str) -> str:
    """Return what a key is called: `Ctrl-Q` for `ctrl+q`, `Alt-?` for `alt+question_mark`."""
    *held, last = MEANT.get(key, key).split("+")
    return "-".join([*(each.capitalize() for each in held), _plain(last, is_upper=bool(held))])


def _plain(key: str, *, is_upper: bool) -> str:
    """Return the name of a key that is pressed alone, or, as upper case, together with others."""
    if key in _NAMES:
        return _NAMES[key]
    if len(key) == 1:
        return key.upper() if is_upper else key
    character = sign_of_name(key)
    # Some keys are called as characters that nobody sees: Tab, Space, Delete.
    return character if character.strip() and character.isprintable() else key.capitalize()
