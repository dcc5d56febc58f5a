"""Entries of docstrings that list endpoints: `- /scan (LaserScan): what is around`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import Change, EndpointKind, Remove

from .analysis import Analysis
from .generated import is_docstring
from .splices import Splice, line_end, line_start
from .syntax import parts_of

_BULLET = re.compile(rb"[ \t]*(?:[-*+]|\xe2\x80\xa2)[ \t]+")
_QUOTES = rb"[`'\"*]*"
# The type of an endpoint, and what leads to the words about it.
_TYPE = rb"(?:[ \t]*[(\[].*[)\]])?"
_LEADING = rb"[ \t]*(?::(?!\w)|--?[ \t]|\xe2\x80[\x93\x94][ \t])"
_PLAIN_ENTRY = re.compile(rb"[ \t]*[\w~/`'\"]+%s%s" % (_TYPE, _LEADING))
# What a list of such endpoints is headed by.
_HEADINGS = {
    EndpointKind.PUBLISHER: re.compile(rb"publi|\btopics?\b|\boutputs?\b", re.IGNORECASE),
    EndpointKind.SUBSCRIPTION: re.compile(rb"subscri|\btopics?\b|\binputs?\b", re.IGNORECASE),
    EndpointKind.SERVICE: re.compile(rb"\bservices?\b|\bservers?\b", re.IGNORECASE),
    EndpointKind.CLIENT: re.compile(rb"\bclients?\b|\bservices?\b", re.IGNORECASE),
}


def gone_entries(after: Analysis, changes: Sequence[Change]) -> list[Splice]:
    """Return what takes the endpoints that are removed out of the lists of docstrings.

    Args:
        after: the file as it is.
        changes: what was asked for.
    """
    left = {(each.endpoint.name or "").lstrip("~/") for each in after.sites}
    found: list[Splice] = []
    for change in changes:
        bare = change.name.lstrip("~/") if isinstance(change, Remove) else ""
        if isinstance(change, Remove) and bare not in left and change.kind in _HEADINGS:
            for text in _docstrings(after):
                found += _entries(after.syntax.text, text, bare, _HEADINGS[change.kind])
    return found


def _docstrings(analysis: Analysis) -> Iterator[Node]:
    """Yield the docstrings of the module and of its classes."""
    for scope in (analysis.scopes.module, *analysis.scopes.classes()):
        block = scope.node.child_by_field_name("body") if scope.parent is not None else scope.node
        first = next(iter(parts_of(block)), None)
        if first is not None and is_docstring(first):
            yield first


class _Line(NamedTuple):
    """A line of a docstring.

    Attributes:
        start: where it begins.
        end: where it ends, with its line ending.
        text: what it says.
    """

    start: int
    end: int
    text: bytes

    @property
    def indent(self) -> int:
        """How many characters are before its first word."""
        return len(self.text) - len(self.text.lstrip())

    @property
    def is_blank(self) -> bool:
        """Whether it says nothing."""
        return not self.text.strip()

    @property
    def is_bulleted(self) -> bool:
        """Whether it begins with a bullet."""
        return _BULLET.match(self.text) is not None


def _entries(text: bytes, docstring: Node, bare: str, wanted: re.Pattern[bytes]) -> list[Splice]:
    """Return what takes the entries of a name out of the lists of a docstring."""
    name = rb"%s[~/]*%s%s" % (_QUOTES, re.escape(bare.encode()), _QUOTES)
    bulleted = re.compile(rb"%s%s(?:[ \t]*[(\[]|%s|\s*$)" % (_BULLET.pattern, name, _LEADING))
    plain = re.compile(rb"[ \t]*%s%s%s" % (name, _TYPE, _LEADING))
    # The first line and the last one have the quotes.
    lines = _lines(text, docstring)[1:-1]
    found = []
    for at, line in enumerate(lines):
        if not (bulleted if line.is_bulleted else plain).match(line.text):
            continue
        heading, last = _heading(lines, at), _last(lines, at)
        if heading is None or last is None or wanted.search(lines[heading].text) is None:
            continue
        first = at
        is_first = at == 0 or lines[at - 1].is_blank or at - 1 == heading
        while is_first and last + 2 < len(lines) and lines[last + 1].is_blank:
            last += 1
        if _is_alone(lines, heading, at, last):
            is_apart = heading > 0 and lines[heading - 1].is_blank
            is_end = last + 1 == len(lines) or lines[last + 1].is_blank
            first = heading - 1 if is_apart and is_end else heading
        found.append(Splice(lines[first].start, lines[last].end))
    return found


def _lines(text: bytes, docstring: Node) -> list[_Line]:
    found = []
    at = line_start(text, docstring.start_byte)
    while at < docstring.end_byte:
        end = line_end(text, at)
        found.append(_Line(at, end, text[at:end]))
        at = end
    return found


def _is_entry(line: _Line, like: _Line) -> bool:
    """Whether a line begins an entry of the list that another one is an entry of."""
    is_alike = line.indent == like.indent and line.is_bulleted == like.is_bulleted
    return is_alike and (line.is_bulleted or _PLAIN_ENTRY.match(line.text) is not None)


def _heading(lines: Sequence[_Line], at: int) -> int | None:
    """Return the line that heads the list of an entry."""
    entry = lines[at]
    for above in range(at - 1, -1, -1):
        line = lines[above]
        is_outer = line.indent < entry.indent
        is_beside = line.indent == entry.indent and entry.is_bulleted and not line.is_bulleted
        # Otherwise it goes on with the entry above it.
        is_first = above == 0 or lines[above - 1].is_blank or line.text.rstrip().endswith(b":")
        if not line.is_blank and (is_outer or (is_beside and is_first)):
            return above
    return None


def _last(lines: Sequence[_Line], at: int) -> int | None:
    """Return the last line of an entry, None where that is not sure."""
    entry, last, is_open = lines[at], at, False
    for below in range(at + 1, len(lines)):
        line = lines[below]
        if not line.is_blank and line.indent > entry.indent:
            last = below
        elif _is_entry(line, entry):
            return last
        elif line.indent < entry.indent or line.is_blank or last + 1 < below:
            # What follows a list with bullets may as well be a text of its own.
            if is_open or not line.is_blank:
                break
        else:
            is_open, last = entry.is_bulleted, below
    return None if is_open else last


def _is_alone(lines: Sequence[_Line], heading: int, at: int, last: int) -> bool:
    """Whether an entry is all that a heading heads."""
    entry = lines[at]
    is_first = all(line.is_blank for line in lines[heading + 1 : at])
    below = next((line for line in lines[last + 1 :] if not line.is_blank), None)
    return is_first and (below is None or not _is_entry(below, entry))
