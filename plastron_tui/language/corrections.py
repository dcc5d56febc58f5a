"""Values that are written in another way, and what is meant: by the fixes of what is wrong."""

from __future__ import annotations

from .document import Document
from .lowering import lower

_BEFORE = b"create_message m of message_type T and input x="
# Each slip of a value has a fix of its own.
_MOST_FIXES = 4


def corrected(text: str) -> str | None:
    """Return a value of one field as a program writes it, None where nobody can tell."""
    document = Document(_BEFORE + text.encode("utf-8", "surrogatepass"))
    for _ in range(_MOST_FIXES):
        diagnostics = lower(document).diagnostics
        if not diagnostics:
            return document.text[len(_BEFORE) :].decode("utf-8", "surrogatepass")
        fix = diagnostics[0].fix
        if fix is None:
            return None
        for edit in sorted(fix.edits, key=lambda each: each.span, reverse=True):
            document.edit(edit.span.start, edit.span.end, edit.text.encode())
        if not document.text.startswith(_BEFORE):
            return None
    return None
