"""What ends a statement that has a mistake."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic


class Mistake(Exception):  # noqa: N818 - control flow, from a check to the interpreter
    """The statement at hand has mistakes; without a diagnostic, they follow from another."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        self.diagnostics = diagnostics
