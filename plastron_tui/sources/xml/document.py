"""An XML file as bytes, with the place of each element and each attribute in them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import NamedTuple

import tree_sitter_xml
from tree_sitter import Language, Node, Parser

from plastron_tui.diagnostics import Diagnostic, LineIndex, Span, codes

from .outline import Outline, Outlined, read_outline


class Attribute(NamedTuple):
    """An attribute of an element.

    Attributes:
        name: as it is written, with its prefix.
        value: without quotes, references decoded.
        span: from the name to the closing quote.
        value_span: what is between the quotes.
    """

    name: str
    value: str
    span: Span
    value_span: Span


@dataclass(frozen=True, slots=True)
class Element:
    """An element; equal to itself only.

    Attributes:
        name: as it is written, with its prefix.
        attributes: in the order of the text.
        children: the elements directly in it.
        pieces: the characters before its first child, between its children, and behind the last
            one, decoded; always one more than it has children.
        span: from the `<` of its start to the `>` of its end.
        name_span: its name in the start tag.
        start_tag: the start tag, or all of it where it closes itself.
        end_tag: None where it closes itself.
        line: the line of its start, counted from 1.
    """

    name: str
    attributes: tuple[Attribute, ...]
    children: tuple[Element, ...] = field(repr=False)
    pieces: tuple[str, ...]
    span: Span
    name_span: Span
    start_tag: Span
    end_tag: Span | None
    line: int

    def __eq__(self, other: object) -> bool:
        return self is other

    def __hash__(self) -> int:
        return id(self)

    @property
    def text(self) -> str:
        """The characters directly in it; a child's place is a line break."""
        return "\n".join(self.pieces)

    @property
    def value(self) -> str:
        """The text without the blanks around it."""
        return self.text.strip(" \t\r\n")

    @property
    def content(self) -> Span:
        """What is between start and end tag; empty at its end where it closes itself."""
        end = self.end_tag.start if self.end_tag is not None else self.start_tag.end
        return Span(self.start_tag.end, end)

    def value_span(self, text: bytes) -> Span:
        """Return where its value stands in the file; its name where it has none."""
        start, end = self.content
        content = text[start:end]
        stripped = content.strip()
        if not stripped:
            return self.name_span
        start += len(content) - len(content.lstrip())
        return Span(start, start + len(stripped))

    def attribute(self, name: str) -> Attribute | None:
        """Return the attribute of a name."""
        return next((one for one in self.attributes if one.name == name), None)

    def get(self, name: str) -> str | None:
        """Return the value of an attribute, None where there is none of that name."""
        found = self.attribute(name)
        return found.value if found is not None else None

    def named(self, *names: str) -> tuple[Element, ...]:
        """Return the children that have one of the names."""
        return tuple(child for child in self.children if child.name in names)

    def walk(self) -> Iterator[Element]:
        """Go over the element and all in it, in the order of the text."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack.extend(reversed(element.children))


@dataclass(frozen=True, slots=True)
class XmlDocument:
    """A well-formed XML file.

    Attributes:
        text: what is on the disk.
        file: the file, for diagnostics.
        root: the outermost element.
        comments: in the order of the text.
        instructions: the processing instructions, in the order of the text.
        parents: the parent of each element but the root.
    """

    text: bytes = field(repr=False)
    file: Path | None
    root: Element
    comments: tuple[Span, ...]
    instructions: tuple[Span, ...]
    parents: dict[Element, Element] = field(repr=False)

    def slice(self, span: Span) -> str:
        """Return the source of a span."""
        return self.text[span.start : span.end].decode("utf-8", "replace")


class XmlResult(NamedTuple):
    """A document, or why there is none."""

    document: XmlDocument | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_xml(text: bytes, file: Path | None = None) -> XmlResult:
    """Read an XML file.

    Args:
        text: what the file holds.
        file: the file, for diagnostics.
    """
    outline, diagnostics = read_outline(text, file)
    if outline is None:
        return XmlResult(None, diagnostics)
    elements = _placed(text, outline)
    if elements is None:
        message = "the file is well-formed, and has a form that plastron cannot follow"
        return XmlResult(None, (Diagnostic(codes.UNSUPPORTED_XML, message, file=file),))
    parents = {child: element for element in elements for child in element.children}
    return XmlResult(
        XmlDocument(text, file, elements[0], outline.comments, outline.instructions, parents)
    )


@cache
def _language() -> Language:
    return Language(tree_sitter_xml.language_xml())


class _Tags(NamedTuple):
    """The places of an element's tags."""

    start: Node
    end: Node | None


def _placed(text: bytes, outline: Outline) -> tuple[Element, ...] | None:
    """Return the elements with their places, None where the two readers do not agree."""
    tags = _tags(text, outline)
    if tags is None or len(tags) != len(outline.elements):
        return None
    lines = LineIndex(text)
    children: list[list[Element]] = [[] for _ in tags]
    found: list[Element | None] = [None for _ in tags]
    # Children come after their parent, and are made before it.
    for at in range(len(tags) - 1, -1, -1):
        outlined = outline.elements[at]
        element = _element(text, outlined, tags[at], tuple(reversed(children[at])), lines)
        if element is None:
            return None
        found[at] = element
        if outlined.parent is not None:
            children[outlined.parent].append(element)
    return tuple(element for element in found if element is not None)


def _tags(text: bytes, outline: Outline) -> list[_Tags] | None:
    """Return the tags of each element, in the order of their starts."""
    source = _without_instructions(text, outline)
    tree = Parser(_language()).parse(source)
    if tree.root_node.has_error:
        return None
    found = []
    stack = [tree.root_node]
    while stack:
        node = stack.pop()
        children = node.named_children
        if node.type == "element":
            starts = [child for child in children if child.type in ("STag", "EmptyElemTag")]
            ends = [child for child in children if child.type == "ETag"]
            if len(starts) != 1 or (starts[0].type == "STag") != (len(ends) == 1):
                return None
            found.append(_Tags(starts[0], ends[0] if ends else None))
        if node.type in ("document", "element", "content"):
            stack.extend(reversed(children))
    return found


def _without_instructions(text: bytes, outline: Outline) -> bytes:
    """Return a text of the same length: the grammar knows no instruction within an element."""
    source = bytearray(text)
    for start, end in outline.instructions:
        source[start:end] = b" " * (end - start)
    return bytes(source)


def _element(
    text: bytes, outlined: Outlined, tags: _Tags, children: tuple[Element, ...], lines: LineIndex
) -> Element | None:
    """Put together what both readers say; None where they contradict each other."""
    start, end = tags
    attributes = _attributes(text, outlined, start)
    name = start.named_children[0]
    if start.start_byte != outlined.start or attributes is None:
        return None
    if text[name.start_byte : name.end_byte] != outlined.name.encode():
        return None
    return Element(
        outlined.name,
        attributes,
        children,
        tuple(map("".join, outlined.pieces)),
        Span(start.start_byte, (end or start).end_byte),
        _span(name),
        _span(start),
        None if end is None else _span(end),
        lines.line_at(start.start_byte),
    )


def _attributes(text: bytes, outlined: Outlined, tag: Node) -> tuple[Attribute, ...] | None:
    nodes = [child for child in tag.named_children if child.type == "Attribute"]
    if len(nodes) != len(outlined.attributes):
        return None
    found = []
    for node, (name, value) in zip(nodes, outlined.attributes, strict=True):
        names, values = node.named_children[0], node.named_children[-1]
        if text[names.start_byte : names.end_byte] != name.encode():
            return None
        value_span = Span(values.start_byte + 1, values.end_byte - 1)
        found.append(Attribute(name, value, _span(node), value_span))
    return tuple(found)


def _span(node: Node) -> Span:
    return Span(node.start_byte, node.end_byte)
