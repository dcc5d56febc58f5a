"""What is wrong with a word that fits nowhere, whatever sentence it stands in."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Span, codes, escapes, write

from .mistake_place import shown
from .tokens import UNCLOSED_STRING, UNKNOWN, Token


def unexpected(token: Token) -> Diagnostic:
    """Explain a token that stands where no token of its kind can stand."""
    first = token.text[0]
    start = token.start
    if token.kind == UNCLOSED_STRING or (token.kind == UNKNOWN and first in "'\""):
        return Diagnostic(
            codes.UNCLOSED_QUOTE,
            f"the quote is not closed on this line: {first}",
            Span(start, start + 1),
            help=f"close it with {first}",
        )
    if token.kind == UNKNOWN and token.text.startswith("/*"):
        return Diagnostic(
            codes.UNCLOSED_COMMENT,
            "the comment is not closed",
            Span(start, start + 2),
            help="close it with `*/`",
        )
    return Diagnostic(codes.SYNTAX_ERROR, f"unexpected `{shown(token.text)}`", token.span)


def broken_text(token: Token, following: Token | None) -> Diagnostic:
    """Explain a string that does not end, or that an escape broke off."""
    if token.kind != UNCLOSED_STRING or following is None or following.text[0] != "\\":
        return unexpected(token)
    escape = following.text[:2]
    span = Span(following.start, following.start + len(escape.encode()))
    return Diagnostic(
        codes.UNKNOWN_ESCAPE,
        f"`{shown(escape)}` is no escape",
        span,
        help=f"the escapes are {escapes.listed()}; a backslash is written \\\\",
        fix=write(f"\\{escape}", span),
    )
