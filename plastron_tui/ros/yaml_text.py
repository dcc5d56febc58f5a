"""The text of a YAML file, and the bytes that the marks of PyYAML are about."""

from __future__ import annotations

from itertools import accumulate
from typing import Any

from plastron_tui.diagnostics import Span

_BYTE_ORDER_MARK = "\ufeff"
_Marked = Any
"""What PyYAML gives two marks: a node, an event, a token."""


class YamlText:
    """A text as PyYAML shall get it, whose marks count characters where spans count bytes.

    Attributes:
        text: the text without the byte order marks that it may begin with, of which libyaml skips
            two, and counts the second one alone.
    """

    def __init__(self, source: bytes) -> None:
        """Decode what a file holds.

        Raises:
            UnicodeDecodeError: it is not UTF-8.
        """
        decoded = source.decode("utf-8")
        self.text = decoded.removeprefix(_BYTE_ORDER_MARK).removeprefix(_BYTE_ORDER_MARK)
        self._before = 3 * (len(decoded) - len(self.text))
        self._offsets = (
            None
            if self.text.isascii()
            else [0, *accumulate(len(each.encode()) for each in self.text)]
        )

    def byte(self, index: int) -> int:
        """Return the offset in the file of a character; one beyond the end counts as the end."""
        index = min(index, len(self.text))
        return self._before + (index if self._offsets is None else self._offsets[index])

    def span(self, marked: _Marked) -> Span:
        """Return the bytes between the marks of a node, an event or a token."""
        return Span(self.byte(marked.start_mark.index), self.byte(marked.end_mark.index))
