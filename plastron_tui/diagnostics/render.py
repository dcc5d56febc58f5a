"""Diagnostics as text for a terminal, and as data for JSON."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from .data import Diagnostic, Severity, Span
from .lines import LineIndex, Position

Lines = Callable[[Path | None], LineIndex | None]
"""Gives the lines of a file, for a diagnostic without a file those of the program at hand."""

_WIDEST_LINE = 160
_RED, _YELLOW, _BLUE, _BOLD, _PLAIN = "31;1", "33;1", "34;1", "1", "0"


class TextRenderer:
    """Renders diagnostics for people: where it is, the line with the mistake marked, the remedy."""

    def __init__(self, lines: Lines, program: Path | None = None, *, color: bool = False) -> None:
        self._lines = lines
        self._program = program
        self._color = color

    def render(self, diagnostic: Diagnostic) -> str:
        """Return the text of a diagnostic, without a newline at its end."""
        tint = _RED if diagnostic.severity is Severity.ERROR else _YELLOW
        head = self._paint(f"{diagnostic.severity.value}[{diagnostic.code}]", tint)
        out = [f"{head}{self._paint(': ' + printable(diagnostic.message), _BOLD)}"]
        file = diagnostic.file or self._program
        lines = self._lines(diagnostic.file)
        bar = self._paint("|", _BLUE)
        margin = 1
        if diagnostic.span is not None and lines is not None:
            at = lines.position(diagnostic.span.start)
            numbers = [at.line] + [
                lines.position(label.span.start).line for label in diagnostic.labels
            ]
            margin = len(str(max(numbers)))
            where = f"{_shown(file)}:{at.line}:{at.column}"
            out.append(f"{' ' * margin}{self._paint('-->', _BLUE)} {where}")
            out.append(f"{' ' * margin} {bar}")
            out += self._marked(lines, diagnostic.span, "^", "", tint, margin)
            for label in diagnostic.labels:
                out += self._marked(lines, label.span, "-", label.message, _BLUE, margin)
        elif file is not None:
            out.append(f" {self._paint('-->', _BLUE)} {_shown(file)}")
        if diagnostic.help is not None:
            out.append(
                f"{' ' * margin} {self._paint('= help:', _BLUE)} {printable(diagnostic.help)}"
            )
        return "\n".join(out)

    def _marked(
        self, lines: LineIndex, span: Span, mark: str, message: str, tint: str, margin: int
    ) -> list[str]:
        start, end = lines.position(span.start), lines.position(max(span.start, span.end))
        text = lines.line(start.line)
        stop = end.column if end.line == start.line else len(text) + 1
        shown, column, width = _window(text, start, max(1, stop - start.column))
        bar = self._paint("|", _BLUE)
        number = self._paint(str(start.line).rjust(margin), _BLUE)
        marks = self._paint(mark * width + (f" {message}" if message else ""), tint)
        return [
            f"{number} {bar} {printable(shown)}",
            f"{' ' * margin} {bar} {' ' * (column - 1)}{marks}",
        ]

    def _paint(self, text: str, style: str) -> str:
        return f"\x1b[{style}m{text}\x1b[{_PLAIN}m" if self._color else text


def _window(text: str, at: Position, width: int) -> tuple[str, int, int]:
    """Cut a long line to what is around the mark, tabs made spaces so that columns fit."""
    text = text.replace("\t", " ")
    if len(text) <= _WIDEST_LINE:
        return text, at.column, min(width, max(1, len(text) - at.column + 2))
    start = max(0, at.column - 1 - _WIDEST_LINE // 4)
    cut = text[start : start + _WIDEST_LINE]
    prefix = "…" if start else ""
    column = at.column - start + len(prefix)
    return prefix + cut + "…", column, min(width, len(cut) + 1 - (column - len(prefix)) + 1)


def printable(text: str) -> str:
    """Return a text in which nothing can move a terminal's cursor or turn its direction."""
    if text.isprintable():
        return text
    return "".join(character if character.isprintable() else "�" for character in text)


def _shown(file: Path | None) -> str:
    return "<input>" if file is None else printable(str(file))


def as_json(
    diagnostics: Sequence[Diagnostic], lines: Lines, program: Path | None = None
) -> list[dict[str, Any]]:
    """Return diagnostics as JSON's data.

    A diagnostic has `file`, `code`, `severity`, `message`, `range` (null, or `start` and `end`
    with `line` and `column`, both counted from 1, the column in characters), `help`, `fix` (null,
    or `title` and `edits`) and `labels`.
    """

    def place(file: Path | None, span: Span | None) -> dict[str, Any] | None:
        index = lines(file)
        if span is None or index is None:
            return None
        return {
            "start": index.position(span.start)._asdict(),
            "end": index.position(span.end)._asdict(),
        }

    def describe(found: Diagnostic) -> dict[str, Any]:
        file = found.file or program
        fix = None
        if found.fix is not None:
            edits = [
                {"range": place(found.file, edit.span), "text": edit.text}
                for edit in found.fix.edits
            ]
            fix = {"title": found.fix.title, "edits": edits}
        return {
            "file": None if file is None else str(file),
            "code": found.code,
            "severity": found.severity.value,
            "message": found.message,
            "range": place(found.file, found.span),
            "help": found.help,
            "fix": fix,
            "labels": [
                {"range": place(found.file, label.span), "message": label.message}
                for label in found.labels
            ],
        }

    return [describe(found) for found in diagnostics]
