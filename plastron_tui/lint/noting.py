"""Writing comments that say that what is found is meant, without changing what a file says."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import LineIndex, Span
from plastron_tui.sources.splices import Splice, apply, line_start, newline_of

from .comment_syntax import CommentStyle, comment_spans, style_of, tag_at
from .suppression import Comment, comments_of, with_codes


class Noted(NamedTuple):
    """A text with comments.

    Attributes:
        text: the text.
        done: how many of what was asked are noted.
    """

    text: bytes
    done: int


def with_comments(file: Path, text: bytes, asked: Sequence[tuple[Span, str]]) -> Noted:
    """Return a text with comments for what breaks rules in it.

    A comment stands behind the first line of its place, or the last one; in XML also in a line of
    its own above the tag. What can get none, since the line goes on or ends within a string, is
    left.

    Args:
        file: the file, whose name tells how comments are written.
        text: what it holds.
        asked: places, each with the code of the rule that it breaks.
    """
    style = style_of(file, text)
    if style is None:
        return Noted(text, 0)
    count = 0
    waiting = sorted(dict.fromkeys(asked), key=lambda each: (each[0].start, each[1]))
    for at, (span, code) in enumerate(waiting):
        if any(_is_noted(each, code) for each in _comments_about(file, text, span)):
            count += 1
            continue
        for splice in _places(style, file, text, span, code):
            changed = apply(text, [splice])
            if _says_the_same(style, text, changed, splice):
                text = changed
                count += 1
                waiting[at + 1 :] = [(_moved(s, splice), c) for s, c in waiting[at + 1 :]]
                break
    return Noted(text, count)


def _moved(span: Span, splice: Splice) -> Span:
    """Return a place as it is once something was inserted."""
    by = len(splice.text)
    start = span.start + by * (splice.start <= span.start)
    return Span(start, max(start, span.end + by * (splice.start < span.end)))


def _places(
    style: CommentStyle, file: Path, text: bytes, span: Span, code: str
) -> Iterator[Splice]:
    """Yield what may be inserted for a place, the best first."""
    for comment in _comments_about(file, text, span):
        # A comment that begins lines has another one that ends them, with the same codes.
        is_pair = style is CommentStyle.CPP and comment.first != comment.last
        if comment.codes is not None and not is_pair:
            place, more = with_codes(comment, code, style)
            yield Splice(place, place, more.encode())
    for offset in dict.fromkeys((span.start, max(span.start, span.end - 1))):
        end = text.find(b"\n", offset)
        end = len(text) if end < 0 else end
        if text[end - 1 : end] == b"\r":
            end -= 1
        # Compilers of C++ do not mind blanks behind the backslash.
        if not text[:end].rstrip(b" \t").endswith(b"\\"):
            yield Splice(end, end, f"  {style.comment(code)}".encode())
    if style is CommentStyle.XML:
        yield from _above_tag(text, span, code)


def _comments_about(file: Path, text: bytes, span: Span) -> list[Comment]:
    """Return the comments about rules that are about a place."""
    lines = LineIndex(text)
    return [each for each in comments_of(file, text, lines) if each.covers(lines, span)]


def _is_noted(comment: Comment, code: str) -> bool:
    return comment.codes is None or any(word.upper() == code for word, _ in comment.codes)


def _above_tag(text: bytes, span: Span, code: str) -> Iterator[Splice]:
    """Yield the comment in a line of its own above the tag that has a place."""
    tag = tag_at(text, span.start)
    if tag is None:
        return
    start = line_start(text, tag.start)
    indent = text[start : tag.start]
    if not indent.strip():
        comment = CommentStyle.XML.comment(code).encode()
        yield Splice(start, start, indent + comment + newline_of(text))


def _says_the_same(style: CommentStyle, before: bytes, after: bytes, splice: Splice) -> bool:
    """Tell whether a text says what it said before a comment was inserted, or made longer."""
    start, end = splice.start, splice.start + len(splice.text)
    old, new = _comments(style, before), _comments(style, after)
    gone, come = old - new, new - old
    if sum(gone.values()) > 1 or sum(come.values()) != 1:
        return False
    spans = (s for s in comment_spans(style, after) if s.start < end and start < s.end)
    touched = next(spans, None)
    inside = splice.text.strip()
    at = start + splice.text.find(inside)
    if touched is None or not (touched.start <= at and at + len(inside) <= touched.end):
        return False
    if gone and style is CommentStyle.XML and inside.startswith(b"<!--"):
        return False
    events = {CommentStyle.YAML: _yaml_events, CommentStyle.XML: _xml_events}.get(style)
    if events is None:
        return True
    read = events(before)
    return read is not None and read == events(after)


def _comments(style: CommentStyle, text: bytes) -> Counter[bytes]:
    return Counter(text[span.start : span.end] for span in comment_spans(style, text))


def _xml_events(text: bytes) -> list[tuple[str, object]] | None:
    """Return what a text of XML says, without comments and blanks; None where it is none."""
    from xml.parsers.expat import ExpatError, ParserCreate

    found: list[tuple[str, object]] = []
    parser = ParserCreate()
    parser.StartElementHandler = lambda name, attributes: found.append((name, attributes))
    parser.EndElementHandler = lambda name: found.append((name, None))
    parser.CharacterDataHandler = lambda said: found.extend(("", word) for word in said.split())
    try:
        parser.Parse(text, True)
    except ExpatError:
        return None
    return found


def _yaml_events(text: bytes) -> list[tuple[str, object]] | None:
    import yaml

    try:
        return [
            (type(each).__name__, getattr(each, "value", getattr(each, "anchor", None)))
            for each in yaml.parse(text.decode(), Loader=yaml.SafeLoader)
        ]
    except (yaml.YAMLError, ValueError, RecursionError):
        return None
