"""Splices: what an edit replaces; every byte that no splice covers stays."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from tree_sitter import Node

from .syntax import parts_of


@dataclass(frozen=True, slots=True, order=True)
class Splice:
    """Replace the bytes from `start` to `end` by `text`."""

    start: int
    end: int
    text: bytes = b""


def apply(text: bytes, splices: Iterable[Splice]) -> bytes:
    """Apply splices; deletions may overlap, and what is inserted at one place keeps its order."""
    parts: list[bytes] = []
    at = 0
    for splice in sorted(splices, key=lambda splice: (splice.start, splice.end)):
        start = max(splice.start, at)
        parts += (text[at:start], splice.text)
        at = max(splice.end, start)
    parts.append(text[at:])
    return b"".join(parts)


def line_start(text: bytes, offset: int) -> int:
    """Return where the line of an offset begins; a byte order mark is before the first line."""
    start = text.rfind(b"\n", 0, offset) + 1
    return 3 if start == 0 and text.startswith(b"\xef\xbb\xbf") else start


def line_end(text: bytes, offset: int) -> int:
    """Return where the line of an offset ends, its line ending included."""
    end = text.find(b"\n", offset)
    return len(text) if end < 0 else end + 1


def before_comments(text: bytes, at: int) -> int:
    """Step back over the comments in the lines before the start of a line."""
    while at > 0:
        previous = line_start(text, at - 1)
        line = text[previous:at].strip()
        if not line.startswith(b"#") or line.startswith(b"#!") or previous >= at:
            break
        at = previous
    return at


def delete_statements(text: bytes, statements: Sequence[Node]) -> list[Splice]:
    """Delete statements with their trailing comments; a block that they empty gets a `pass`."""
    splices: list[Splice] = []
    blocks: dict[int, tuple[Node, list[Node]]] = {}
    for statement in {node.id: node for node in statements}.values():
        parent = statement.parent
        if parent is not None:
            blocks.setdefault(parent.id, (parent, []))[1].append(statement)
    for block, gone in blocks.values():
        gone.sort(key=lambda node: node.start_byte)
        kept = [child for child in parts_of(block) if all(child.id != node.id for node in gone)]
        if not kept and block.type != "module":
            first = gone.pop(0)
            splices.append(Splice(first.start_byte, first.end_byte, b"pass"))
        splices += [_delete(text, node, gone) for node in gone]
    starts = {splice.start for splice in splices}
    return [_over_blank_lines(text, splice, starts) for splice in splices]


def _over_blank_lines(text: bytes, splice: Splice, starts: set[int]) -> Splice:
    """Delete the blank lines between two statements that are both deleted."""
    end = splice.end
    while not splice.text and end < len(text) and end not in starts:
        following = line_end(text, end)
        if text[end:following].strip():
            return splice
        end = following
    return Splice(splice.start, end) if end in starts and end > splice.end else splice


def _delete(text: bytes, statement: Node, gone: Sequence[Node]) -> Splice:
    start, end = statement.start_byte, statement.end_byte
    first, last = line_start(text, start), line_end(text, end)
    before, after = text[first:start], text[end:last].strip()
    if after.startswith(b";") and after[1:].strip()[:1] in (b"", b"#"):
        after = b""
    if not before.strip() and (not after or after.startswith(b"#")):
        is_definition = statement.type in ("function_definition", "decorated_definition")
        return Splice(_blank_lines_before(text, first) if is_definition else first, last)
    following = statement.next_named_sibling
    if after.startswith(b";") and following is not None:
        return Splice(start, following.start_byte)
    semicolon = text.rfind(b";", first, start)
    if semicolon >= 0:
        return Splice(semicolon, end)
    return Splice(start, end, b"pass")


def _blank_lines_before(text: bytes, start: int) -> int:
    """Return where the blank lines before a definition begin; those after it separate enough."""
    while start > 0:
        previous = line_start(text, start - 1)
        if text[previous:start].strip() or previous >= start:
            break
        start = previous
    return start


def delete_item(text: bytes, items: Sequence[Node], item: Node) -> Splice:
    """Delete one of several items between commas, with its comma, and its line if it has one."""
    index = next(i for i, other in enumerate(items) if other.id == item.id)
    if index + 1 < len(items):
        end = items[index + 1].start_byte
        # An item on a line of its own takes the line, and the next keeps its indent.
        first = line_start(text, item.start_byte)
        next_first = line_start(text, end)
        if next_first > item.end_byte and not text[first : item.start_byte].strip():
            return Splice(first, next_first)
        if next_first > item.end_byte:
            # The next item begins a line: keep the break that stands before it.
            comma = text.find(b",", item.end_byte, end)
            before = items[index - 1].end_byte if index else item.start_byte
            if index:
                return Splice(before, item.end_byte)
            return Splice(item.start_byte, comma + 1)
        return Splice(item.start_byte, end)
    if index:
        return Splice(items[index - 1].end_byte, item.end_byte)
    return Splice(item.start_byte, item.end_byte)
