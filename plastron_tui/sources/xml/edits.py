"""Changes of an XML file: each is one splice, and the file is read again after it.

They are made in the style of the file, or in a given one: that of the file which it is a part of.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.splices import Splice, apply, indent_of

from .document import Element, XmlDocument, read_xml
from .layout import Style, close_of, quote_of, starts_line, style_of
from .new_element import NewElement, encoded, escaped_text, escaped_value, render
from .places import after, before, last, removal
from .shapes import Shape, is_changed_as_asked, new_shape

_Change = dict[Element, Callable[[Shape], "Shape | None"]]


class XmlEdit(NamedTuple):
    """A file after an edit, or why the edit is not made."""

    document: XmlDocument | None
    diagnostics: tuple[Diagnostic, ...] = ()


def insert_after(
    document: XmlDocument, sibling: Element, new: NewElement, style: Style | None = None
) -> XmlEdit:
    """Write an element behind another one, and behind the comment that ends its line."""
    return _inserted(document, sibling, new, 1, style)


def insert_before(
    document: XmlDocument, sibling: Element, new: NewElement, style: Style | None = None
) -> XmlEdit:
    """Write an element before another one."""
    return _inserted(document, sibling, new, 0, style)


def insert_first(document: XmlDocument, parent: Element, new: NewElement) -> XmlEdit:
    """Write an element as the first child of another one."""
    if parent.children:
        return insert_before(document, parent.children[0], new)
    return insert_last(document, parent, new)


def insert_last(
    document: XmlDocument, parent: Element, new: NewElement, style: Style | None = None
) -> XmlEdit:
    """Write an element as the last child of another one, behind the comments in it."""
    style = style or style_of(document)
    own = close_of(document, parent)
    if parent.children:
        own = close_of(document, parent.children[-1])
    splice = last(document, parent, new, style._replace(close=own or style.close))
    added = new_shape(new)

    def change(old: Shape) -> Shape:
        return old._replace(children=(*old.children, added))

    return _apply(document, splice, {parent: change})


def replace_element(
    document: XmlDocument, element: Element, new: NewElement, style: Style | None = None
) -> XmlEdit:
    """Write an element in the place of another one."""
    style = style or style_of(document)
    style = style._replace(
        quote=quote_of(document, element) or style.quote,
        close=close_of(document, element) or style.close,
    )
    start, end = element.span
    indent = indent_of(document.text, start) if starts_line(document.text, start) else None
    written = new_shape(new)
    splice = Splice(start, end, render(new, style, indent))
    return _apply(document, splice, {element: lambda _: written}, element.span)


def remove_element(
    document: XmlDocument, element: Element, *, closes: bool = True, style: Style | None = None
) -> XmlEdit:
    """Take an element away, with its line where it stands alone, and the comment that ends it.

    Args:
        document: the file.
        element: what goes.
        closes: whether a parent in which nothing but two line breaks are left closes itself then.
        style: how it closes itself.
    """
    if element is document.root:
        return _refused(document, "the outermost element cannot be taken away", element.span)
    splice = removal(document, element, style or style_of(document), closes=closes)
    gone = Span(splice.start, splice.end)
    return _apply(document, splice, {element: lambda _: None}, gone)


def set_attribute(
    document: XmlDocument,
    element: Element,
    name: str,
    value: str,
    at: int | None = None,
    style: Style | None = None,
) -> XmlEdit:
    """Give an attribute a value, and write it where it is not there yet.

    Args:
        document: the file.
        element: the element.
        name: of the attribute.
        value: what it is to be.
        at: how many others a new one has before it; all of them for None.
        style: how it is written.
    """
    found = element.attribute(name)
    if found is not None and found.value == value:
        return XmlEdit(document)
    if found is not None:
        quote = document.slice(Span(found.value_span.end, found.span.end))
        span, new = found.value_span, escaped_value(value, quote)
    else:
        count = len(element.attributes) if at is None else min(at, len(element.attributes))
        start, separator = element.name_span.end, " "
        if count:
            start = element.attributes[count - 1].span.end
            separator = document.slice(_blank_before_attribute(element, count - 1))
        quote = quote_of(document, element) or (style or style_of(document)).quote
        new = f"{separator}{name}={quote}{escaped_value(value, quote)}{quote}"
        span = Span(start, start)

    def change(old: Shape) -> Shape:
        others = {pair for pair in old.attributes if pair[0] != name}
        return old._replace(attributes=frozenset(others | {(name, value)}))

    return _apply(document, Splice(*span, encoded(new)), {element: change})


def remove_attribute(document: XmlDocument, element: Element, name: str) -> XmlEdit:
    """Take an attribute away, with the blanks before it; it need not be there."""
    found = element.attribute(name)
    if found is None:
        return XmlEdit(document)
    start = _blank_before_attribute(element, element.attributes.index(found)).start

    def change(old: Shape) -> Shape:
        others = (pair for pair in old.attributes if pair[0] != name)
        return old._replace(attributes=frozenset(others))

    return _apply(document, Splice(start, found.span.end), {element: change})


def set_text(document: XmlDocument, element: Element, text: str) -> XmlEdit:
    """Give an element without children another text; the blanks around the old one stay."""
    content = document.text[element.content.start : element.content.end]
    if element.children or element.end_tag is None or b"<" in content:
        return _refused(
            document, f"`<{element.name}>` does not hold a plain text", element.start_tag
        )
    start = element.content.start + len(content) - len(content.lstrip())
    end = max(start, element.content.end - (len(content) - len(content.rstrip())))

    def change(old: Shape) -> Shape:
        return old._replace(words=tuple(text.split()))

    splice = Splice(start, end, encoded(escaped_text(text)))
    return _apply(document, splice, {element: change})


def _inserted(
    document: XmlDocument, sibling: Element, new: NewElement, behind: int, style: Style | None
) -> XmlEdit:
    parent = document.parents.get(sibling)
    if parent is None:
        return _refused(
            document, "nothing can stand beside the outermost element", sibling.start_tag
        )
    style = style or style_of(document)
    quote = quote_of(document, sibling) or style.quote
    style = style._replace(close=close_of(document, sibling) or style.close, quote=quote)
    place = after if behind else before
    splice = place(document, sibling.span, new, style)
    at = parent.children.index(sibling) + behind
    added = new_shape(new)

    def change(old: Shape) -> Shape:
        return old._replace(children=(*old.children[:at], added, *old.children[at:]))

    return _apply(document, splice, {parent: change})


def _apply(
    document: XmlDocument, splice: Splice, change: _Change, gone: Span | None = None
) -> XmlEdit:
    """Replace a range, and make sure that the file says what was asked for and nothing else."""
    read = read_xml(apply(document.text, (splice,)), document.file)
    if read.document is None or not is_changed_as_asked(document, read.document, change, gone):
        return _refused(
            document, "the change would change more than it is to", Span(splice.start, splice.end)
        )
    return XmlEdit(read.document)


def _blank_before_attribute(element: Element, at: int) -> Span:
    start = element.attributes[at - 1].span.end if at else element.name_span.end
    return Span(start, element.attributes[at].span.start)


def _refused(document: XmlDocument, message: str, span: Span) -> XmlEdit:
    return XmlEdit(None, (Diagnostic(codes.EDIT_REFUSED, message, span, document.file),))
