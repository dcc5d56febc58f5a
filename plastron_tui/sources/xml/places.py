"""Where an element is written, and what goes with one that is taken away.

What is written at a place of these is taken away by `removal` with every byte that came with it.
"""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.sources.splices import Splice, indent_of, line_start

from .document import Element, XmlDocument
from .layout import (
    Style,
    behind_comments,
    blanks_before,
    close_of,
    line_break,
    skip_blanks,
    starts_line,
)
from .new_element import NewElement, render


def after(document: XmlDocument, anchor: Span, new: NewElement, style: Style) -> Splice:
    """Write an element behind something.

    Args:
        document: the file.
        anchor: an element, comment or instruction, or the empty range at the end of a text.
        new: what is to be written.
        style: how.
    """
    text = document.text
    end = behind_comments(document, anchor.end)
    rest = skip_blanks(text, end)
    if not starts_line(text, anchor.start):
        return _inserted(end, blanks_before(text, anchor.start) + render(new, style, None))
    indent = indent_of(text, anchor.start)
    on_own_line = style.newline + indent + render(new, style, indent)
    if line_break(text, rest) is not None:
        return _inserted(rest, on_own_line)
    if text.startswith(b"</", rest):
        return _inserted(end, on_own_line)
    return _inserted(end, text[end:rest] + render(new, style, None))


def before(document: XmlDocument, anchor: Span, new: NewElement, style: Style) -> Splice:
    """Write an element before another one; the arguments are those of `after`."""
    text, start = document.text, anchor.start
    if starts_line(text, start):
        indent = indent_of(text, start)
        return _inserted(
            line_start(text, start), indent + render(new, style, indent) + style.newline
        )
    blanks = blanks_before(text, start)
    written = render(new, style, None)
    if text[start - len(blanks) - 1 : start - len(blanks)] != b">":
        return _inserted(start, written)
    return _inserted(start - len(blanks), blanks + written)


def last(document: XmlDocument, parent: Element, new: NewElement, style: Style) -> Splice:
    """Write an element behind all that another one holds."""
    text = document.text
    if parent.end_tag is None:
        return _opened(document, parent, new, style)
    start, end = parent.content
    content = text[start:end]
    if content.strip():
        end = start + len(content.rstrip())
        held = (*(child.span for child in parent.children), *document.comments)
        spans = (*held, *document.instructions)
        anchor = next((span for span in spans if span.end == end), Span(end, end))
        return after(document, anchor, new, style)
    found = content.find(b"\n")
    if found < 0:
        return _inserted(start, render(new, style, None))
    indent = indent_of(text, parent.span.start) + style.unit
    return _inserted(start + found + 1, indent + render(new, style, indent) + style.newline)


def removal(
    document: XmlDocument, element: Element, style: Style, *, closes: bool = True
) -> Splice:
    """Take an element away; `closes` lets the parent of an only child close itself."""
    text = document.text
    start, end = element.span
    if not starts_line(text, start):
        blanks = blanks_before(text, start)
        closed = _closed_in_line(document, element, style) if closes else None
        if closed is not None:
            return closed
        is_behind_tag = text[start - len(blanks) - 1 : start - len(blanks)] == b">"
        return Splice(start - len(blanks) if is_behind_tag else start, end)
    first = line_start(text, start)
    rest = skip_blanks(text, behind_comments(document, end))
    if (found := line_break(text, rest)) is not None:
        closed = _closed(document, element, style) if closes else None
        return closed or Splice(first, found.end)
    if text.startswith(b"</", rest):
        broken = first - 2 if text[:first].endswith(b"\r\n") else first - 1
        return Splice(broken, end)
    return Splice(start, skip_blanks(text, end))


def _opened(document: XmlDocument, parent: Element, new: NewElement, style: Style) -> Splice:
    """Write an element into one that closes itself."""
    text, end = document.text, parent.start_tag.end
    start = end - len(b"/>")
    start -= blanks_before(text, start) == b" "
    if not starts_line(text, parent.span.start) or parent.name in style.inline:
        written = render(new, style, None)
        return Splice(start, end, b">" + written + f"</{parent.name}>".encode())
    indent = indent_of(text, parent.span.start)
    inner = indent + style.unit
    written = style.newline + inner + render(new, style, inner) + style.newline + indent
    return Splice(start, end, b">" + written + f"</{parent.name}>".encode())


def _closed_in_line(document: XmlDocument, element: Element, style: Style) -> Splice | None:
    """Let the parent of an only child close itself where both stand within a line."""
    parent = document.parents[element]
    if parent.content != element.span or starts_line(document.text, parent.span.start):
        return None
    return Splice(parent.start_tag.end - 1, parent.span.end, _own_close(document, element, style))


def _own_close(document: XmlDocument, element: Element, style: Style) -> bytes:
    """Return how the parent of an element closes itself without it."""
    at = document.parents[element].start_tag.end - 1
    inner = next((c for one in element.walk() if (c := close_of(document, one))), style.close)
    return b"/>" if document.text[at - 1 : at].isspace() else inner.encode()


def _closed(document: XmlDocument, element: Element, style: Style) -> Splice | None:
    """Let the parent of an only child close itself, None where there is more in the parent."""
    text, parent = document.text, document.parents[element]
    head = line_break(text, parent.content.start)
    tail = line_break(text, element.span.end)
    if head is None or tail is None or parent.end_tag is None:
        return None
    if skip_blanks(text, head.end) != element.span.start:
        return None
    if skip_blanks(text, tail.end) != parent.content.end:
        return None
    return Splice(parent.start_tag.end - 1, parent.span.end, _own_close(document, element, style))


def _inserted(at: int, new: bytes) -> Splice:
    return Splice(at, at, new)
