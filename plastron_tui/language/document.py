"""The text of a program together with its tree, edited incrementally."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Tree

from plastron_tui.diagnostics import LineIndex

from .grammar import new_parser


class Excerpt(NamedTuple):
    """The tree of whole lines of a program; its offsets count from `start`."""

    tree: Tree
    start: int
    text: bytes


class Document:
    """A program's text, as UTF-8, and the tree that was parsed from it.

    An edit tells the tree what has moved; the parse of what has changed waits until somebody
    asks for the tree. What a window shows of a long program is had at once, by `excerpt`.
    """

    def __init__(self, text: bytes = b"") -> None:
        self._parser = new_parser()
        self._text = text
        self._tree = self._parser.parse(text)
        self._is_parsed = True
        self._lines: LineIndex | None = None

    @property
    def text(self) -> bytes:
        """The whole text."""
        return self._text

    @property
    def tree(self) -> Tree:
        """The tree of the text as it is now."""
        if not self._is_parsed:
            self._tree = self._parser.parse(self._text, self._tree)
            self._is_parsed = True
        return self._tree

    @property
    def lines(self) -> LineIndex:
        """The line starts of the text as it is now."""
        if self._lines is None:
            self._lines = LineIndex(self._text)
        return self._lines

    def edit(self, start: int, old_end: int, new: bytes) -> None:
        """Replace the bytes from `start` to `old_end`.

        Raises:
            ValueError: when the range does not lie in the text.
        """
        before = self._text
        if not 0 <= start <= old_end <= len(before):
            raise ValueError(f"no range of this text: {start} to {old_end}")
        row = before.count(b"\n", 0, start)
        column = start - (before.rfind(b"\n", 0, start) + 1)
        # The nodes that statements have stay as they were: an edit changes a tree and its nodes.
        self._tree = self._tree.copy()
        self._tree.edit(
            start_byte=start,
            old_end_byte=old_end,
            new_end_byte=start + len(new),
            start_point=(row, column),
            old_end_point=_moved(row, column, before[start:old_end]),
            new_end_point=_moved(row, column, new),
        )
        self._text = b"".join((before[:start], new, before[old_end:]))
        self._is_parsed = False
        self._lines = None

    def snapshot(self) -> Document:
        """Return the document as it is now, for another thread; edits leave it alone."""
        other = Document.__new__(Document)
        other._parser = new_parser()
        other._text = self._text
        other._tree = self._tree.copy()
        other._is_parsed = self._is_parsed
        other._lines = self._lines
        return other

    def excerpt(self, start: int, end: int) -> Excerpt:
        """Return the tree of the lines that hold the bytes from `start` to `end`.

        It costs what the lines hold, not what the text holds: no statement reaches over the end
        of its line, and a comment that does is taken along. While the tree waits for its parse,
        where the comments are is known from before the last edits.
        """
        text = self._text
        first = text.rfind(b"\n", 0, start) + 1
        # The line that a comment starts on may start in another comment.
        while (comment := self._comment_at(first)) is not None:
            first = text.rfind(b"\n", 0, comment) + 1
        last = text.find(b"\n", end)
        last = len(text) if last < 0 else last + 1
        opened = text.rfind(b"/*", first, last)
        if opened >= 0:
            closed = text.find(b"*/", opened + 2)
            if closed >= last:
                after = text.find(b"\n", closed)
                last = len(text) if after < 0 else after + 1
        lines = text[first:last]
        return Excerpt(self._parser.parse(lines), first, lines)

    def _comment_at(self, line: int) -> int | None:
        """Return where the block comment starts that reaches over the start of a line."""
        node = self._tree.root_node.descendant_for_byte_range(line, line)
        if node is None or node.type != "block_comment" or node.start_byte >= line:
            return None
        return node.start_byte


def _moved(row: int, column: int, text: bytes) -> tuple[int, int]:
    """Return the point at the end of a text that starts at a row and a byte column."""
    newlines = text.count(b"\n")
    if not newlines:
        return row, column + len(text)
    return row + newlines, len(text) - (text.rfind(b"\n") + 1)
