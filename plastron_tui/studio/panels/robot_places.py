"""Where the parts of a loaded robot stand in its file, and what is wrong there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, LineIndex, Span
from plastron_tui.sources.urdf.reader import read_urdf

from .entry import Subject

if TYPE_CHECKING:
    from plastron_tui.model.robots import RobotSource

Part = tuple[Subject, str]


def place_of(source: RobotSource, part: Part) -> str:
    """Return the file of a part, with its line where the file says the part outright."""
    file = source.path.name
    # What the program wrote into the file has other lines than what it started from.
    span = _spans_of(source.text).get(part) if source.origin is None else None
    if span is None:
        return file
    return f"{file}, line {_lines_of(source.text).position(span.start).line}"


def faults_in(source: RobotSource, diagnostics: Iterable[Diagnostic]) -> dict[Part, str]:
    """Return the first of what is wrong with each part in its file."""
    found: dict[Part, str] = {}
    own = [each for each in diagnostics if each.file == source.path]
    spans = _spans_of(source.text) if own and source.origin is None else {}
    for each in own:
        for part, span in spans.items():
            if each.span is not None and span.start <= each.span.start < span.end:
                found.setdefault(part, each.message)
    return found


@lru_cache(maxsize=4)
def _spans_of(text: bytes) -> Mapping[Part, Span]:
    """Return where the links and joints of a file are."""
    places = read_urdf(text).places
    found = {(Subject.LINK, name): each for name, each in places.links.items()}
    found |= {(Subject.JOINT, name): each for name, each in places.joints.items()}
    return {part: Span(each.span.start, each.span.end) for part, each in found.items()}


@lru_cache(maxsize=4)
def _lines_of(text: bytes) -> LineIndex:
    return LineIndex(text)
