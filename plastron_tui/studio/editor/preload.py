"""What the editor needs beside a text on the screen: it is imported when there is one to see.

To import what completes words and explains statements takes longer than to show the first key. So
a thread does it after the first frame, and until then nothing is offered or explained.
"""

from __future__ import annotations

from importlib import import_module
from threading import Event

_MODULES = (
    *("plastron_tui.studio.editor.completion", "plastron_tui.studio.editor.statement_help"),
    "plastron_tui.studio.editor.vocabulary",
    *("plastron_tui.project.configuration", "plastron_tui.project.loader"),
    "plastron_tui.sources.python.language",
)

_is_done = Event()


def preload() -> None:
    """Import it, and what it takes to ask what a program means; in whatever thread."""
    for name in _MODULES:
        import_module(name)
    _is_done.set()


def is_preloaded() -> bool:
    """Tell whether it is there."""
    return _is_done.is_set()
