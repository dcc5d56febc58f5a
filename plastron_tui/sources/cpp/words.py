"""What a C++ text has, without a node being read from it."""

from __future__ import annotations

import re

from .structure import outline
from .syntax import parse

_LITERAL = frozenset({"string_literal", "raw_string_literal", "char_literal", "system_lib_string"})


def definitions(text: bytes, name: str) -> int:
    """Count the functions and methods of a name that a text defines."""
    if name.encode() not in text:
        return 0
    return sum(
        scope.kind == "function" and scope.name == name for scope in outline("", parse(text)).scopes
    )


def mentions(text: bytes, name: str) -> bool:
    """Tell whether the code of a text has a name; strings and comments are no code."""
    encoded = name.encode()
    if encoded not in text:
        return False
    syntax = parse(text)
    word = re.compile(rb"(?<!\w)" + re.escape(encoded) + rb"(?!\w)")
    for found in word.finditer(syntax.code):
        node = syntax.root.descendant_for_byte_range(found.start(), found.end())
        while node is not None and not node.is_named:
            node = node.parent
        if node is not None and node.type not in _LITERAL and node.type != "string_content":
            return True
    return any(
        word.search(text[define.start : define.end]) or define.name == name
        for define in syntax.defines
    )
