"""Lines that somebody wrote by hand and a merge does not keep: they are told, one by one."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.source import FileSet, SourceEndpoint, SourceUnit, place_of
from plastron_tui.output.merge3 import changed_lines, split_lines

_WORD = re.compile(rb"\w+")


class LostLine(NamedTuple):
    """A line that was written by hand, and is gone.

    Attributes:
        file: the name of its file in its set.
        number: where it was, from 1.
        span: its bytes.
        text: the line, without the space around it.
    """

    file: str
    number: int
    span: Span
    text: str


def lost_lines(written: FileSet, present: FileSet, merged: FileSet) -> list[LostLine]:
    """Return the lines written by hand that a merge neither keeps nor changes.

    A changed line is one that has every word that was added by hand, wherever it is now.

    Args:
        written: what the program wrote.
        present: the same with what was changed by hand.
        merged: what is made of it.
    """
    lost: list[LostLine] = []
    for name, text in present.texts:
        before, after = written.get(name), merged.get(name)
        if before is not None and after is not None and text not in (before, after):
            lost += _lost_in(name, before, text, after)
    return lost


def dropped_line(mine: FileSet, present: FileSet, merged: FileSet) -> str | None:
    """Return a line that program and hands both keep, and a merge does not; None without one.

    Args:
        mine: what the program makes.
        present: what the files hold, with what was changed by hand.
        merged: what is made of both.
    """
    for name, text in mine.texts:
        before, after = (_telling(each.get(name) or b"") for each in (present, merged))
        dropped = next(iter((_telling(text) & before) - after), None)
        if dropped is not None:
            return dropped.decode("utf-8", "replace")
    return None


def _telling(text: bytes) -> Counter[bytes]:
    """Return the lines of a text that have a word, wherever they stand."""
    return Counter(line.strip() for line in split_lines(text) if _WORD.search(line))


def _lost_in(name: str, written: bytes, present: bytes, merged: bytes) -> Iterator[LostLine]:
    base, lines, result = (split_lines(text) for text in (written, present, merged))
    new = Counter(each.strip() for each in result)
    gone = Counter(each.strip() for each in lines) - new
    new -= Counter(each.strip() for each in lines)
    changed = [Counter(_WORD.findall(line)) for line in new.elements()]
    start = [0]
    for line in lines:
        start.append(start[-1] + len(line))
    for first, last, at, end in changed_lines(base, lines):
        added = _words(lines[at:end]) - _words(base[first:last])
        for index in range(at, end):
            line = lines[index].strip()
            own = Counter(_WORD.findall(line)) & added
            added -= own
            if not own or not gone[line]:
                continue
            gone[line] -= 1
            if not _is_in(own, changed):
                begin = start[index] + lines[index].index(line)
                span = Span(begin, begin + len(line))
                yield LostLine(name, index + 1, span, line.decode("utf-8", "replace"))


def _words(lines: Iterable[bytes]) -> Counter[bytes]:
    return Counter(word for line in lines for word in _WORD.findall(line))


def _is_in(words: Counter[bytes], lines: list[Counter[bytes]]) -> bool:
    """Tell whether a line has some words, or all lines together: a call may be wrapped."""
    return any(words <= line for line in lines) or words <= sum(lines, Counter())


def tell_lost(path: Path, source: SourceUnit, lost: Iterable[LostLine]) -> tuple[Diagnostic, ...]:
    """Warn of each line that is lost, with the endpoint whose call has it.

    Args:
        path: the main file, as people know it.
        source: the file as it was.
        lost: the lines.
    """
    return tuple(_told(path, source, line) for line in lost)


def _told(path: Path, source: SourceUnit, line: LostLine) -> Diagnostic:
    found = next((each for each in source.endpoints if _has(each, line, source)), None)
    of = "" if found is None else f" of the {found.kind.word} `{found.name or found.expression}`"
    main = line.file == source.files.names[0]
    return Diagnostic(
        codes.MERGED_BY_HAND,
        f"line {line.number}{of} was written by hand, and is not kept: `{line.text}`",
        file=path if main else place_of(path, line.file),
        help="write it again where it is still to be",
    )


def _has(endpoint: SourceEndpoint, line: LostLine, source: SourceUnit) -> bool:
    is_same_file = (endpoint.file or source.files.names[0]) == line.file
    return (
        is_same_file and endpoint.span.start < line.span.end and line.span.start < endpoint.span.end
    )
