"""The lines of a session's text, kept up to date edit by edit."""

from __future__ import annotations

from plastron_tui.session import Session

from .columns import Line, line_of
from .offsets import Offsets


class Buffer:
    """The text of a session, by rows. Rows count from 0, offsets are bytes of the text."""

    def __init__(self, session: Session) -> None:
        self.session = session
        text = self.text
        starts = [0]
        find = text.find
        at = find(b"\n")
        while at >= 0:
            starts.append(at + 1)
            at = find(b"\n", at + 1)
        self._starts = Offsets(starts)
        self.ending = b"\r\n" if text[: text.find(b"\n") + 1].endswith(b"\r\n") else b"\n"
        self.widest = 0
        """The most bytes that a line has had since the text was measured."""
        self.measure()

    def measure(self) -> None:
        """Find the longest line, where lines may have become shorter."""
        self.widest = max(map(len, self.text.split(b"\n")))

    @property
    def text(self) -> bytes:
        """The whole text."""
        return self.session.document.text

    @property
    def size(self) -> int:
        """The length of the text in bytes."""
        return len(self.session.document.text)

    @property
    def row_count(self) -> int:
        """How many rows there are, an empty last one included."""
        return len(self._starts)

    def edit(self, start: int, old_end: int, new: bytes) -> None:
        """Replace the bytes from `start` to `old_end`."""
        self.session.edit(start, old_end, new)
        first, last = self._starts.after(start), self._starts.after(old_end)
        added = []
        at = new.find(b"\n")
        while at >= 0:
            added.append(start + at + 1)
            at = new.find(b"\n", at + 1)
        self._starts.edit(first, last, added, len(new) - (old_end - start))
        if not added:
            row = first - 1
            self.widest = max(self.widest, self.end(row) - self.start(row))
        else:
            rows = range(first - 1, first + len(added))
            self.widest = max(self.widest, *(self.end(row) - self.start(row) for row in rows))

    def row(self, offset: int) -> int:
        """Return the row of an offset."""
        return self._starts.after(offset) - 1

    def start(self, row: int) -> int:
        """Return the offset at which a row starts."""
        return self._starts[row]

    def end(self, row: int) -> int:
        """Return the offset at which a row ends, before its line ending."""
        if row + 1 >= len(self._starts):
            return self.size
        end = self._starts[row + 1] - 1
        return end - 1 if end > self._starts[row] and self.text[end - 1] == 0x0D else end

    def next_start(self, row: int) -> int:
        """Return the offset after a row's line ending."""
        return self._starts[row + 1] if row + 1 < len(self._starts) else self.size

    def line_bytes(self, row: int) -> bytes:
        """Return the bytes of a row, without its line ending."""
        return self.text[self.start(row) : self.end(row)]

    def line(self, row: int) -> Line:
        """Return a row as it is shown."""
        return line_of(self.line_bytes(row))

    def clamp(self, offset: int) -> int:
        """Return the nearest place at which a cursor can stand."""
        offset = min(max(offset, 0), self.size)
        row = self.row(offset)
        start = self.start(row)
        column = min(offset, self.end(row)) - start
        line = self.line(row)
        return start + line.column(line.cell(column))

    def cell(self, offset: int) -> int:
        """Return the cell of an offset within its row."""
        row = self.row(offset)
        return self.line(row).cell(offset - self.start(row))

    def at_cell(self, row: int, cell: int) -> int:
        """Return the offset of the character in a cell of a row."""
        return self.start(row) + self.line(row).column(cell)

    def normalized(self, text: str) -> bytes:
        """Return a text as bytes of this program: its line endings, and no NUL."""
        plain = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "")
        encoded = plain.encode("utf-8", "replace")
        return encoded if self.ending == b"\n" else encoded.replace(b"\n", self.ending)
