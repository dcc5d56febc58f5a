"""What an XML file says apart from its layout, to compare it before and after an edit."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from plastron_tui.diagnostics import Span

from .document import Element, XmlDocument
from .new_element import NewElement


class Shape(NamedTuple):
    """An element without blanks and places."""

    name: str
    attributes: frozenset[tuple[str, str]]
    words: tuple[str, ...]
    children: tuple[Shape, ...]


def shape_of(element: Element, change: dict[Element, Callable[[Shape], Shape | None]]) -> Shape:
    """Return what an element says.

    Args:
        element: the element; it is not in `change` where that takes it away.
        change: what is to become of elements; None takes one away.
    """
    children = [(child, shape_of(child, change)) for child in element.children]
    return Shape(
        element.name,
        frozenset((one.name, one.value) for one in element.attributes),
        tuple(element.text.split()),
        tuple(
            shape
            for child, old in children
            if (shape := change[child](old) if child in change else old) is not None
        ),
    )


def new_shape(new: NewElement) -> Shape:
    """Return what a new element says."""
    children = tuple(map(new_shape, new.children))
    return Shape(new.name, frozenset(new.attributes), tuple(new.text.split()), children)


def is_changed_as_asked(
    before: XmlDocument,
    after: XmlDocument,
    change: dict[Element, Callable[[Shape], Shape | None]],
    gone: Span | None = None,
) -> bool:
    """Tell whether a file says after an edit exactly what it is to say.

    Args:
        before: the file as it was.
        after: the file as it is now.
        change: what is to become of elements.
        gone: the range whose comments and instructions may be gone.
    """
    root = shape_of(before.root, change)
    expected = change[before.root](root) if before.root in change else root
    comments, instructions = (
        [one for one in spans if gone is None or not _is_in(one, gone)]
        for spans in (before.comments, before.instructions)
    )
    return (
        expected == shape_of(after.root, {})
        and _slices(before, comments) == _slices(after, after.comments)
        and _slices(before, instructions) == _slices(after, after.instructions)
    )


def _is_in(span: Span, outer: Span) -> bool:
    return outer.start <= span.start and span.end <= outer.end


def _slices(document: XmlDocument, spans: Iterable[Span]) -> list[str]:
    return [document.slice(span) for span in spans]
