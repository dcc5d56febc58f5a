"""The diagnostic, its place, and its remedy."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from .severity import Severity
from .wording import shortened

if TYPE_CHECKING:
    from .code import Code


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


def write_before(line: str, span: Span) -> Fix:
    """Return the remedy that writes a line before the statement of a span."""
    return Fix(f"write `{line}` before", (Edit(Span(span.start, span.start), f"{line}\n"),))


class Label(NamedTuple):
    """A second place that explains the first, such as an earlier declaration.

    Attributes:
        span: the place.
        message: what is there.
        file: the file that it lies in, None for that of the diagnostic.
    """

    span: Span
    message: str
    file: Path | None = None


class _Parts(NamedTuple):
    code: Code
    message: str
    span: Span | None
    file: Path | None
    help: str | None
    fix: Fix | None
    labels: tuple[Label, ...]
    severity: Severity


class Diagnostic(_Parts):
    """One mistake.

    Its texts have at most `LONGEST_TEXT` bytes: what a file of somebody else's holds may have a
    name of any length.

    Attributes:
        code: the kind of mistake, one of `codes`.
        message: lower case, no full stop, about the span.
        span: the smallest range that is wrong; None when it is about the file as a whole.
        file: the file that the span lies in; None for a text that has no file yet.
        help: the remedy, in words.
        fix: the remedy, as an edit.
        labels: other places that matter.
        severity: as the code says, unless said otherwise.
    """

    __slots__ = ()

    def __new__(
        cls,
        code: Code,
        message: str,
        span: Span | None = None,
        file: Path | None = None,
        help: str | None = None,  # noqa: A002 - the name that it has in JSON
        fix: Fix | None = None,
        labels: tuple[Label, ...] = (),
        severity: Severity | None = None,
    ) -> Diagnostic:
        """Make a mistake; a text that is too long is cut."""
        message = shortened(message)
        severity = code.severity if severity is None else severity
        help = None if help is None else shortened(help)  # noqa: A001
        if fix is not None:
            fix = fix._replace(title=shortened(fix.title))
        labels = tuple([label._replace(message=shortened(label.message)) for label in labels])
        return super().__new__(cls, code, message, span, file, help, fix, labels, severity)

    @classmethod
    def _make(cls, iterable: Iterable[Any]) -> Diagnostic:  # type: ignore[override]
        # What `_replace` puts in is cut too.
        return cls(*iterable)

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
            labels=tuple(
                label if label.file else label._replace(span=label.span.moved(by))
                for label in self.labels
            ),
        )


def has_errors(diagnostics: Iterable[Diagnostic]) -> bool:
    """Tell whether any of the diagnostics is an error."""
    return any(diagnostic.severity is Severity.ERROR for diagnostic in diagnostics)
