"""What ends a statement that has a mistake."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes


class Mistake(Exception):  # noqa: N818 - control flow, from a check to the interpreter
    """The statement at hand has mistakes; without a diagnostic, they follow from another."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        self.diagnostics = diagnostics


def function_conflict(message: str, remedy: str, where: Span, called: Span | None) -> Mistake:
    """Return the mistake of a function that is called for two things.

    Args:
        message: which.
        remedy: what to write instead.
        where: what asks for the second.
        called: the statement that asked for the first, None for a file.
    """
    labels = () if called is None else (Label(called, "called here"),)
    found = Diagnostic(codes.FUNCTION_CONFLICT, message, where, help=remedy, labels=labels)
    return Mistake(found)
