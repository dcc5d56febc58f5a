"""Comments above parts of a robot that are taken away: whether they go along."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.sources.splices import line_start
from plastron_tui.sources.xml.document import Element, XmlDocument
from plastron_tui.sources.xml.layout import behind_comments, blanks_before, starts_line

_WORD = re.compile(r"[^\W_]+")
_NOISE = frozenset(("a", "an", "and", "joint", "joints", "link", "links", "material", "the"))
"""What is in a comment besides names."""


class Heading(NamedTuple):
    """Comments right above a part that is taken away, and above nothing that stays.

    Attributes:
        start: where the first line of them starts.
        span: the last of them.
        part: the part.
        goes: whether they say nothing but names of what goes.
    """

    start: int
    span: Span
    part: Element
    goes: bool


def above_comments(document: XmlDocument, start: int) -> int:
    """Return the start of the line of an element, or of the comments right above it."""
    found = _right_above(document, line_start(document.text, start))
    return line_start(document.text, found[0].start) if found else line_start(document.text, start)


def headings(document: XmlDocument, gone: Iterable[Element]) -> Iterator[Heading]:
    """Yield the comments above parts that go, unless they head a part that stays as well.

    A part stands under the comments above an earlier one if neither an empty line nor another
    comment is between them.
    """
    siblings, taken = document.root.children, set(gone)
    for at, element in enumerate(siblings):
        if element not in taken or not starts_line(document.text, element.span.start):
            continue
        first = line_start(document.text, element.span.start)
        comments = _right_above(document, first)
        if not comments:
            continue
        group = _group(document, siblings, at)
        if all(each in taken for each in group):
            start = line_start(document.text, comments[0].start)
            text = " ".join(document.slice(each)[4:-3] for each in comments)
            yield Heading(start, comments[-1], element, _names_only(text, group))


def _right_above(document: XmlDocument, first: int) -> list[Span]:
    """Return the comments on lines of their own that end right above a line."""
    text, at = document.text, first
    comments = {each.end: each for each in document.comments}
    found: list[Span] = []
    while at:
        end = at - (2 if text[:at].endswith(b"\r\n") else 1)
        end -= len(blanks_before(text, end))
        comment = comments.get(end)
        if comment is None or not starts_line(text, comment.start):
            break
        found.insert(0, comment)
        at = line_start(text, comment.start)
    return found


def _group(document: XmlDocument, siblings: Sequence[Element], at: int) -> list[Element]:
    """Return a part, and those that stand under the same comment."""
    group = [siblings[at]]
    for after in siblings[at + 1 :]:
        end = behind_comments(document, group[-1].span.end)
        if document.text[end : after.span.start].strip() or (
            document.text.count(b"\n", end, after.span.start) > 1
        ):
            break
        group.append(after)
    return group


def _names_only(text: str, group: Sequence[Element]) -> bool:
    """Tell whether a comment says some names of parts, and nothing else."""
    said = {*_WORD.findall(text.casefold())} - _NOISE
    names = " ".join(each.get("name") or "" for each in group).replace("_", " ")
    return bool(said) and said <= {*_WORD.findall(names.casefold())}
