"""What the nodes print that run."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics.terminal import visible

from .log_view import LogView
from .panel import Panel
from .styles import Line, Piece

_MOST_LINES = 5000


class OutputPanel(LogView):
    """Lines as they are printed, of which the last ones are kept."""

    def begin(self, title: str) -> None:
        """Show what is started, and nothing of what was printed before."""
        self.show(((Piece(title, "quiet"),),))

    def add(self, printed: Iterable[str], end: Piece | None = None) -> None:
        """Show lines that were printed; `end` says how the nodes ended."""
        lines = [*map(_coloured, printed)]
        if end is not None:
            lines.append((end,))
        self.show((*self.lines, *lines)[-_MOST_LINES:], follow=True)


def _coloured(text: str) -> Line:
    shown = visible(text.expandtabs(4))
    lower = shown.lower()
    if "error" in lower or "traceback" in lower:
        return (Piece(shown, "error"),)
    if "warn" in lower:
        return (Piece(shown, "warning"),)
    name, colon, rest = shown.partition(" | ")
    return (Piece(name + colon, "primary"), Piece(rest)) if colon else (Piece(shown),)


OUTPUT = Panel(
    name="output",
    title="Output",
    dock="bottom",
    keys="alt+8",
    summary="What the nodes that run print.",
    about="What the nodes print that F5 started.",
    widget=OutputPanel,
)
