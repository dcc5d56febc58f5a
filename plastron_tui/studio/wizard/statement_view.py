"""Statements as the editor shows them."""

from __future__ import annotations

from collections.abc import Sequence

from rich.style import Style
from rich.text import Text
from textual.widgets import Static
from tree_sitter import QueryCursor

from plastron_tui.language import Document
from plastron_tui.language.grammar import highlights_query

from ..editor.palette import Palette, ansi_palette, themed_palette


class StatementView(Static):
    """Shows statements in the editor's colours; those of the form at hand stand out."""

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id, markup=False)
        self.border_title = "Statements"
        self.lines: tuple[str, ...] = ()
        self._here = -1
        self._rows = 0

    def show(self, lines: Sequence[str], here: str, rows: int) -> None:
        """Show statements, in so many rows at most; `here` is the one that is being filled in."""
        self.lines, self._rows = tuple(lines), rows
        self._here = self.lines.index(here) if here in self.lines else -1
        self.refresh_lines()

    def _in_sight(self) -> range:
        """Return the numbers of the statements that there is room for."""
        width = max(self.app.size.width - self.gutter.width, 1)
        console = self.app.console
        heights = [len(Text(_mark() + each).wrap(console, width)) for each in self.lines]
        return fitting(heights, self._here, self._rows)

    def refresh_lines(self) -> None:
        """Draw the statements in the colours of the theme that is used now."""
        palette = self._palette()
        text = Text(overflow="fold", no_wrap=False)
        shown = self._in_sight()
        for number in shown:
            if number > shown.start:
                text.append("\n")
            text.append(_mark(is_here=number == self._here), Style(bold=True))
            text.append_text(highlighted(self.lines[number], palette))
        left = len(self.lines) - len(shown)
        self.border_subtitle = f"{left} more" if left else ""
        self.update(text)

    def _palette(self) -> Palette:
        if self.app.native_ansi_color:
            return ansi_palette()
        _, _, background, foreground = self.colors
        return themed_palette(
            self.app.theme_variables, background.blend(foreground, 1, 1), background
        )


def _mark(*, is_here: bool = False) -> str:
    return "▸ " if is_here else "  "


def fitting(heights: Sequence[int], here: int, rows: int) -> range:
    """Return which of some statements fit, from the first one on or so that one is in sight.

    Args:
        heights: the rows that each takes.
        here: the number of the one that has to be in sight, -1 for none.
        rows: how many there are.
    """
    start = end = used = 0
    for number, height in enumerate(heights):
        used += height
        while used > rows and start < number <= here:
            used -= heights[start]
            start += 1
        if used > rows and number > max(here, 0):
            break
        end = number + 1
    return range(start, end)


def highlighted(line: str, palette: Palette) -> Text:
    """Return a statement in the colours of the editor."""
    source = line.encode("utf-8", "replace")
    text = Text(source.decode())
    cursor = QueryCursor(highlights_query())
    for capture, nodes in cursor.captures(Document(source).tree.root_node).items():
        style = palette.captures.get(capture)
        for node in nodes if style is not None else ():
            start = len(source[: node.start_byte].decode("utf-8", "replace"))
            end = len(source[: node.end_byte].decode("utf-8", "replace"))
            text.stylize(style or "", start, end)
    return text
