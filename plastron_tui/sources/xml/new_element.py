"""An element that is to be written, and its text in the style of a file."""

from __future__ import annotations

from typing import NamedTuple

from .layout import Style


def encoded(text: str) -> bytes:
    """Return a text in UTF-8; what no file can hold becomes a `?`, so that reading again tells."""
    return text.encode("utf-8", "replace")


class NewElement(NamedTuple):
    """An element that is to be written; it has a text or children, or neither."""

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    text: str = ""
    children: tuple[NewElement, ...] = ()


def render(new: NewElement, style: Style, indent: bytes | None) -> bytes:
    """Return the text of an element, without the indentation of its first line.

    Args:
        new: what is to be written.
        style: how.
        indent: the indentation of its first line, None for all in one line.
    """
    tag, apart = encoded(new.name), b" "
    if style.wraps and indent is not None:
        apart = style.newline + indent + style.unit
    for name, value in new.attributes:
        quote = style.quote
        tag += apart + encoded(f"{name}={quote}{escaped_value(value, quote)}{quote}")
    if not new.text and not new.children:
        return b"<" + tag + style.close.encode()
    content = encoded(escaped_text(new.text))
    indent = None if new.name in style.inline else indent
    inner = None if indent is None else indent + style.unit
    before = b"" if inner is None else style.newline + inner
    content += b"".join(before + render(child, style, inner) for child in new.children)
    if indent is not None and new.children:
        content += style.newline + indent
    return b"<" + tag + b">" + content + b"</" + encoded(new.name) + b">"


def escaped_value(value: str, quote: str) -> str:
    """Return what stands between quotes for a value."""
    value = value.replace("&", "&amp;").replace("<", "&lt;")
    value = value.replace(quote, "&quot;" if quote == '"' else "&apos;")
    # A reader makes a space of each of these.
    return value.replace("\t", "&#9;").replace("\n", "&#10;").replace("\r", "&#13;")


def escaped_text(text: str) -> str:
    """Return what stands between tags for a text."""
    text = text.replace("&", "&amp;").replace("<", "&lt;")
    return text.replace("]]>", "]]&gt;").replace("\r", "&#13;")
