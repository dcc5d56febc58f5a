"""What ends a statement that has a mistake."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic


class Mistake(Exception):  # noqa: N818 - control flow, from a check to the interpreter
    """The statement at hand has a mistake; without a diagnostic, it follows from another."""

    def __init__(self, diagnostic: Diagnostic | None = None) -> None:
        self.diagnostic = diagnostic
