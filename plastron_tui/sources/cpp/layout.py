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

_ATOM = re.compile(r"\\(?:[0-7]{1,3}|.)|.")
_DECLARATION = re.compile(r"(?P<type>[\w:<>, ]*[\w>]) (?P<name>\w+;)")
_ARITHMETIC = ("+", "-", "*", "/")
_CONDITION = re.compile(r"\s*(?:if|for|while|switch) \(")


@dataclass(slots=True)
class _Group:
    """A bracket, with the items between its commas."""

    opening: str
    items: list[list[_Part]]
    closing: str

    @property
    def is_breakable(self) -> bool:
        """Whether a line may break in it: not before an index, or what a lambda captures."""
        return self.items != [[]] and self.opening != "["

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


def _broken(parts: list[_Part], margin: str, limit: int, continuation: str = _INDENT) -> list[str]:
    """Return the lines of a statement, or of what is in brackets, that is too long for one."""
    text = _flat(parts)
    if width(margin + text) <= limit:
        return [margin + text]
    at = _where(parts, margin, limit)
    if at is None:
        return _without_brackets(parts, margin, limit)
    lines = _opened(parts, at, margin, margin + _INDENT, limit)
    is_long = any(width(line) > limit for line in lines)
    return (_calculation(parts, margin, limit, continuation) if is_long else []) or lines


def _calculation(parts: list[_Part], margin: str, limit: int, continuation: str) -> list[str]:
    """Break what is calculated behind operators; return nothing where that does not help."""
    pieces = [""]
    for index, part in enumerate(parts):
        pieces[-1] += str(part)
        if part == " " and parts[index - 1] in _ARITHMETIC and parts[index - 2] == " ":
            pieces.append("")
    lines = [margin + pieces[0]]
    for piece in pieces[1:]:
        if width((lines[-1] + piece).rstrip()) <= limit:
            lines[-1] += piece
        else:
            lines.append(margin + continuation + piece)
    found = [line.rstrip() for line in lines]
    return found if all(width(line) <= limit for line in found) else []


def _opened(parts: list[_Part], at: int, margin: str, inner: str, limit: int) -> list[str]:
    """Return a line up to a bracket, and those of what is in it, each with its margin."""
    group = parts[at]
    assert isinstance(group, _Group)
    head = margin + _flat(parts[:at]) + group.opening
    tail = group.closing + _flat(parts[at + 1 :])
    return [head, *_filled(group.items, tail, inner, limit)]


def _where(parts: list[_Part], margin: str, limit: int) -> int | None:
    """Return which bracket is broken: the last that begins in time, of those with anything in."""
    found, before = None, width(margin)
    for index, part in enumerate(parts):
        if isinstance(part, _Group) and part.is_breakable and before < limit:
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
            *done, current = _chain(parts, margin, limit) or _broken(parts, margin, limit, "")
            lines += done
    return [*lines, current]


def _chain(parts: list[_Part], margin: str, limit: int) -> list[str]:
    """Break an argument before one of the calls that it chains; return nothing if it has none."""
    for at in range(len(parts) - 1, 0, -1):
        part, head = parts[at], margin + _flat(parts[:at])
        is_call = (
            isinstance(part, str) and part.startswith(".") and isinstance(parts[at - 1], _Group)
        )
        if is_call and width(head) <= limit:
            rest = parts[at:]
            if width(margin + _flat(rest)) <= limit:
                return [head, margin + _flat(rest)]
            return [head, *(_chain(rest, margin, limit) or _broken(rest, margin, limit))]
    return []


def _without_brackets(parts: list[_Part], margin: str, limit: int) -> list[str]:
    """Break a stream, an assignment, a string or a declaration; else leave it."""
    if " << " in parts:
        at = len(parts) - 1 - parts[::-1].index(" << ")
        rest = margin + _INDENT + _flat(parts[at:]).lstrip()
        return [*_broken(parts[:at], margin, limit), rest]
    if "=" in parts[1:-2]:
        at = parts.index("=") + 1
        return [margin + _flat(parts[:at]), *_assigned(parts[at + 1 :], margin, limit)]
    if not margin and " " in parts and any(isinstance(part, _Group) for part in parts):
        at = parts.index(" ")
        return [_flat(parts[:at]), *_broken(parts[at + 1 :], margin, limit)]
    first, rest = parts[0], _flat(parts[1:])
    if isinstance(first, str) and first.startswith('"') and first.endswith('"'):
        return _split_string(first, rest, margin, limit)
    text = _flat(parts)
    if (declaration := _DECLARATION.fullmatch(text)) is not None:
        return [margin + declaration["type"], margin + _INDENT + declaration["name"]]
    return [margin + text]


def _assigned(parts: list[_Part], margin: str, limit: int) -> list[str]:
    """Return the lines of a value, behind a line that ends with `=`.

    ament_uncrustify counts what is in its brackets from the beginning of the statement.
    """
    inner = margin + _INDENT
    at = _where(parts, inner, limit)
    if at is None or width(inner + _flat(parts)) <= limit:
        return _broken(parts, inner, limit)
    return _opened(parts, at, inner, inner, limit)


def _split_string(literal: str, tail: str, margin: str, limit: int) -> list[str]:
    """Split a string at its spaces, and a word that is too long for a line anywhere."""
    lines, current = [], ""
    for piece in _PIECE.findall(literal[1:-1]):
        if current and width(f'{margin}"{current}{piece}"{tail}') > limit:
            lines.append(f'{margin}"{current}"')
            current = ""
        for atom in _ATOM.findall(piece):
            if current and width(f'{margin}"{current}{atom}"{tail}') > limit:
                lines.append(f'{margin}"{current}"')
                current = ""
            current += atom
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
