"""What an edit takes out of the files of a unit, in whole lines where it can."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.splices import Splice, line_end, line_start

from ..scopes import CppFile

_COMMENT = re.compile(rb"[ \t]*(?://[^\n]*|/\*[^\n]*\*/[ \t]*)?\r?\n?")
_COMMENT_LINE = re.compile(rb"[ \t]*(?://|/\*[^\n]*\*/[ \t]*\r?\n?$)")
_OPENING = re.compile(
    rb"(?:.*\{|[ \t]*(?:public|private|protected)[^\n]*:)[ \t]*\r?\n?\Z", re.DOTALL
)
_ENDING = re.compile(rb"[ \t]*[})]")


class Deletions:
    """Parts of files that go."""

    def __init__(self) -> None:
        self._parts: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)
        self._lines: defaultdict[CppFile, list[tuple[int, int]]] = defaultdict(list)

    def statement(self, file: CppFile, node: Node) -> None:
        """Take out a statement or declaration, with its lines where it has them alone."""
        self._lines[file].append((node.start_byte, node.end_byte))

    def part(self, file: CppFile, start: int, end: int) -> None:
        """Take out a part of a line."""
        self._parts[file].append((start, end))

    def covers(self, file: CppFile, offset: int) -> bool:
        """Tell whether what stands at an offset goes."""
        parts = (*self._parts[file], *self._lines[file])
        return any(start <= offset < end for start, end in parts)

    @property
    def files(self) -> Iterator[CppFile]:
        """The files that lose something."""
        yield from dict.fromkeys((*self._parts, *self._lines))

    def splices(self, file: CppFile) -> list[Splice]:
        """Return the splices for a file."""
        text = file.syntax.text
        found = _merged(text, [_lines_of(text, start, end) for start, end in self._lines[file]])
        whole = [_tidy(text, *_with_comment(text, start, end)) for start, end in found]
        return [Splice(start, end) for start, end in _merged(text, [*whole, *self._parts[file]])]


def _lines_of(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Return the whole lines of a statement that has them alone."""
    first, last = line_start(text, start), line_end(text, max(start, end - 1))
    behind = _COMMENT.match(text, end, last)
    if text[first:start].strip() or behind is None or behind.end() != last:
        return _with_blanks(text, start, end)
    return first, last


def _with_blanks(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Take the blanks beside a statement that shares its line with others."""
    before, behind = start, end
    while text[before - 1 : before] in (b" ", b"\t"):
        before -= 1
    while text[behind : behind + 1] in (b" ", b"\t"):
        behind += 1
    if before == line_start(text, start):
        return start, behind
    if text[before - 1 : before] == b"{" and text[behind : behind + 1] == b"}":
        return before, behind
    return before, end


def _with_comment(text: bytes, first: int, last: int) -> tuple[int, int]:
    """Return whole lines with the comment above them that speaks of them alone."""
    if first != line_start(text, first) or last != line_end(text, last - 1):
        return first, last
    top = first
    while top > 0:
        above = line_start(text, top - 1)
        if not _COMMENT_LINE.match(text[above:top]):
            break
        top = above
    below = text[last : line_end(text, last)]
    is_apart = not below.strip() or _ENDING.match(below) or _COMMENT_LINE.match(below)
    is_doc = text[top:first].lstrip().startswith((b"///", b"/**", b"//!"))
    return (top if is_doc or is_apart else first), last


def _is_edge(line: bytes) -> bool:
    return not line.strip() or _OPENING.match(line) is not None


def _merged(text: bytes, parts: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Join parts that overlap, or have nothing but empty lines between them."""
    found: list[tuple[int, int]] = []
    for start, end in sorted(parts):
        if found and (start <= found[-1][1] or not text[found[-1][1] : start].strip()):
            is_lines = found[-1][1] == line_start(text, found[-1][1])
            if start <= found[-1][1] or is_lines:
                found[-1] = found[-1][0], max(end, found[-1][1])
                continue
        found.append((start, end))
    return found


def _tidy(text: bytes, start: int, end: int) -> tuple[int, int]:
    """Take an empty line with lines that go where two would be left, or one at an edge."""
    if start != line_start(text, start) or end != line_end(text, end - 1):
        return start, end
    above = text[line_start(text, start - 1) : start] if start else b"{"
    below = text[end : line_end(text, end)]
    if not below.strip() and below and _is_edge(above):
        return start, line_end(text, end)
    if not above.strip() and start and _ENDING.match(below):
        return line_start(text, start - 1), end
    return start, end
