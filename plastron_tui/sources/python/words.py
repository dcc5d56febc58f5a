"""What a Python text defines and mentions, to be compared with another."""

from __future__ import annotations

from .syntax import parse


def definitions(text: bytes, name: str) -> int:
    """Count the functions and methods of a name that a text defines."""
    return _count(text, name, "definition")


def mentions(text: bytes, name: str) -> bool:
    """Tell whether the code of a text has a name; strings and comments are no code."""
    return _count(text, name, "identifier") > 0


def _count(text: bytes, name: str, tag: str) -> int:
    syntax = parse(text)
    found = syntax.captures("words").get(tag, [])
    return sum(syntax.slice(node) == name for node in found)
