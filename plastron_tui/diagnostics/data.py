"""The diagnostic, its place, and its remedy."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum
from pathlib import Path
from typing import NamedTuple


class Severity(str, Enum):
    """How bad it is. A program with an error generates nothing; a warning stops nothing."""

    ERROR = "error"
    WARNING = "warning"


class Span(NamedTuple):
    """A half-open range of bytes of a file's text."""

    start: int
    end: int

    def moved(self, by: int) -> Span:
        """Return the range so many bytes farther on."""
        return Span(self.start + by, self.end + by)


class Edit(NamedTuple):
    """Replace the bytes of `span` by `text`."""

    span: Span
    text: str


class Fix(NamedTuple):
    """A remedy that can be applied as it is."""

    title: str
    edits: tuple[Edit, ...]


def write(text: str, span: Span) -> Fix:
    """Return the remedy that writes a text in the place of a span."""
    return Fix(f"write `{text}`" if text else "take it away", (Edit(span, text),))


class Label(NamedTuple):
    """A second place that explains the first, such as an earlier declaration."""

    span: Span
    message: str


class Diagnostic(NamedTuple):
    """One mistake.

    Attributes:
        code: the stable name of the kind of mistake, a key of `CODES`.
        message: lower case, no full stop, about the span.
        span: the smallest range that is wrong; None when it is about the file as a whole.
        file: the file that the span lies in; None for a text that has no file yet.
        help: the remedy, in words.
        fix: the remedy, as an edit.
        labels: other places that matter.
        severity: an error unless the code says otherwise.
    """

    code: str
    message: str
    span: Span | None = None
    file: Path | None = None
    help: str | None = None
    fix: Fix | None = None
    labels: tuple[Label, ...] = ()
    severity: Severity = Severity.ERROR

    def moved(self, by: int) -> Diagnostic:
        """Return the mistake in a text that has so many bytes more before it."""
        if not by:
            return self
        return self._replace(
            span=None if self.span is None else self.span.moved(by),
            fix=None
            if self.fix is None
            else Fix(
                self.fix.title,
                tuple(Edit(edit.span.moved(by), edit.text) for edit in self.fix.edits),
            ),
            labels=tuple(Label(label.span.moved(by), label.message) for label in self.labels),
        )


def has_errors(diagnostics: Iterable[Diagnostic]) -> bool:
    """Tell whether any of the diagnostics is an error."""
    return any(diagnostic.severity is Severity.ERROR for diagnostic in diagnostics)
