"""A source file to be read: any size, at a line, with what is found in it marked."""

from __future__ import annotations

from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Size
from textual.strip import Strip

from .code_lines import CodeLines
from .styles import Lines
from .text_view import TextView


class CodeText(TextView):
    """Shows `CodeLines`, one of them marked as the line at hand.

    Attributes:
        code: the lines.
        line: the line at hand, from 0.
    """

    COMPONENT_CLASSES: ClassVar[set[str]] = {"code-text--line", "code-text--match"}

    def __init__(self, code: CodeLines, line: int, *, id: str | None = None) -> None:  # noqa: A002
        super().__init__(numbers=True, id=id)
        self.code = code
        self.line = line
        self._wanted = b""
        self._small = code.text.lower()

    def show_code(self, code: CodeLines, line: int) -> None:
        """Show another text, a line of it in sight."""
        self.code = code
        self._small = code.text.lower()
        self._fit()
        self.go_to(line)

    @property
    def rows(self) -> Lines:
        """No lines: those of the code are made as they come in sight."""
        return ()

    @property
    def _margin(self) -> int:
        return max(3, len(str(len(self.code)))) + 1

    def on_show(self) -> None:
        """Have the line at hand in sight, now that there is a size."""
        self._fit()
        self.call_after_refresh(self.go_to, self.line)

    def _fit(self) -> None:
        # A character has two cells at most, a tab four; a line in sight may be shorter.
        self.virtual_size = Size(self.code.widest + self._margin + 1, len(self.code))

    def go_to(self, line: int) -> None:
        """Make a line the one at hand, and have it in sight, with some above it."""
        self.line = max(0, min(line, len(self.code) - 1))
        top, height = self.scroll_offset.y, self.size.height
        if not top <= self.line < top + height - 1:
            self.scroll_to(0, max(0, self.line - height // 3), animate=False, force=True)
        self.refresh()

    def mark(self, wanted: str) -> None:
        """Mark what is looked for; capitals and small letters are the same, of A to Z alone."""
        self._wanted = wanted.encode().lower()
        self.refresh()

    def find(self, by: int, *, here: bool = False) -> bool:
        """Go to the next line that has what is looked for, or with -1 to the one before.

        From the last one it goes on at the first. `here` is whether the line at hand counts.
        """
        lower, starts, wanted = self._small, self.code.starts, self._wanted
        if not wanted or wanted not in lower:
            return False
        if by > 0:
            after = self.line if here else self.line + 1
            start = starts[after] if after < len(starts) else len(lower)
            at = lower.find(wanted, start)
            at = lower.find(wanted) if at < 0 else at
        else:
            at = lower.rfind(wanted, 0, starts[self.line])
            at = lower.rfind(wanted) if at < 0 else at
        self.go_to(self.code.row_at(at))
        return True

    @property
    def count(self) -> int:
        """How often the text has what is looked for."""
        return self._small.count(self._wanted) if self._wanted else 0

    def render_line(self, y: int) -> Strip:
        """Draw a line."""
        width = self.scrollable_content_region.width
        base = self.rich_style
        x, top = self.scroll_offset
        row = top + y
        if row >= len(self.code):
            return Strip.blank(width, base)
        margin, is_at_hand = self._margin, row == self.line
        if is_at_hand:
            base += self.tone("line", "code-text")
        line = Strip([Segment(text, base + self._tone(tone)) for text, tone in self._pieces(row)])
        line = line.crop(x, x + width - margin).extend_cell_length(width - margin, base)
        number = self.tone("strong") if is_at_hand else self.tone("number", "text-view")
        return Strip([Segment(f"{row + 1:>{margin - 1}} ", base + number), *line])

    def _tone(self, tone: str) -> Style:
        return self.tone(tone, "code-text") if tone == "match" else self.tone(tone)

    def _pieces(self, row: int) -> list[tuple[str, str]]:
        """Return the pieces of a line; those that are looked for have a tone of their own."""
        pieces = list(self.code[row])
        wanted = self._wanted.decode()
        if not wanted or wanted not in _lower("".join(text for text, _ in pieces)):
            return [*pieces]
        return marked([*pieces], wanted)


def _lower(text: str) -> str:
    """Return a text of the same length with small letters for A to Z."""
    return "".join(letter.lower() if letter.isascii() else letter for letter in text)


def marked(pieces: list[tuple[str, str]], wanted: str) -> list[tuple[str, str]]:
    """Return the pieces of a line with the tone `match` where it has what is looked for."""
    letters = [(letter, tone) for text, tone in pieces for letter in text]
    lower = _lower("".join(letter for letter, _ in letters))
    at = lower.find(wanted)
    while at >= 0:
        end = at + len(wanted)
        letters[at:end] = [(letter, "match") for letter, _ in letters[at:end]]
        at = lower.find(wanted, end)
    found: list[tuple[str, str]] = []
    for letter, tone in letters:
        if found and found[-1][1] == tone:
            found[-1] = (found[-1][0] + letter, tone)
        else:
            found.append((letter, tone))
    return found
