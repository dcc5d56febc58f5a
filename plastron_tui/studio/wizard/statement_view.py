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

    def show(self, lines: Sequence[str], here: str = "") -> None:
        """Show statements; `here` is the one that is being filled in."""
        self.lines = tuple(lines)
        self._here = self.lines.index(here) if here in self.lines else -1
        self.refresh_lines()

    def refresh_lines(self) -> None:
        """Draw the statements in the colours of the theme that is used now."""
        palette = self._palette()
        text = Text(overflow="fold", no_wrap=False)
        for number, line in enumerate(self.lines):
            if number:
                text.append("\n")
            mark = "▸ " if number == self._here else "  "
            text.append(mark, Style(bold=True))
            text.append_text(highlighted(line, palette))
        self.update(text)

    def _palette(self) -> Palette:
        if self.app.native_ansi_color:
            return ansi_palette()
        _, _, background, foreground = self.colors
        return themed_palette(
            self.app.theme_variables, background.blend(foreground, 1, 1), background
        )


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
