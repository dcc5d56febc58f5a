"""Break long lines of Python source as `ruff format` does.

Templates write each statement on one line; `fit` breaks those that are longer than a line
may be. It knows what templates need: brackets, commas and strings.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from plastron_tui.diagnostics.terminal import width

from . import literals

LINE_LENGTH = 88
"""The default of `ruff format`."""

_INDENT = 4
_CLOSING = {"(": ")", "[": "]", "{": "}"}
_TOKEN = re.compile(
    r"""(?P<string>[A-Za-z]{0,2}(?:"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'))"""
    r"""|(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<comma>,\ ?)|(?P<other>[A-Za-z0-9_.]+|[^"'])"""
)
_STRING_ITEM = re.compile(r"""(?P<name>(?:[A-Za-z_]\w*=)?)(?P<literal>["'].*["'])""")


def fit(source: str) -> str:
    """Break the lines of `source` that are too long; the others are left as they are."""
    lines: list[str] = []
    for line in source.split("\n"):
        parts = _scan(line.lstrip()) if width(line) > LINE_LENGTH else None
        if parts is None:
            lines.append(line)
        else:
            lines += _break(parts, len(line) - len(line.lstrip()), "")
    return "\n".join(lines)


@dataclass(slots=True)
class _Group:
    """A bracket with the items between its commas."""

    opening: str
    items: list[list[_Part]]

    def __str__(self) -> str:
        return f"{self.opening}{', '.join(map(_flat, self.items))}{_CLOSING[self.opening]}"


_Part = str | _Group


def _scan(text: str) -> list[_Part] | None:
    """Read the brackets of one line; None when they do not match or a comment stands in it."""
    top: list[_Part] = []
    stack: list[_Group] = []
    current = top
    position = 0
    while position < len(text):
        found = _TOKEN.match(text, position)
        if found is None or found[0] == "#":
            return None
        position = found.end()
        match found.lastgroup:
            case "open":
                group = _Group(found[0], [[]])
                current.append(group)
                stack.append(group)
                current = group.items[0]
            case "close":
                if not stack or _CLOSING[stack[-1].opening] != found[0]:
                    return None
                stack.pop()
                current = stack[-1].items[-1] if stack else top
            case "comma" if stack:
                stack[-1].items.append([])
                current = stack[-1].items[-1]
            case _:
                current.append(found[0])
    return None if stack else top


def _break(parts: list[_Part], indent: int, tail: str) -> list[str]:
    """Lay out parts from a column on; `tail` follows them on their last line."""
    margin = " " * indent
    flat = margin + _flat(parts) + tail
    if width(flat) <= LINE_LENGTH:
        return [flat]
    at = next((i for i in reversed(range(len(parts))) if _is_breakable(parts[i])), None)
    if at is None:
        return _break_string(_flat(parts), indent, tail) or [flat]
    group = parts[at]
    assert isinstance(group, _Group)
    head = margin + _flat(parts[:at]) + group.opening
    foot = margin + _CLOSING[group.opening] + _flat(parts[at + 1 :]) + tail
    return [head, *_break_items(group, indent + _INDENT), foot]


def _break_items(group: _Group, indent: int) -> list[str]:
    """Lay out a bracket's items: a call's on one line when they fit, else one a line."""
    if len(group.items) == 1:
        return _break(group.items[0], indent, "")
    together = " " * indent + ", ".join(map(_flat, group.items))
    if group.opening == "(" and width(together) <= LINE_LENGTH:
        return [together]
    return [line for item in group.items for line in _break(item, indent, ",")]


def _break_string(text: str, indent: int, tail: str) -> list[str]:
    """Lay out a long string in parentheses, in pieces; nothing when it is no text of words."""
    found = _STRING_ITEM.fullmatch(text)
    if found is None or " " not in found["literal"]:
        return []
    value = str(literals.value_of(found["literal"]))
    margin = " " * indent
    room = LINE_LENGTH - indent - _INDENT
    whole = literals.string(value)
    pieces = [whole] if width(whole) <= room else _pieces(value, room)
    body = [f"{margin}{' ' * _INDENT}{piece}" for piece in pieces]
    return [f"{margin}{found['name']}(", *body, f"{margin}){tail}"]


def _pieces(value: str, room: int) -> list[str]:
    """Cut a string into literals that fit, after a space where there is one."""
    pieces: list[str] = []
    while value:
        end = min(len(value), max(room - 2, 1))
        while end > 1 and width(literals.string(value[:end])) > room:
            end -= 1
        if end < len(value):
            end = value.rfind(" ", 0, end) + 1 or end
        pieces.append(literals.string(value[:end]))
        value = value[end:]
    return pieces


def _flat(parts: list[_Part]) -> str:
    return "".join(map(str, parts))


def _is_breakable(part: _Part) -> bool:
    return isinstance(part, _Group) and part.items != [[]]
