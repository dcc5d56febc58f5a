"""The escapes of a text in double quotes.

They are here, on the lowest floor, for whatever lists them: a diagnostic, its explanation, the
reference of the language.
"""

from __future__ import annotations

MEANINGS = {'\\"': '"', "\\\\": "\\", "\\n": "\n", "\\t": "\t"}
"""What each escape of one letter stands for."""

_OF_A_CHARACTER = "\\uXXXX"
"""A character by its number, in four hexadecimal digits."""


def listed(mark: str = "") -> str:
    """Return all the escapes in words, with a mark around each."""
    *first, last = (f"{mark}{escape}{mark}" for escape in (*MEANINGS, _OF_A_CHARACTER))
    return f"{', '.join(first)} and {last}"
