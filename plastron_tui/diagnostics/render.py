"""Diagnostics as text for a terminal, and as data for JSON."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import accumulate
from pathlib import Path
from typing import Any, NamedTuple

from .data import Diagnostic, Label, Span
from .lines import LineIndex
from .severity import Severity
from .terminal import visible
from .terminal import width as cell_width
from .wording import shortened

Lines = Callable[[Path | None], LineIndex | None]
"""Gives the lines of a file, for a diagnostic without a file those of the program at hand."""

_WIDEST_LINE = 160
_RED, _YELLOW, _BLUE, _BOLD, _PLAIN = "31;1", "33;1", "34;1", "1", "0"


class _Mark(NamedTuple):
    """A part of a line that is underlined: columns count from 1, `stop` is the first after it."""

    line: int
    column: int
    stop: int
    sign: str
    message: str


class TextRenderer:
    """Renders diagnostics for people: where it is, the line with the mistake marked, the remedy."""

    def __init__(self, lines: Lines, program: Path | None = None, *, color: bool = False) -> None:
        self._lines = cache(lines)
        self._program = program
        self._color = color

    def render(self, diagnostic: Diagnostic) -> str:
        """Return the text of a diagnostic, without a newline at its end."""
        if diagnostic.severity is Severity.NOTE:
            return f"{self._paint('note', _BLUE)}: {_said(diagnostic.message)}"
        tint = _RED if diagnostic.severity is Severity.ERROR else _YELLOW
        head = self._paint(f"{diagnostic.severity.value}[{diagnostic.code}]", tint)
        out = [head + self._paint(f": {_said(diagnostic.message)}", _BOLD)]
        file = diagnostic.file or self._program
        lines = self._lines(diagnostic.file)
        margin = 1
        if diagnostic.span is not None and lines is not None:
            marks = _marks(diagnostic, lines)
            margin = len(str(max(mark.line for mark in marks)))
            at = lines.position(diagnostic.span.start)
            where = f"{_shown(file)}:{at.line}:{at.column}"
            out.append(f"{' ' * margin}{self._paint('-->', _BLUE)} {where}")
            out += self._excerpt(lines, marks, margin, tint)
            for label in diagnostic.labels:
                out += self._elsewhere(label, margin)
        elif file is not None:
            out.append(f" {self._paint('-->', _BLUE)} {_shown(file)}")
        if diagnostic.help is not None:
            sign = self._paint("= help:", _BLUE)
            out.append(f"{' ' * margin} {sign} {_said(diagnostic.help)}")
        return "\n".join(out)

    def _excerpt(
        self, lines: LineIndex, marks: Sequence[_Mark], margin: int, tint: str
    ) -> Iterator[str]:
        """Yield the lines that are marked, in the order of the file, each once."""
        bar = self._paint("|", _BLUE)
        yield f"{' ' * margin} {bar}"
        before = marks[0].line
        window = _Window("", 1)
        for index, mark in enumerate(marks):
            if index == 0 or mark.line != before:
                if mark.line > before + 1:
                    yield self._paint("...", _BLUE)
                window = _Window(lines.line(mark.line), mark.column)
                number = self._paint(str(mark.line).rjust(margin), _BLUE)
                yield f"{number} {bar} {window.text}".rstrip()
                before = mark.line
            start, width = window.cells(mark.column, mark.stop)
            note = f" {_said(mark.message)}" if mark.message else ""
            signs = self._paint(mark.sign * width + note, tint if mark.sign == "^" else _BLUE)
            yield f"{' ' * margin} {bar} {' ' * start}{signs}"

    def _elsewhere(self, label: Label, margin: int) -> Iterator[str]:
        """Yield the lines of a second place in another file."""
        lines = None if label.file is None else self._lines(label.file)
        if lines is None:
            return
        start, end = lines.position(label.span.start), lines.position(label.span.end)
        stop = end.column if end.line == start.line else len(lines.line(start.line)) + 1
        sign = self._paint(":::", _BLUE)
        yield f"{' ' * margin}{sign} {_shown(label.file)}:{start.line}:{start.column}"
        mark = _Mark(start.line, start.column, stop, "-", label.message)
        yield from self._excerpt(lines, [mark], max(margin, len(str(start.line))), _BLUE)

    def _paint(self, text: str, style: str) -> str:
        return f"\x1b[{style}m{text}\x1b[{_PLAIN}m" if self._color else text


def _marks(diagnostic: Diagnostic, lines: LineIndex) -> list[_Mark]:
    """Return what is underlined, in the order of the file; of several lines the first."""
    assert diagnostic.span is not None
    places = [(diagnostic.span, "^", "")]
    places += [(each.span, "-", each.message) for each in diagnostic.labels if each.file is None]
    marks = []
    for span, sign, message in places:
        start, end = lines.position(span.start), lines.position(span.end)
        stop = end.column if end.line <= start.line else len(lines.line(start.line)) + 1
        marks.append(_Mark(start.line, start.column, stop, sign, message))
    return sorted(marks)


class _Window:
    """A line as it is shown: a long one is cut to what is around a column."""

    def __init__(self, line: str, column: int) -> None:
        # A tab is a space, so that its width does not depend on where the line starts.
        line = line.replace("\t", " ")
        start = 0
        if len(line) > _WIDEST_LINE:
            start = max(0, min(column - 1 - _WIDEST_LINE // 4, len(line) - _WIDEST_LINE))
        cut = [visible(each) for each in line[start : start + _WIDEST_LINE]]
        before = "…" if start else ""
        after = "…" if start + _WIDEST_LINE < len(line) else ""
        self.text = before + "".join(cut) + after
        self._first = start + 1
        self._ends = [len(before), *accumulate(map(cell_width, cut), initial=len(before))][1:]

    def cells(self, column: int, stop: int) -> tuple[int, int]:
        """Return where a part of the line starts, in terminal cells, and how wide it is."""
        last = len(self._ends) - 1
        start = self._ends[min(max(column - self._first, 0), last)]
        end = self._ends[min(max(stop - self._first, 0), last)]
        return start, max(1, end - start)


def _said(text: str) -> str:
    """Return a text as it is shown; what is escaped is longer than it was."""
    return shortened(visible(text))


def _shown(file: Path | None) -> str:
    return "<input>" if file is None else _said(str(file))


def as_json(
    diagnostics: Sequence[Diagnostic], lines: Lines, program: Path | None = None
) -> list[dict[str, Any]]:
    """Return diagnostics as JSON's data.

    A diagnostic has `file`, `code`, `severity`, `message`, `range` (null, or `start` and `end`
    with `line` and `column`, both counted from 1, the column in characters), `help`, `fix` (null,
    or `title` and `edits`) and `labels`.
    """
    lines = cache(lines)
    return [_describe(found, lines, found.file or program) for found in diagnostics]


def _describe(found: Diagnostic, lines_of: Lines, file: Path | None) -> dict[str, Any]:
    lines = lines_of(found.file)

    def place(span: Span | None, lines: LineIndex | None = lines) -> dict[str, Any] | None:
        if span is None or lines is None:
            return None
        return {
            "start": lines.position(span.start)._asdict(),
            "end": lines.position(span.end)._asdict(),
        }

    fix = None
    if found.fix is not None:
        edits = [{"range": place(edit.span), "text": edit.text} for edit in found.fix.edits]
        fix = {"title": found.fix.title, "edits": edits}
    return {
        "file": None if file is None else str(file),
        "code": found.code,
        "severity": found.severity.value,
        "message": found.message,
        "range": place(found.span),
        "help": found.help,
        "fix": fix,
        "labels": [
            {"range": place(label.span), "message": label.message}
            if label.file is None
            else {
                "range": place(label.span, lines_of(label.file)),
                "message": label.message,
                "file": str(label.file),
            }
            for label in found.labels
        ],
    }
