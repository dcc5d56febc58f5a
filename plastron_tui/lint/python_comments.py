"""Where a text of Python has comments.

What stands in the braces of a formatted string is code, whose strings begin with any quotes
(PEP 701). A comment in there is not told: it is none in older versions of Python.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from plastron_tui.diagnostics import Span

_CODE = (
    rb"(?<!\w)(?:[fFtT][rR]?|[rR][fFtT])(?P<begin>\"\"\"|'''|\"|')"
    rb"|\"\"\"(?:\\.|[^\\])*?(?:\"\"\"|\Z)|'''(?:\\.|[^\\])*?(?:'''|\Z)"
    rb"|\"(?:\\(?:\r\n|.)|[^\"\\\r\n])*\"?|'(?:\\(?:\r\n|.)|[^'\\\r\n])*'?|(?P<comment>#[^\r\n]*)"
)
_OUTSIDE = re.compile(_CODE, re.S)
_FIELD = re.compile(_CODE + rb"|(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<colon>:)", re.S)
_ENDS = {b"'": rb"'|[\r\n]", b'"': rb"\"|[\r\n]", b"'''": rb"'''", b'"""': rb"\"\"\""}
_ESCAPE = rb"\\(?:\r\n|[^{])|"
_TEXTS = {
    quote: re.compile(_ESCAPE + rb"\{\{|(?P<field>\{)|(?P<end>%b)" % end, re.S)
    for quote, end in _ENDS.items()
}
_FORMATS = {
    quote: re.compile(_ESCAPE + rb"(?P<field>\{)|(?P<close>\})|(?P<end>%b)" % end, re.S)
    for quote, end in _ENDS.items()
}


@dataclass(slots=True)
class _Part:
    """A part of a formatted string that is open: its text, a field, or what is behind the `:`.

    Attributes:
        pattern: what the next token of it is.
        quote: the quote that ends the string.
        depth: how many brackets are open in a field.
    """

    pattern: re.Pattern[bytes]
    quote: bytes
    depth: int = 0


def python_comments(text: bytes) -> Iterator[Span]:
    """Yield the places of the comments; each pattern begins at the first match behind the last."""
    parts: list[_Part] = []
    at = 0
    while (found := (parts[-1].pattern if parts else _OUTSIDE).search(text, at)) is not None:
        at = found.end()
        match found.lastgroup:
            case "comment" if not parts:
                yield Span(*found.span())
            case "begin":
                parts.append(_Part(_TEXTS[found["begin"]], found["begin"]))
            case "field":
                parts.append(_Part(_FIELD, parts[-1].quote))
            case "open":
                parts[-1].depth += 1
            case "colon" if not parts[-1].depth:
                parts[-1].pattern = _FORMATS[parts[-1].quote]
            case "close" if parts[-1].depth:
                parts[-1].depth -= 1
            case "close":
                parts.pop()
            case "end":
                while parts.pop().pattern not in _TEXTS.values():
                    pass
