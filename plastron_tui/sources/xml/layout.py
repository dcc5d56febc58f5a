"""How an XML file is laid out: lines, indentation, quotes, and how empty elements close."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple, TypeVar

from plastron_tui.diagnostics import Span
from plastron_tui.sources.splices import indent_of, line_start

from .document import Element, XmlDocument

_T = TypeVar("_T")

BLANKS = b" \t"
_DEFAULT_INDENT = b"  "


class Style(NamedTuple):
    """What most of a file does.

    Attributes:
        newline: how a line ends.
        unit: by how much an element is indented more than its parent.
        quote: what is around a value.
        close: how an empty element ends, `/>` or ` />`.
        inline: the names of elements that stand in one line with what they hold.
        wraps: whether each attribute begins a line.
    """

    newline: bytes
    unit: bytes
    quote: str
    close: str
    inline: frozenset[str] = frozenset()
    wraps: bool = False


def style_of(document: XmlDocument) -> Style:
    """Learn the style of a file."""
    text = document.text
    newline = b"\r\n" if 2 * text.count(b"\r\n") > text.count(b"\n") else b"\n"
    units: Counter[bytes] = Counter()
    quotes: Counter[str] = Counter()
    closes: Counter[str] = Counter()
    inline: Counter[str] = Counter()
    wrapped = 0
    for element in document.root.walk():
        if element.children:
            is_in_line = text.find(b"\n", *element.span) < 0
            inline[element.name] += 1 if is_in_line else -1
        if element.attributes:
            start = element.attributes[0].span.start
            wrapped += 1 if text.find(b"\n", element.name_span.end, start) >= 0 else -1
        for attribute in element.attributes:
            quotes[text[attribute.span.end - 1 : attribute.span.end].decode()] += 1
        if (close := close_of(document, element)) is not None:
            closes[close] += 1
        parent = document.parents.get(element)
        if parent is not None and (unit := _unit(text, parent, element)):
            units[unit] += 1
    return Style(
        newline,
        _most(units, _DEFAULT_INDENT),
        "'" if quotes["'"] > quotes['"'] else '"',
        _most(closes, "/>"),
        frozenset(name for name, count in inline.items() if count > 0),
        wrapped > 0,
    )


def close_of(document: XmlDocument, element: Element) -> str | None:
    """Return how an empty element ends, None for one that has an end tag."""
    if element.end_tag is not None:
        return None
    end = element.start_tag.end - 2
    return " />" if document.text[end - 1 : end] == b" " else "/>"


def quote_of(document: XmlDocument, element: Element) -> str | None:
    """Return what is around the last value of an element, None where it has no attribute."""
    if not element.attributes:
        return None
    end = element.attributes[-1].span.end
    return document.slice(Span(end - 1, end))


def starts_line(text: bytes, offset: int) -> bool:
    """Tell whether nothing but blanks stands before an offset in its line."""
    start = line_start(text, offset)
    return skip_blanks(text, start) >= offset


def skip_blanks(text: bytes, offset: int) -> int:
    """Return the first offset from one on where no blank is."""
    while offset < len(text) and text[offset] in BLANKS:
        offset += 1
    return offset


def blanks_before(text: bytes, offset: int) -> bytes:
    """Return the blanks that end at an offset."""
    start = offset
    while start and text[start - 1] in BLANKS:
        start -= 1
    return text[start:offset]


def line_break(text: bytes, offset: int) -> Span | None:
    """Return the line break that starts at an offset."""
    for newline in (b"\r\n", b"\n"):
        if text.startswith(newline, offset):
            return Span(offset, offset + len(newline))
    return None


def behind_comments(document: XmlDocument, offset: int) -> int:
    """Return the end of the comments that end the line of an offset, else the offset."""
    text, end = document.text, offset
    comments = {comment.start: comment.end for comment in document.comments}
    while (start := skip_blanks(text, end)) in comments:
        end = comments[start]
        if b"\n" in text[start:end]:
            return offset
    return end if line_break(text, start) is not None else offset


def _unit(text: bytes, parent: Element, child: Element) -> bytes:
    """Return by how much a child is indented more than its parent, b"" where that is not told."""
    outer, inner = parent.span.start, child.span.start
    if not (starts_line(text, outer) and starts_line(text, inner)):
        return b""
    before, after = indent_of(text, outer), indent_of(text, inner)
    return after[len(before) :] if after.startswith(before) else b""


def _most(counts: Counter[_T], default: _T) -> _T:
    return counts.most_common(1)[0][0] if counts else default
