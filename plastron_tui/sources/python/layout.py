"""Break long lines of Python source, as `ruff format` does or as a file has its others.

Templates and edits write each statement on one line; `fit` breaks those that are longer than a
line may be. It knows what they need: brackets, commas and strings.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from plastron_tui.diagnostics.terminal import width

from . import literals

LINE_LENGTH = 88
"""The default of `ruff format`."""

_CLOSING = {"(": ")", "[": "]", "{": "}"}
# What has names with commas between them, and what ends these.
_ENDS = {"lambda": ":", "for": "in"}
_WORDS = frozenset({*_ENDS, *_ENDS.values()})
_TOKEN = re.compile(
    r"""(?P<string>[A-Za-z]{0,2}(?:"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'))"""
    r"""|(?P<open>[(\[{])|(?P<close>[)\]}])|(?P<comma>,\ ?)|(?P<other>[A-Za-z0-9_.]+|[^"'])"""
)
_STRING_ITEM = re.compile(r"""(?P<name>(?:[A-Za-z_]\w*=)?)(?P<literal>["'].*["'])""")


@dataclass(frozen=True, slots=True)
class Brackets:
    """How brackets are broken that are too long for a line; by default as `ruff format` does.

    Attributes:
        limit: how long a line may be.
        indent: one level of indent.
        is_visual: whether what follows stands below what is behind the opening bracket.
        is_closed_apart: whether the closing bracket has a line of its own.
        is_each_apart: whether every item has a line of its own, even if all fit on one.
        has_comma: whether a comma is behind the last of items on lines of their own.
        splits_strings: whether a text may be broken into several.
    """

    limit: int = LINE_LENGTH
    indent: str = "    "
    is_visual: bool = False
    is_closed_apart: bool = True
    is_each_apart: bool = False
    has_comma: bool = True
    splits_strings: bool = True


def fit(source: str, brackets: Brackets = Brackets()) -> str:
    """Break the lines of `source` that are too long; the others are left as they are."""
    lines: list[str] = []
    for line in source.split("\n"):
        parts = _scan(line.lstrip()) if width(line) > brackets.limit else None
        if parts is None:
            lines.append(line)
        else:
            margin = line[: len(line) - len(line.lstrip())]
            lines += _break(parts, margin, "", brackets)
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
            case "comma" if stack and not _is_begun(current):
                stack[-1].items.append([])
                current = stack[-1].items[-1]
            case _:
                current.append(found[0])
    return None if stack else top


def _is_begun(item: list[_Part]) -> bool:
    """Whether the names of a `lambda` or a `for` are still to end, so that a comma parts them."""
    words = [part for part in item if isinstance(part, str) and part in _WORDS]
    return bool(words) and words[-1] in _ENDS


def _break(parts: list[_Part], margin: str, tail: str, style: Brackets) -> list[str]:
    """Lay out parts from a column on; `tail` follows them on their last line."""
    flat = margin + _flat(parts) + tail
    if width(flat) <= style.limit:
        return [flat]
    at = next((i for i in reversed(range(len(parts))) if _is_breakable(parts[i])), None)
    if at != len(parts) - 2 and (lines := _break_condition(parts, margin, style)):
        return lines
    if at is None:
        pieces = _break_string(_flat(parts), margin, tail, style) if style.splits_strings else []
        return pieces or [flat]
    group = parts[at]
    assert isinstance(group, _Group)
    head = margin + _flat(parts[:at]) + group.opening
    foot = _CLOSING[group.opening] + _flat(parts[at + 1 :]) + tail
    value = _value_of(parts) if width(head) > style.limit and style.is_closed_apart else []
    opened = f"{margin}{_flat(parts[: -len(value)])}("
    # A bracket of its own is set only where every line is short enough then.
    if value and width(opened) <= style.limit:
        inner = _break(value, margin + style.indent, "", style)
        if all(width(each) <= style.limit for each in inner):
            return [opened, *inner, f"{margin}){tail}"]
    if style.is_visual and (lines := _align(group, head, foot, style)):
        return lines
    if style.is_closed_apart:
        return [head, *_break_items(group, margin + style.indent, "", style), margin + foot]
    return [head, *_break_items(group, margin + style.indent, foot, style)]


def _value_of(parts: list[_Part]) -> list[_Part]:
    """Return what the one assignment of a line assigns, where parentheses may be set around it."""
    ends = [i for i in range(2, len(parts)) if parts[i - 2 : i + 1] == [" ", "=", " "]]
    is_whole = len(ends) == 1 and not any(sign in parts for sign in (";", "\\"))
    value = parts[ends[0] + 1 :] if is_whole else []
    return value if len(value) > 1 else []


def _break_items(group: _Group, margin: str, foot: str, style: Brackets) -> list[str]:
    """Lay out a bracket's items: a call's on one line when they fit, else one a line."""
    if len(group.items) == 1:
        return _break(group.items[0], margin, foot, style)
    together = margin + ", ".join(map(_flat, group.items)) + foot
    if group.opening == "(" and width(together) <= style.limit and not style.is_each_apart:
        return [together]
    *others, last = group.items
    end = foot or ("," if style.has_comma and not _flat(last).startswith("*") else "")
    lines = [line for item in others for line in _break(item, margin, ",", style)]
    return [*lines, *_break(last, margin, end, style)]


def _align(group: _Group, head: str, foot: str, style: Brackets) -> list[str]:
    """Lay out a bracket's items below its first one; nothing when one of them is too long."""
    *others, last = map(_flat, group.items)
    first, *following = [*(f"{each}," for each in others), last + foot]
    lines = [head + first]
    for item in following:
        if width(f"{lines[-1]} {item}") <= style.limit and not style.is_each_apart:
            lines[-1] += f" {item}"
        else:
            lines.append(" " * len(head) + item)
    return lines if all(width(each) <= style.limit for each in lines) else []


def _break_condition(parts: list[_Part], margin: str, style: Brackets) -> list[str]:
    """Lay out a long condition in parentheses, an operand a line; nothing where there is none."""
    word = next((each for each in ("or", "and") if each in parts), "")
    if not word or parts[0] not in ("if", "elif", "while") or parts[-1] != ":":
        return []
    operands: list[list[_Part]] = [[]]
    for part in parts[1:-1]:
        if part == word:
            operands.append([])
        operands[-1].append(part)
    inner = margin + style.indent
    lines = [f"{inner}{_flat(each).strip()}" for each in operands]
    return [f"{margin}{parts[0]} (", *lines, f"{margin}):"]


def _break_string(text: str, margin: str, tail: str, style: Brackets) -> list[str]:
    """Lay out a long string in parentheses, in pieces; nothing when it is no text of words."""
    found = _STRING_ITEM.fullmatch(text)
    if found is None or " " not in found["literal"]:
        return []
    value = str(literals.value_of(found["literal"]))
    room = style.limit - len(margin) - len(style.indent)
    whole = literals.string(value)
    pieces = [whole] if width(whole) <= room else _pieces(value, room)
    body = [f"{margin}{style.indent}{piece}" for piece in pieces]
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
