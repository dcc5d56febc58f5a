"""Lay out a line of a definition as the lines around it are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

_BLANK = b" \t"
_TAB = b"\t"
_LEAST = 2
"""How many lines have to agree before it counts as meant."""


class _Parts(NamedTuple):
    """A member in parts, b"" for those that it has not.

    Attributes:
        indent: the spaces before it.
        type: its type.
        name: its name.
        sign: the `=` of a constant.
        value: its value, or its default.
        comment: what starts with `#`.
        columns: where name, sign, value and comment start; where one is missing, -1.
        ends: where what is before each of these ends.
    """

    indent: bytes
    type: bytes
    name: bytes
    sign: bytes
    value: bytes
    comment: bytes
    columns: tuple[int, int, int, int]
    ends: tuple[int, int, int, int]


def laid_out(line: bytes, others: Sequence[bytes]) -> bytes:
    """Return a member with its parts in the columns that other members share.

    A column counts where somebody has lined it up, with more than one space; what is too long for
    it just follows. A line with tabs between its parts stays as it is, and is no example.

    Args:
        line: the member, without its end.
        others: the lines of other members, without their ends.
    """
    new = _parts(line)
    known = [each for each in map(_parts, others) if each is not None]
    if new is None or not known:
        return line
    like = [each for each in known if bool(each.sign) is bool(new.sign)]
    gaps = [column - end for column, end in zip(new.columns, new.ends, strict=True)]
    if new.sign and like:
        last = like[-1]
        gaps[1:3] = [min(last.columns[at] - last.ends[at], 1) for at in (1, 2)]
    text = known[-1].indent + new.type
    for at, part in enumerate((new.name, new.sign, new.value, new.comment)):
        if part:
            column = _column(known if at in (0, 3) else like, at)
            is_reached = column is not None and column > len(text)
            text = text.ljust(column or 0) if is_reached else text + b" " * gaps[at]
            text += part
    return text


def _column(members: Sequence[_Parts], part: int) -> int | None:
    """Return the column that a part has in all members, None where it just follows."""
    found = [each for each in members if each.columns[part] >= 0]
    columns = {each.columns[part] for each in found}
    is_meant = any(each.columns[part] - each.ends[part] > 1 for each in found)
    return columns.pop() if len(found) >= _LEAST and len(columns) == 1 and is_meant else None


def _parts(line: bytes) -> _Parts | None:
    """Return the parts of a member, None where it has tabs, or is none."""
    code, hash_, _ = line.partition(b"#")
    words = code.split(maxsplit=1)
    if len(words) < 2 or _TAB in code:
        return None
    is_constant = b"=" in words[1]
    if is_constant and words[0] == b"string":
        # In ROS 1 its text reaches to the end of the line, whatever is in it.
        code, hash_ = line.rstrip(_BLANK), b""
        words = code.split(maxsplit=1)
    name = words[1].split(b"=" if is_constant else None, 1)[0].rstrip(_BLANK)
    start = code.index(words[1], code.index(words[0]) + len(words[0]))
    end = start + len(name)
    sign_at = code.index(b"=", end) if is_constant else -1
    rest = code[sign_at + 1 if is_constant else end :]
    value = rest.strip(_BLANK)
    value_from = sign_at + 1 if is_constant else end
    value_at = value_from + len(rest) - len(rest.lstrip(_BLANK)) if value else -1
    comment_at = len(code) if hash_ else -1
    return _Parts(
        line[: len(line) - len(line.lstrip(_BLANK))],
        words[0],
        name,
        b"=" if is_constant else b"",
        value,
        line[comment_at:].rstrip(_BLANK) if hash_ else b"",
        (start, sign_at, value_at, comment_at),
        (code.index(words[0]) + len(words[0]), end, value_from, len(code.rstrip(_BLANK))),
    )
