"""What is wrong with a text that Expat finds not well-formed."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.parsers.expat import errors

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes

_BLANK = b" \t\r\n"
_NAME_END = b" \t\r\n/>=<\"'"
_LONGEST_SHOWN = 40


def _code(message: str) -> int:
    return errors.codes[message]


_MISMATCH = _code(errors.XML_ERROR_TAG_MISMATCH)
_NO_ELEMENTS = _code(errors.XML_ERROR_NO_ELEMENTS)
_TWICE = _code(errors.XML_ERROR_DUPLICATE_ATTRIBUTE)
_JUNK = _code(errors.XML_ERROR_JUNK_AFTER_DOC_ELEMENT)
_UNDEFINED = _code(errors.XML_ERROR_UNDEFINED_ENTITY)
_ENCODING = _code(errors.XML_ERROR_INCORRECT_ENCODING)
_MISPLACED = _code(errors.XML_ERROR_MISPLACED_XML_PI)
_UNCLOSED = _code(errors.XML_ERROR_UNCLOSED_TOKEN)
_PARTIAL = _code(errors.XML_ERROR_PARTIAL_CHAR)


def why_broken(
    text: bytes, code: int, offset: int, opened: Sequence[tuple[str, int]], file: Path | None
) -> Diagnostic:
    """Say what is wrong, and where.

    Args:
        text: what the file holds.
        code: Expat's number of the error.
        offset: where Expat stopped.
        opened: the names and starts of the elements that are not closed there.
        file: the file, for the diagnostic.
    """
    span = _name_at(text, offset)
    name = _shown(text, span)
    labels: tuple[Label, ...] = ()
    help_text = None
    if code == _MISMATCH and opened:
        inner, start = opened[-1]
        if name in [outer for outer, _ in opened[:-1]]:
            message = f"`<{inner}>` is not closed before `</{name}>`"
            labels = (Label(span, f"`</{name}>` stands here"),)
            span = _tag_name(inner, start)
        else:
            message = f"`</{name}>` stands where `<{inner}>` is to be closed"
            labels = (Label(_tag_name(inner, start), f"`<{inner}>` starts here"),)
    elif code == _NO_ELEMENTS and opened:
        message, span = f"`<{opened[-1][0]}>` is not closed", _tag_name(*opened[-1])
    elif code == _NO_ELEMENTS:
        message, span = "there is no element in the file", Span(0, 0)
    elif code == _TWICE:
        message = f"the attribute `{name}` stands there twice"
    elif code == _JUNK:
        message = "something stands behind the one element that a file has"
    elif code == _UNDEFINED:
        name = _shown(text, Span(offset + 1, max(text.find(b";", offset), offset + 1)))
        span = Span(offset, offset + len(name.encode()) + 2)
        message = f"`&{name};` is declared nowhere"
        help_text = "a `&` that is meant as such is written `&amp;`"
    elif code == _MISPLACED:
        message, span = "`<?xml` stands at the very start of a file only", Span(offset, offset + 5)
    elif code == _UNCLOSED:
        message = f"`{_shown(text, Span(offset, offset + 12))}` has no end"
    elif code in (_PARTIAL, _ENCODING) or not _is_utf8(text):
        return Diagnostic(codes.UNSUPPORTED_XML, "the file is not in UTF-8", file=file)
    else:
        message, span, help_text = _token(text, offset)
    return Diagnostic(codes.BROKEN_XML, message, span, file, help_text, labels=labels)


def _token(text: bytes, offset: int) -> tuple[str, Span, str | None]:
    """Say what is wrong with a character that cannot stand where it does."""
    here = Span(offset, min(offset + 1, len(text)))
    before = text[:offset].rstrip(_BLANK)
    if text[offset - 1 : offset] == b"&":
        return "`&` stands alone", Span(offset - 1, offset), "write `&amp;`"
    tag = before.rfind(b"<")
    is_open = tag > before.rfind(b">") and not text.startswith((b"<!", b"<?"), tag)
    is_cut = text[offset : offset + 1] == b"<" and _has_whole_values(before[max(tag, 0) :])
    if is_open and not before.endswith(b"=") and (is_cut or before.endswith(b"/")):
        name = _name_at(text, tag + 1)
        return f"`<{_shown(text, name)}` has no `>` at its end", name, "write `>` or `/>`"
    if text[offset : offset + 1] == b"<" and before[-1:] in (b'"', b"'", b"="):
        return "`<` cannot stand in a value", here, "write `&lt;`"
    comment = text.rfind(b"<!--", 0, offset)
    if comment >= 0 and text.rfind(b"-->", comment, offset) < 0:
        hyphens = text.rfind(b"--", comment + 4, offset + 2)
        return "`--` cannot stand in a comment", Span(max(hyphens, 0), max(hyphens, 0) + 2), None
    if is_open:
        if before.endswith(b"="):
            return "a value has no quotes", _name_at(text, offset), None
        if text[offset : offset + 1] == b"<":
            help_text = "a `<` that is meant as such is written `&lt;`"
            return "`<` stands in a tag, or in a value", here, help_text
        start = len(before)
        while start > tag and before[start - 1 : start] not in (b" ", b"\t", b"\r", b"\n", b"<"):
            start -= 1
        word = _shown(text, Span(start, len(before)))
        if word and all(mark not in word for mark in "\"'<"):
            return f"`{word}` has no value", Span(start, len(before)), None
    shown = _shown(text, here)
    what = f"`{shown}`" if shown.isprintable() and shown.strip() else "what stands here"
    return f"{what} cannot stand here", here, None


def _has_whole_values(tag: bytes) -> bool:
    """Tell whether each value in a tag has its closing quote."""
    quote = b""
    for at in range(len(tag)):
        mark = tag[at : at + 1]
        if quote:
            quote = b"" if mark == quote else quote
        elif mark in (b'"', b"'"):
            quote = mark
    return not quote


def _name_at(text: bytes, offset: int) -> Span:
    end = offset
    while end < len(text) and text[end] not in _NAME_END:
        end += 1
    return Span(offset, max(end, min(offset + 1, len(text))))


def _tag_name(name: str, start: int) -> Span:
    return Span(start + 1, start + 1 + len(name.encode()))


def _shown(text: bytes, span: Span) -> str:
    return text[span.start : min(span.end, span.start + _LONGEST_SHOWN)].decode("utf-8", "replace")


def _is_utf8(text: bytes) -> bool:
    try:
        text.decode()
    except UnicodeDecodeError:
        return False
    return True
