"""The text of a program together with its tree, edited incrementally."""

from __future__ import annotations

from tree_sitter import Range, Tree

from plastron_tui.diagnostics import LineIndex

from .grammar import new_parser


class Document:
    """A program's text, as UTF-8, and the tree that was parsed from it.

    The two always belong together. An edit costs what it touches, not what the text holds.
    """

    def __init__(self, text: bytes = b"") -> None:
        self._parser = new_parser()
        self._text = text
        self._tree = self._parser.parse(text)
        self._lines: LineIndex | None = None

    @property
    def text(self) -> bytes:
        """The whole text."""
        return self._text

    @property
    def tree(self) -> Tree:
        """The tree of the text as it is now."""
        return self._tree

    @property
    def lines(self) -> LineIndex:
        """The line starts of the text as it is now."""
        if self._lines is None:
            self._lines = LineIndex(self._text)
        return self._lines

    def edit(self, start: int, old_end: int, new: bytes) -> list[Range]:
        """Replace the bytes from `start` to `old_end`, and return where the tree changed.

        Raises:
            ValueError: when the range does not lie in the text.
        """
        if not 0 <= start <= old_end <= len(self._text):
            raise ValueError(f"no range of this text: {start} to {old_end}")
        before = self._text
        after = before[:start] + new + before[old_end:]
        new_end = start + len(new)
        self._tree.edit(
            start_byte=start,
            old_end_byte=old_end,
            new_end_byte=new_end,
            start_point=_point(before, start),
            old_end_point=_point(before, old_end),
            new_end_point=_point(after, new_end),
        )
        old_tree, self._tree = self._tree, self._parser.parse(after, self._tree)
        self._text = after
        self._lines = None
        return old_tree.changed_ranges(self._tree)


def _point(text: bytes, offset: int) -> tuple[int, int]:
    """Return the row and the byte column of an offset, as tree-sitter counts them."""
    return text.count(b"\n", 0, offset), offset - (text.rfind(b"\n", 0, offset) + 1)
