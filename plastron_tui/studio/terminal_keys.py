"""Chords with Alt, as terminals send them: Escape, and then the character.

Textual reads Escape and a digit as what one terminal on macOS means by them (`¡` for Alt+1), a
sign as the sign alone, Alt+Enter as Enter, and a letter as one that can be typed: none of these
would reach its binding.
"""

from __future__ import annotations

from string import ascii_lowercase, digits
from typing import NamedTuple

from .key_table import name_of_sign
from .textual_private import known_sequences

_NAMES = {"\r": "enter", "\x7f": "backspace", **{sign: name_of_sign(sign) for sign in "-=+?,."}}
# Some terminals send these for Control and an arrow, and Textual knows that.
_TAKEN = "bf"
_CHORDS = {
    character: f"alt+{_NAMES.get(character, character)}"
    for character in (*digits, *ascii_lowercase, *_NAMES)
    if character not in _TAKEN
}
ALT_CHORDS = frozenset(_CHORDS.values())
"""The chords with Alt and a character that every terminal sends."""


class _Chord(NamedTuple):
    """A key, as far as Textual's parser looks at one."""

    value: str


def teach() -> None:
    """Let Textual tell the chords apart from characters, where it can be told."""
    known = known_sequences()
    if known is None:
        return
    for character, chord in _CHORDS.items():
        known[f"\x1b{character}"] = (_Chord(chord),)
