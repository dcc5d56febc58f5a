"""Change the bytes of a definition: only the lines of the member in question."""

from __future__ import annotations

from .definition_layout import laid_out

_BLANK = b" \t"


def add_member(text: bytes, line: str, section: int = 0) -> bytes:
    """Return the text with a line after the last member of a section, or at the section's end.

    A constant comes after the last constant, where there is one. The line is laid out as its
    neighbours are, and ends as the first line of the text does; the end of the text stays as it
    is. That the section has no member of this name yet is the caller's matter.

    Raises:
        ValueError: the text has no such section.
    """
    lines = _lines(text)
    start, end = _section(lines, section)
    members = [at for at in range(start, end) if member_name(lines[at])]
    new = laid_out(line.encode(), [lines[at].rstrip(b"\r\n") for at in members])
    if is_constant(new):
        members = [at for at in members if is_constant(lines[at])] or members
    at = end
    if members:
        at = members[-1] + 1
        while at < end and _continues(lines[at], lines[members[-1]]):
            at += 1
    newline = b"\r\n" if lines and lines[0].endswith(b"\r\n") else b"\n"
    if at == len(lines) and lines and not lines[-1].endswith(b"\n"):
        return text + newline + new
    return b"".join([*lines[:at], new + newline, *lines[at:]])


def remove_member(text: bytes, name: str, section: int | None = None) -> bytes:
    """Return the text without a member, and without the comments that speak of it alone.

    Such are comments behind it, deeper indented ones below it, and a block right above it that
    stands between members, where no other member follows right after. All else stays.

    Raises:
        ValueError: there is no such member, or no such section.
    """
    lines = _lines(text)
    at = _find(lines, name, section)
    start, end = at, at + 1
    while end < len(lines) and _continues(lines[end], lines[at]):
        end += 1
    while start and _is_comment(lines[start - 1]) and not _continues(lines[start - 1], lines[at]):
        start -= 1
    follows = end < len(lines) and bool(member_name(lines[end]))
    if follows or not _has_member_before(lines, start):
        start = at
    kept = lines[:start]
    if end == len(lines) and not lines[-1].endswith(b"\n") and kept:
        kept[-1] = kept[-1].removesuffix(b"\n").removesuffix(b"\r")
    return b"".join([*kept, *lines[end:]])


def replace_member(
    text: bytes, name: str, line: str, section: int | None = None, ros_version: int = 2
) -> bytes:
    """Return the text with another field or constant in a member's place, its comment kept.

    A string constant of ROS 1 reaches to the end of its line: what it had after a `#` goes with
    it, and the comment of a member that becomes one goes on a line above it.

    Raises:
        ValueError: there is no such member, or no such section.
    """
    lines = _lines(text)
    at = _find(lines, name, section)
    old = lines[at]
    ending = old[len(old.rstrip(b"\r\n")) :]
    body = old[: len(old) - len(ending)]
    was_text = ros_version == 1 and _is_string_constant(body)
    code = body.split(b"#")[0].rstrip() if b"#" in body and not was_text else body
    new, comment = line.encode(), body[len(code) :]
    if comment and ros_version == 1 and _is_string_constant(new):
        new, comment = comment.lstrip(_BLANK) + (ending or b"\n") + new, b""
    elif b"#" not in new:
        like = [each.rstrip(b"\r\n") for each in _members_beside(lines, at)]
        new, comment = laid_out(new + comment, like), b""
    lines[at] = new + comment + ending
    return b"".join(lines)


def _members_beside(lines: list[bytes], at: int) -> list[bytes]:
    """Return the members of the section that a line is in."""
    start = next((i for i in range(at, -1, -1) if lines[i].startswith(b"---")), -1) + 1
    end = next((i for i in range(at, len(lines)) if lines[i].startswith(b"---")), len(lines))
    return [each for each in lines[start:end] if member_name(each)]


def _is_string_constant(line: bytes) -> bool:
    words = line.split(b"#")[0].split(maxsplit=1)
    return len(words) == 2 and words[0] == b"string" and b"=" in words[1]


def is_constant(line: bytes) -> bool:
    """Tell whether the line of a member is that of a constant."""
    return b"=" in line.split(b"#")[0].split(maxsplit=1)[-1].split(b"'")[0].split(b'"')[0]


def member_name(line: bytes) -> str | None:
    """Return the name of the field or constant of a line, None for any other line."""
    code = line.split(b"#")[0].split(maxsplit=1)
    if len(code) < 2 or line.startswith(b"---"):
        return None
    name = code[1].split(b"=")[0].split()
    return name[0].decode("utf-8", "replace") if name else None


def _lines(text: bytes) -> list[bytes]:
    """Return the lines with their ends; only a newline ends one."""
    lines = [each + b"\n" for each in text.split(b"\n")]
    lines[-1] = lines[-1][:-1]
    return lines if lines[-1] else lines[:-1]


def _section(lines: list[bytes], section: int) -> tuple[int, int]:
    bounds = [-1, *(at for at, each in enumerate(lines) if each.startswith(b"---")), len(lines)]
    if not 0 <= section < len(bounds) - 1:
        raise ValueError(f"no section {section} in this definition")
    return bounds[section] + 1, bounds[section + 1]


def _find(lines: list[bytes], name: str, section: int | None) -> int:
    start, end = (0, len(lines)) if section is None else _section(lines, section)
    for at in range(start, end):
        if member_name(lines[at]) == name:
            return at
    raise ValueError(f"no member `{name}` in this definition")


def _is_comment(line: bytes) -> bool:
    return line.lstrip(_BLANK).startswith(b"#")


def _indent(line: bytes) -> int:
    return len(line) - len(line.lstrip(_BLANK))


def _continues(line: bytes, member: bytes) -> bool:
    """Tell whether a comment is indented deeper than the member above it, and so goes on it."""
    return _is_comment(line) and _indent(line) > _indent(member)


def _has_member_before(lines: list[bytes], start: int) -> bool:
    for line in reversed(lines[:start]):
        if line.startswith(b"---"):
            return False
        if member_name(line):
            return True
    return False
