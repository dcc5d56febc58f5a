"""What a Python text defines and mentions, to be compared with another."""

from __future__ import annotations

from collections import Counter

from .syntax import parse


def definitions(text: bytes, name: str) -> int:
    """Count the functions and methods of a name that a text defines."""
    return _count(text, name, "definition")


def mentions(text: bytes, name: str) -> bool:
    """Tell whether the code of a text has a name; strings and comments are no code."""
    return _count(text, name, "identifier") > 0


def lines_of_code(text: bytes) -> Counter[bytes]:
    """Return the lines of a text without their indent, blank lines and imports left out.

    What a file imports depends on all that is in it, not on one endpoint.
    """
    syntax = parse(text)
    imports: set[int] = set()
    for node in syntax.captures("words").get("import", []):
        imports |= set(range(node.start_point.row, node.end_point.row + 1))
    rows = enumerate(text.split(b"\n"))
    return Counter(line.strip() for row, line in rows if line.strip() and row not in imports)


def _count(text: bytes, name: str, tag: str) -> int:
    syntax = parse(text)
    found = syntax.captures("words").get(tag, [])
    return sum(syntax.slice(node) == name for node in found)
