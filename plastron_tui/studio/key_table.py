"""The one table of names of keys: Textual's, and what stands on a keyboard or is sent for them."""

from __future__ import annotations

import unicodedata
from types import MappingProxyType

from textual.keys import KEY_NAME_REPLACEMENTS

SENT = MappingProxyType(
    {
        "ctrl+slash": "ctrl+underscore",
        "ctrl+space": "ctrl+@",
        **{f"shift+f{number}": f"f{number + 12}" for number in range(1, 13)},
    }
)
"""What terminals send for a key under another name."""

MEANT = MappingProxyType({**{sent: key for key, sent in SENT.items()}, "ctrl+at": "ctrl+space"})
"""What is pressed for what terminals send under another name."""


def name_of_sign(sign: str) -> str:
    """Return Textual's name of the key of a character: `minus` for `-`."""
    name = unicodedata.name(sign, "").lower().replace("-", "_").replace(" ", "_")
    return KEY_NAME_REPLACEMENTS.get(name, name) or sign


SIGNS = MappingProxyType(
    {name_of_sign(sign): sign for sign in map(chr, range(33, 127)) if not sign.isalnum()}
)
"""The signs of ASCII by Textual's names of their keys."""


def sign_of_name(name: str) -> str:
    """Return the character of a key that Textual calls by a name; "" for a key that has none."""
    if name in SIGNS:
        return SIGNS[name]
    try:
        return unicodedata.lookup(name.replace("_", " "))
    except KeyError:
        return ""
