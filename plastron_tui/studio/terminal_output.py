"""What goes to the terminal: only the cells that differ from those that it shows.

Textual writes a part of the screen anew whenever a widget in it asks for that, whether or not
anything in it differs: a key may bring some 20 KB. `ShownScreen` is a model of the terminal that
follows what is written: texts at absolute places, in colours that begin and end with the default
ones. Of such an update it lets pass what changes a cell. What it does not understand it lets pass
as it is, and from then on it knows nothing of the screen, so that all is written.

A cell is known only by characters of which every terminal says that they take one cell. A line with
others (CJK, emoji, what combines with the character before) is written as a whole or not at all.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from itertools import islice, repeat
from typing import TypeAlias

from rich.cells import cell_len

Cell: TypeAlias = "tuple[str, _Style] | None"
"""A character and how it is drawn; None where nobody knows."""

BEGIN, END = "\x1b[?2026h", "\x1b[?2026l"
"""Between these the terminal waits with showing (synchronized output)."""

_MOVE = re.compile(r"\x1b\[(\d+);(\d+)H")
_TOKEN = re.compile(
    r"(?P<text>[^\x00-\x1f\x7f-\x9f]+)"
    r"|\x1b\[(?P<sgr>[\d;]*)m"
    r"|\x1b\]8;(?P<link>[^\x00-\x1f\x7f]*)\x1b\\"
)
_STYLED = re.compile(r"(?:[^\x00-\x1f\x7f-\x9f]+|\x1b\[[\d;]*m)*")
_HARMLESS = re.compile(
    r"(?:\x07"
    r"|\x1b\[\?(?:7|25|1000|1002|1003|1004|1006|1015|1016|2004|2026|2048)[hl]"
    r"|\x1b\[\?\d+\$p"
    r"|\x1b\[[<>=]\d*u"
    r"|\x1b\](?:0|2|22|52);[^\x00-\x1f\x7f]*(?:\x07|\x1b\\))*"
)
"""What changes no cell: the bell, modes of mouse and keys, questions, title and clipboard."""

_ONE_CELL = re.compile(
    r"[ -~\u00a1-\u00ac\u00ae-\u02ff\u0370-\u0377\u037a-\u037f\u0384-\u0482\u048a-\u052f"
    r"\u2010-\u2027\u2030-\u205e\u2190-\u2193\u2200-\u22ff\u2500-\u25a9\u25ac-\u25b5\u25b7-\u25bf"
    r"\u25c1-\u25fa\u2605\u2606\u2691\u2715-\u2718\u2800-\u28ff]+"
)
"""Characters of one cell everywhere: none that combines, none that some terminals draw as emoji."""

_FAR = 1 << 30
"""A column right of all others."""

_NEAR = 4
"""Over fewer equal cells it is shorter to write them again than to move the cursor."""


class _Style:
    """How characters are drawn: parameters of SGR, and parameters and address of a link.

    There is one object of a kind, as long as it is remembered: to compare cells has to be fast.

    Attributes:
        attributes: all but the colours: bold, underlined, reversed.
        front: the colour of the characters, 39 for the terminal's own.
        back: the colour behind them, 49 for the terminal's own.
    """

    __slots__ = ("attributes", "back", "front", "link")

    def __init__(
        self, attributes: str = "", front: str = "39", back: str = "49", link: str = ";"
    ) -> None:
        self.attributes, self.front, self.back, self.link = attributes, front, back, link

    @property
    def is_plain(self) -> bool:
        """Whether the terminal's own colours are all that it has."""
        return not self.attributes and (self.front, self.back) == ("39", "49")

    def after(self, before: _Style) -> str:
        """Return what has to be written after characters of another style."""
        changed = []
        if before.attributes not in {"", self.attributes} or (
            self.is_plain and not before.is_plain
        ):
            changed, before = ["0"], _Style(link=before.link)
        if self.attributes != before.attributes:
            changed.append(self.attributes)
        if self.front != before.front:
            changed.append(self.front)
        if self.back != before.back:
            changed.append(self.back)
        link = "" if self.link == before.link else f"\x1b]8;{self.link}\x1b\\"
        return f"{link}\x1b[{';'.join(changed)}m" if changed else link


@lru_cache(8192)
def _style(attributes: str = "", front: str = "39", back: str = "49", link: str = ";") -> _Style:
    return _Style(attributes, front, back, link)


_PLAIN = _style()
_UNSEEN = frozenset({"1", "2", "3"})
"""Attributes that a blank shows nothing of: bold, dim and italic."""
_RESET = frozenset({"", "0"})


@lru_cache(8192)
def _style_of(sgr: str, link: str) -> _Style:
    """Return the style that parameters make of the default one."""
    attributes: list[str] = []
    front, back = "39", "49"
    words = iter(sgr.split(";"))
    for word in words:
        code = int(word or 0)
        parameter = word
        if code in {38, 48}:
            kind = next(words, "")
            parameter = ";".join([word, kind, *islice(words, 3 if kind == "2" else 1)])
        if code == 0:
            attributes, front, back = [], "39", "49"
        elif 30 <= code < 40 or 90 <= code < 98:
            front = parameter
        elif 40 <= code < 50 or 100 <= code < 108:
            back = parameter
        else:
            attributes.append(parameter)
    style = _style(";".join(attributes), front, back, link)
    return _PLAIN if style.is_plain and link == _PLAIN.link else style


@lru_cache(8192)
def _blank_of(style: _Style) -> _Style:
    """Return what can be seen of a style where there is no character."""
    if _UNSEEN.issuperset(style.attributes.split(";")) or not style.attributes:
        if style.back == _PLAIN.back and style.link == _PLAIN.link:
            return _PLAIN
        return _style("", _PLAIN.front, style.back, style.link)
    return style


class _Row:
    """What a line of the screen shows.

    Attributes:
        cells: the cells from the left, as far as anything was written.
        texts: what was written at a column and is still there as a whole, with its end.
        not_read: what was written first, if nothing was since; it is taken apart when it matters.
    """

    __slots__ = ("cells", "not_read", "texts")

    def __init__(self) -> None:
        self.cells: list[Cell] = []
        self.texts: dict[int, tuple[str, int]] = {}
        self.not_read: tuple[int, str] | None = None

    def read(self, columns: int) -> None:
        """Know the cells of what was written first, if they all were on the screen."""
        if self.not_read is not None:
            column, text = self.not_read
            self.not_read = None
            cells = _cells(text)
            if _has_one_cell_each(cells) and column + len(cells) <= columns:
                self.cells = [*repeat(None, column), *cells]

    def reach(self, end: int) -> None:
        """Have cells up to a column."""
        self.cells.extend(repeat(None, end - len(self.cells)))

    def forget_texts(self, start: int, end: int) -> None:
        """Note that the cells between two columns are other ones now, and half of what adjoins."""
        for at in [at for at, (_, to) in self.texts.items() if at <= end and to >= start]:
            del self.texts[at]

    def forget_cells(self, start: int) -> None:
        """Know nothing any more of the cells from a column on, and of the one before it."""
        del self.cells[max(0, start - 1) :]


class _UnknownSequenceError(Exception):
    """A sequence is not one of those that updates are made of."""


class _Writer:
    """Puts an update together: moves the cursor and changes the style only where it has to."""

    def __init__(self) -> None:
        self._parts: list[str] = []
        self._at: tuple[int, int] | None = None
        self._style = _PLAIN

    def put(self, row: int, column: int, cells: list[tuple[str, _Style]]) -> None:
        """Write cells from a place on."""
        self.move(row, column)
        put, now, blank = self._parts.append, self._style, _blank_of(self._style)
        for character, style in cells:
            if style is not now and (character != " " or style is not blank):
                put(style.after(now))
                now, blank = style, _blank_of(style)
            put(character)
        self._style = now
        self._at = (row, column + len(cells))

    def put_raw(self, row: int, column: int, text: str) -> None:
        """Write what begins and ends in the default style, of whatever width it may be."""
        self._restyle(_PLAIN)
        self.move(row, column)
        self._parts.append(text)
        self._at = None

    def move(self, row: int, column: int) -> None:
        """Move the cursor."""
        if self._at != (row, column):
            self._parts.append(f"\x1b[{row + 1};{column + 1}H")
            self._at = (row, column)

    def _restyle(self, style: _Style) -> None:
        if style is not self._style:
            self._parts.append(style.after(self._style))
            self._style = style

    @property
    def has_written(self) -> bool:
        """Whether anything was put."""
        return bool(self._parts)

    def finish(self, cursor: tuple[int, int]) -> str:
        """Return all that was put; the cursor is left at a place, in the default style."""
        self._restyle(_PLAIN)
        self.move(*cursor)
        return "".join(self._parts)


class ShownScreen:
    """Knows what a terminal shows, as far as that follows from what was written to it."""

    def __init__(self) -> None:
        self._rows: dict[int, _Row] = {}
        self._size: tuple[int, int] | None = None
        self._cursor: tuple[int, int] | None = None
        self._is_held = False

    def forget(self) -> None:
        """Know nothing any more: somebody else has written, or the terminal has another size."""
        # Another dictionary: a signal may come while an update is looked at.
        self._rows = {}
        self._cursor = None

    def changes(self, data: str, size: tuple[int, int] | None = None) -> str:
        """Return what has to be written so that the terminal shows what `data` would let it show.

        Args:
            data: what was to be written.
            size: the columns and rows that the terminal has now, as far as that is known.
        """
        if size != self._size:
            self._size = size
            self.forget()
        if data == BEGIN:
            # It is sent with what follows, if anything does.
            self._is_held = True
            return ""
        if data == END and self._is_held:
            self._is_held = False
            return ""
        before, *moves = _MOVE.split(data)
        if not moves:
            if not _HARMLESS.fullmatch(data):
                self.forget()
            return data
        written = self._written(before, moves)
        if written is None:
            self.forget()
            written = data
        if written and self._is_held:
            self._is_held = False
            written = BEGIN + written
        return written

    def _written(self, before: str, moves: list[str]) -> str | None:
        """Return an update without what the terminal shows already; None if it is none."""
        if not _HARMLESS.fullmatch(before):
            return None
        writer = _Writer()
        texts = zip(moves[::3], moves[1::3], moves[2::3], strict=True)
        for row, column, text in texts:
            place = (max(0, int(row) - 1), max(0, int(column) - 1))
            # Where the cursor goes at the end of a line does not matter: it is moved before more.
            shown = text.removesuffix("\n")
            if shown:
                try:
                    self._put(writer, *place, shown)
                except _UnknownSequenceError:
                    return None
        if text:
            return None
        if not writer.has_written and place == self._cursor:
            return before
        self._cursor = place
        return before + writer.finish(place)

    def _put(self, writer: _Writer, row: int, column: int, text: str) -> None:
        line = self._rows.get(row)
        if line is None:
            line = self._rows[row] = _Row()
            if self._size is not None and row < self._size[1] and _ends_plain(text):
                writer.put_raw(row, column, text)
                line.texts[column] = (text, self._size[0])
                line.not_read = (column, text)
                return
        known = line.texts.get(column)
        if known is not None and known[0] == text:
            return
        line.read(_FAR if self._size is None else self._size[0])
        cells = _cells(text)
        is_plain = _has_one_cell_each(cells)
        end = column + (len(cells) if is_plain else cell_len("".join(each for each, _ in cells)))
        if self._size is not None and (row >= self._size[1] or end > self._size[0]):
            # Beyond its edges a terminal shows something else, somewhere else.
            writer.put_raw(row, column, text)
            self._rows.pop(row, None)
            self._rows.pop(self._size[1] - 1, None)
            return
        if is_plain:
            line.reach(end)
            for first, last in _differences(line.cells[column:end], cells):
                writer.put(row, column + first, cells[first:last])
                line.cells[column + first : column + last] = cells[first:last]
                line.forget_texts(column + first, column + last)
        else:
            writer.put_raw(row, column, text)
            # Terminals may not agree on where it ends.
            line.forget_texts(column, _FAR)
            line.forget_cells(column)
        line.texts[column] = (text, end)


def _ends_plain(text: str) -> bool:
    """Tell whether a text is one of an update, without to take it apart: it ends in no style."""
    return text.endswith("\x1b[0m") and _STYLED.fullmatch(text) is not None


def _has_one_cell_each(cells: list[tuple[str, _Style]]) -> bool:
    return _ONE_CELL.fullmatch("".join([character for character, _ in cells])) is not None


def _cells(text: str) -> list[tuple[str, _Style]]:
    """Return the characters of a text with sequences, each with its style.

    Raises:
        _UnknownSequenceError: if it has others than those of a style, or ends in another one.
    """
    cells: list[tuple[str, _Style]] = []
    sgr, link, at, style = "", _PLAIN.link, 0, _PLAIN
    while at < len(text):
        token = _TOKEN.match(text, at)
        if token is None:
            raise _UnknownSequenceError
        at = token.end()
        characters, parameters, address = token.groups()
        if characters is not None:
            blank = (" ", _blank_of(style))
            cells += [blank if each == " " else (each, style) for each in characters]
            continue
        if parameters is not None:
            sgr = "" if parameters in _RESET else f"{sgr};{parameters}" if sgr else parameters
        else:
            link = address
        style = _style_of(sgr, link)
    if style is not _PLAIN:
        raise _UnknownSequenceError
    return cells


def _differences(old: list[Cell], new: list[tuple[str, _Style]]) -> Iterator[tuple[int, int]]:
    """Yield the first and the last column, exclusive, of each run of cells that differ."""
    pairs = zip(old, new, strict=True)
    columns = [at for at, (before, now) in enumerate(pairs) if before != now]
    first = last = -_NEAR
    for at in columns:
        if at - last >= _NEAR:
            if last > first:
                yield first, last
            first = at
        last = at + 1
    if last > first:
        yield first, last
