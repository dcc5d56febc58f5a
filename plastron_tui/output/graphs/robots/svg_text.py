"""Texts in the pictures of robots."""

from __future__ import annotations

from xml.sax.saxutils import escape

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.output.graphs.style import number


def escaped(words: str) -> str:
    """Return a text as the content of an element."""
    return escape(visible(words))


def text(kind: str, x: float, baseline: float, words: str) -> str:
    """Return a line of text; `kind` is its class."""
    return f'<text class="{kind}" x="{number(x)}" y="{number(baseline)}">{escaped(words)}</text>'
