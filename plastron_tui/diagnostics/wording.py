"""Texts of a bounded length, whatever names and lists go into them."""

from __future__ import annotations

from collections.abc import Iterable

LONGEST_TEXT = 2_000
"""The most bytes of a message, a help or a label, in UTF-8."""

_TAIL = 500
_CUT = "…"
_LONGEST_LIST = 600
_LONGEST_NAME = 120


def shortened(text: str, most: int = LONGEST_TEXT) -> str:
    """Return a text of at most so many bytes; a longer one is cut in its middle.

    What starts a sentence says what it is about, and what ends it what is wrong.
    """
    # A character has four bytes at most.
    if len(text) * 4 <= most:
        return text
    data = text.encode("utf-8", "surrogatepass")
    if len(data) <= most:
        return text
    tail = min(_TAIL, most // 4)
    head = data[: most - tail - len(_CUT.encode())]
    return _decoded(head) + _CUT + _decoded(data[-tail:])


def _decoded(cut: bytes) -> str:
    """Return the characters that are whole."""
    return cut.decode("utf-8", "ignore")


def listed(names: Iterable[str]) -> str:
    """Return names with commas between; a long list ends in `… and N more`."""
    shown: list[str] = []
    length = left = 0
    for name in names:
        name = shortened(name, _LONGEST_NAME)
        length += len(name) + 2
        if left or (shown and length > _LONGEST_LIST):
            left += 1
        else:
            shown.append(name)
    return ", ".join(shown) + (f" … and {left} more" if left else "")


def either(names: Iterable[str]) -> str:
    """Return names as what one may choose from: `a, b or c`."""
    *first, last = names
    return f"{', '.join(first)} or {last}" if first else last


def counted(count: int, word: str) -> str:
    """Return a number with what is counted: `no files`, `1 file`, `3 files`."""
    return f"1 {word}" if count == 1 else f"{count or 'no'} {word}s"
