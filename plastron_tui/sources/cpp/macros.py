"""Macros that no parser can see through, each blanked, so that what is around them parses.

No offset moves. What they stand for is visibility, what Qt's compiler reads, or whole
declarations: nothing that says what a node is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from .preprocessing import Define

_ARGUMENTS = rb"\((?:[^()\n]|\((?:[^()\n]|\([^()\n]*\))*\))*\)"
_VISIBLE = b"PUBLIC|LOCAL|EXPORT|IMPORT|API|DECL|INLINE|DEPRECATED"
# What is looked for at all, and the macro.
_BLANK = (
    # class FOO_PUBLIC Name
    (
        re.compile(rb"\b(?:class|struct)\s+[A-Z][A-Z0-9_]{2,}"),
        re.compile(
            rb"(?:(?<=\bclass)|(?<=\bstruct))\s+[A-Z][A-Z0-9_]{2,}\b(?:"
            + _ARGUMENTS
            + rb")?(?=\s+[A-Za-z_][\w:]*\s*(?:final\b\s*)?[:{])"
        ),
    ),
    # FOO_PUBLIC void function();
    (
        re.compile(rb"_(?:" + _VISIBLE + rb")\b"),
        re.compile(rb"\b[A-Z][A-Z0-9_]*_(?:" + _VISIBLE + rb")\b(?!\s*[;,=+)])"),
    ),
    # "%" PRId64 "more"
    (
        re.compile(rb"PRI[dioxXu]"),
        re.compile(rb'(?<=")\s*\bPRI[dioxXu](?:8|16|32|64|PTR|MAX|(?:LEAST|FAST)(?:8|16|32|64))\b'),
    ),
    (
        re.compile(rb"Q_[A-Z]|slots"),
        re.compile(
            rb"\b(?:Q_OBJECT|Q_GADGET|Q_SLOTS|Q_EMIT|Q_INVOKABLE)\b|\bQ_SIGNALS\s*:"
            rb"|\bslots\b(?=\s*:)"
        ),
    ),
    (
        re.compile(rb"__attribute__|__declspec"),
        re.compile(rb"\b__attribute__\s*\(\((?:[^()]|\([^()]*\))*\)\)|\b__declspec\s*\([^()]*\)"),
    ),
    (
        re.compile(rb"\[\s*\["),
        re.compile(
            rb"\[\s*\[\s*(?:maybe_unused|nodiscard|deprecated|noreturn|fallthrough|gnu::)"
            rb"[^\[\]]*\]\s*\]"
        ),
    ),
    (
        re.compile(rb"EIGEN_MAKE_ALIGNED"),
        re.compile(rb"\bEIGEN_MAKE_ALIGNED_OPERATOR_NEW\b\s*;?"),
    ),
)
# A macro alone on its line, without a `;`, stands for a declaration.
_ALONE = re.compile(
    rb"^[ \t]*(?!TEST|TYPED_TEST|PARAM_TEST)[A-Z][A-Z0-9]*_[A-Z0-9_]*[ \t]*"
    rb"(?:\((?:[^(){};\"]|\((?:[^(){};\"]|\([^(){};\"]*\))*\))*\))?[ \t]*$",
    re.MULTILINE,
)
_MOST_JOINED = 400
_BEFORE = frozenset(b";{}:)")
_AFTER = frozenset(b";,.)-+*/=<>?&|({")
_LOOP = re.compile(rb"\b(?:BOOST_(?:REVERSE_)?FOREACH|Q_FOREACH|foreach)\s*(?=\()")
_SIGNALS = re.compile(rb"\bsignals(\s*:)")


def mask_macros(code: bytearray) -> None:
    """Put blanks over the macros of a text that would not parse."""
    found = bytes(code)
    for sign, macro in _BLANK:
        if sign.search(found) is not None:
            found = macro.sub(blanked, found)
    if b"OREACH" in found or b"foreach" in found:
        found = _mask_loops(found)
    if b"Q_OBJECT" in code:
        found = _SIGNALS.sub(rb"private\1", found)
    code[:] = _ALONE.sub(_unless_joined(found), found)


def join_macros(code: bytearray, defines: Sequence[Define], text: bytes) -> None:
    """Put a `+` between macros that are strings and the strings before them.

    `TOPIC_PREFIX TOPIC_NAME` and `"/" TOPIC_NAME` are strings one after the other, and no names
    one after the other, which is how they would be parsed.
    """
    names = [
        re.escape(define.name.encode())
        for define in defines
        if text[define.start : define.end].lstrip(b" (")[:1] == b'"'
    ]
    if not names or len(names) > _MOST_JOINED:
        return
    either = b"|".join(names)
    found = re.compile(rb'(?:"|\b(?:' + either + rb"))[ \t\r\n]+(?=(?:" + either + rb")\b)")
    for each in list(found.finditer(bytes(code))):
        code[each.end() - 1 : each.end()] = b"+"


def blanked(found: re.Match[bytes]) -> bytes:
    """Return blanks for what is found, so that the rest stays where it is."""
    return re.sub(rb"[^\n]", b" ", found[0])


def _unless_joined(code: bytes) -> Callable[[re.Match[bytes]], bytes]:
    """Return what blanks a macro, unless what is around it makes it a part of something."""

    def replace(found: re.Match[bytes]) -> bytes:
        start, end = found.span()
        while start > 0 and code[start - 1] in b" \t\r\n":
            start -= 1
        while end < len(code) and code[end] in b" \t\r\n":
            end += 1
        is_first = start == 0 or code[start - 1] in _BEFORE
        is_last = end == len(code) or code[end] not in _AFTER
        return blanked(found) if is_first and is_last else found[0]

    return replace


def _mask_loops(code: bytes) -> bytes:
    """Write `while` for loops that are macros, with the number 1 for what they go over."""
    text = bytearray(code)
    for found in _LOOP.finditer(code):
        start, end = found.span()
        text[start:end] = b"while".ljust(end - start)
        depth = 0
        for at in range(end, min(len(text), end + 400)):
            depth += (text[at] == ord("(")) - (text[at] == ord(")"))
            if depth == 0:
                inner = re.sub(rb"[^\n]", b" ", bytes(text[end + 1 : at]))
                text[end + 1 : at] = b"1" + inner[1:] if inner and inner[:1] != b"\n" else inner
                break
    return bytes(text)
