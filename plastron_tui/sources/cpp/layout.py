"""Break long lines of C++, as the style of ROS 2 has it: at brackets, two columns further in.

Templates and edits write each statement on one line; `fit` breaks those that are longer than a
line may be. It knows what they need: brackets, commas, operators of streams and strings.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from plastron_tui.diagnostics.terminal import width

LINE_LENGTH = 100
"""The longest line that ament_cpplint and ament_uncrustify allow."""

_INDENT = "  "
_TOKEN = re.compile(
    r'(?P<string>(?:u8|u|U|L)?"(?:[^"\\]|\\.)*")'
    r"|(?P<character>'(?:[^'\\]|\\.)*')"
    r"|(?P<open>[({\[])|(?P<close>[)}\]])|(?P<comma>, ?)|(?P<stream> << )"
    r"|(?P<other>[A-Za-z0-9_.:]+|.)"
)
_PIECE = re.compile(r"(?:\\(?:[0-7]{1,3}|.)|[^\\ ])*(?: +|$)")

_CONDITION = re.compile(r"\s*(?:if|for|while|switch) \(")


@dataclass(slots=True)
class _Group:
    """A bracket, with the items between its commas."""

    opening: str
    items: list[list[_Part]]
    closing: str

    def __str__(self) -> str:
        return f"{self.opening}{', '.join(map(_flat, self.items))}{self.closing}"


_Part = str | _Group


def fit(source: str, limit: int = LINE_LENGTH) -> str:
    """Break the lines of `source` that are too long; the others are left as they are."""
    lines: list[str] = []
    for line in source.split("\n"):
        if width(line) <= limit or line.lstrip().startswith(("//", "#")):
            lines.append(line)
        else:
            margin = line[: len(line) - len(line.lstrip())]
            lines += _brace_apart(_broken(_scan(line.lstrip()), margin, limit), margin)
    return "\n".join(lines)


def _brace_apart(lines: list[str], margin: str) -> list[str]:
    """Open the block of a condition that takes several lines on a line of its own."""
    *before, last = lines
    if before and _CONDITION.match(before[0]) and last.endswith(") {"):
        return [*before, last.removesuffix(" {"), f"{margin}{{"]
    return lines


def _scan(text: str) -> list[_Part]:
    """Take a line apart; a bracket that is not closed in it ends with the line."""
    stack: list[_Group] = [_Group("", [[]], "")]
    for match in _TOKEN.finditer(text):
        token = match.group()
        group = stack[-1]
        if match.lastgroup == "open":
            inner = _Group(token, [[]], "")
            group.items[-1].append(inner)
            stack.append(inner)
        elif match.lastgroup == "close" and len(stack) > 1:
            group.closing = token
            stack.pop()
        elif match.lastgroup == "comma" and len(stack) > 1:
            group.items.append([])
        else:
            group.items[-1].append(token)
    return stack[0].items[0]


def _flat(parts: list[_Part]) -> str:
    return "".join(map(str, parts))


def _broken(parts: list[_Part], margin: str, limit: int) -> list[str]:
    """Return the lines of a statement that is too long for one."""
    text = _flat(parts)
    if width(margin + text) <= limit:
        return [margin + text]
    at = _where(parts, margin, limit)
    if at is None:
        return _without_brackets(parts, margin, limit)
    group = parts[at]
    assert isinstance(group, _Group)
    inner = margin + _INDENT
    head = margin + _flat(parts[:at]) + group.opening
    tail = group.closing + _flat(parts[at + 1 :])
    return [head, *_filled(group.items, tail, inner, limit)]


def _where(parts: list[_Part], margin: str, limit: int) -> int | None:
    """Return which bracket is broken: the last that begins in time, of those with anything in."""
    found, before = None, width(margin)
    for index, part in enumerate(parts):
        if isinstance(part, _Group) and part.items != [[]] and before < limit:
            longest = found is None or width(str(part)) > width(str(parts[found]))
            found = index if longest else found
        before += width(str(part))
    return found


def _filled(items: list[list[_Part]], tail: str, margin: str, limit: int) -> list[str]:
    """Lay items out, as many on a line as there is room for; the tail is behind the last."""
    texts = [
        _flat(item) + ("," if index < len(items) - 1 else tail) for index, item in enumerate(items)
    ]
    lines: list[str] = []
    current = margin
    for index, text in enumerate(texts):
        joined = f"{current} {text}" if current.strip() else current + text
        if width(joined) <= limit:
            current = joined
            continue
        if current.strip():
            lines.append(current)
        current = margin + text
        if width(current) > limit:
            parts = [*items[index], "," if index < len(items) - 1 else tail]
            *done, current = _broken(parts, margin, limit)
            lines += done
    return [*lines, current]


def _without_brackets(parts: list[_Part], margin: str, limit: int) -> list[str]:
    """Break a string into several, or a stream before its operators; else leave it."""
    if " << " in parts:
        at = len(parts) - 1 - parts[::-1].index(" << ")
        rest = margin + _INDENT + _flat(parts[at:]).lstrip()
        return [*_broken(parts[:at], margin, limit), rest]
    first, rest = parts[0], _flat(parts[1:])
    if isinstance(first, str) and first.startswith('"') and first.endswith('"'):
        return _split_string(first, rest, margin, limit)
    return [margin + _flat(parts)]


def _split_string(literal: str, tail: str, margin: str, limit: int) -> list[str]:
    lines, current = [], ""
    for piece in (match.group() for match in _PIECE.finditer(literal[1:-1]) if match.group()):
        if current and width(f'{margin}"{current}{piece}"{tail}') > limit:
            lines.append(f'{margin}"{current}"')
            current = ""
        current += piece
    return [*lines, f'{margin}"{current}"{tail}']


_OPENS = ("{", "public:", "private:", "protected:")


def lay_out(source: str) -> str:
    """Return what a template has written as people lay it out, and with lines that are in time.

    There is one empty line at most, and none behind what opens a block or before what closes it.
    """
    lines: list[str] = []
    for line in map(str.rstrip, source.split("\n")):
        if not line and (not lines or not lines[-1] or _opens(lines)):
            continue
        is_end = line.lstrip().startswith("}") and not line.startswith("}  //")
        if is_end and lines and not lines[-1]:
            lines.pop()
        lines.append(line)
    return fit("\n".join(lines).strip("\n") + "\n")


def _opens(lines: list[str]) -> bool:
    """Tell whether the last line opens a block, that of a namespace apart."""
    is_namespace = len(lines) > 1 and lines[-2].startswith("namespace ")
    return lines[-1].lstrip() in _OPENS and not is_namespace
