"""Files that are no text in UTF-8: what they are instead."""

from __future__ import annotations

import codecs
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Span, codes

from .splices import line_number

_MARKS = {codecs.BOM_UTF16_LE: "UTF-16", codecs.BOM_UTF16_BE: "UTF-16"}


def without_nul(text: bytes) -> bytes:
    """Return a text without NUL bytes: what is ASCII in UTF-16 is ASCII without them."""
    return text.replace(b"\0", b"") if b"\0" in text else text


def not_utf_8(text: bytes, path: Path) -> Diagnostic | None:
    """Return what a file is instead of a text in UTF-8, None where it is one.

    What is no text at all, such as a program of a machine, is a file that has no node.
    """
    encoding = _MARKS.get(text[:2])
    if encoding is not None and _is_in(text, encoding):
        return Diagnostic(codes.UNREADABLE_FILE, f"`{path.name}` is {encoding}", file=path)
    at = text.find(b"\0")
    if at < 0:
        try:
            text.decode()
        except UnicodeDecodeError as error:
            message = f"line {line_number(text, error.start)} of `{path.name}` is not UTF-8"
            span = Span(error.start, error.end)
            return Diagnostic(codes.UNREADABLE_FILE, message, span, path)
        return None
    if not _is_in(text, "UTF-8"):
        return Diagnostic(codes.NO_NODE, "the file is not a text", file=path)
    message = f"line {line_number(text, at)} of `{path.name}` has a NUL byte"
    return Diagnostic(codes.UNREADABLE_FILE, message, Span(at, at + 1), path)


def _is_in(text: bytes, encoding: str) -> bool:
    try:
        text.decode(encoding)
    except UnicodeDecodeError:
        return False
    return True
