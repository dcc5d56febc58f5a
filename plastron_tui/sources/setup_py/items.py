"""Adding and removing what stands between the commas of a list, a dictionary or a call."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from tree_sitter import Node

from plastron_tui.sources.splices import Splice, indent_of, line_end, line_start, newline_of

from .values import items_of

_UNIT = b"    "
_LONGEST_LINE = 99
"""The longest line that ament_flake8 takes, in characters."""


def _begins_line(text: bytes, node: Node) -> bool:
    return not text[line_start(text, node.start_byte) : node.start_byte].strip()


def sorted_index(keys: Sequence[object], key: str) -> int:
    """Return where a key belongs: in its place in a list that is sorted, else at the end."""
    names = [each for each in keys if isinstance(each, str)]
    if len(names) < len(keys) or len(names) < 2 or names != sorted(names):
        return len(keys)
    return sum(each < key for each in names)


def insert(text: bytes, node: Node, item: Callable[[bytes], bytes], index: int) -> list[Splice]:
    """Insert an item in the style of its neighbours.

    Args:
        text: what is in the file.
        node: the list, the dictionary or the arguments.
        item: what the item is, given the indentation of its line.
        index: before which item, their number for the end.
    """
    items, closing = items_of(node), node.children[-1]
    end = newline_of(text)
    if not items:
        return _insert_first(text, node, item)
    own_line = _begins_line(text, items[-1]) and items[-1].start_point.row > node.start_point.row
    if not own_line:
        return _insert_within(text, items, item, index)
    indent = indent_of(text, items[min(index, len(items) - 1)].start_byte)
    new = item(indent)
    if index == 0:
        return [Splice(at := line_start(text, items[0].start_byte), at, indent + new + b"," + end)]
    before = items[index - 1]
    comma = comma_after(node, before)
    splices = []
    after = before.end_byte
    if comma is None:
        splices.append(Splice(before.end_byte, before.end_byte, b","))
    else:
        after = comma.end_byte
    following = items[index] if index < len(items) else closing
    rest = text[after : line_end(text, after)].strip()
    if following.start_byte < line_end(text, after) or (rest and not rest.startswith(b"#")):
        is_last = index == len(items)
        tail = b"" if comma is None and is_last else b","
        splices.append(Splice(after, after, end + indent + new + tail))
        return splices
    at = line_end(text, after)
    tail = b"" if comma is None and index == len(items) else b","
    splices.append(Splice(at, at, indent + new + tail + end))
    return splices


def _insert_first(text: bytes, node: Node, item: Callable[[bytes], bytes]) -> list[Splice]:
    """Insert the only item: on a line of its own where the brackets stand on two lines."""
    opening, closing = node.children[0], node.children[-1]
    if not _begins_line(text, closing) or closing.start_point.row == opening.start_point.row:
        indent = indent_of(text, node.start_byte)
        return [Splice(opening.end_byte, opening.end_byte, item(indent))]
    indent = indent_of(text, closing.start_byte) + _UNIT
    for each in node.named_children:
        if _begins_line(text, each):
            indent = indent_of(text, each.start_byte)
    at = line_start(text, closing.start_byte)
    return [Splice(at, at, indent + item(indent) + b"," + newline_of(text))]


def _insert_within(
    text: bytes, items: Sequence[Node], item: Callable[[bytes], bytes], index: int
) -> list[Splice]:
    """Insert an item into a line; a line that gets too long is broken before the item."""
    indent = b" " * items[0].start_point.column
    new = item(indent_of(text, items[0].start_byte))
    if index == 0:
        at = items[0].start_byte
        return [Splice(at, at, new + b", ")]
    at = items[index - 1].end_byte
    start = line_start(text, at)
    is_long = len((text[start:at] + b", " + new).decode(errors="replace")) > _LONGEST_LINE
    space = newline_of(text) + indent if is_long else b" "
    return [Splice(at, at, b"," + space + new)]


def comma_after(node: Node, item: Node) -> Node | None:
    """Return the comma that ends an item."""
    found = False
    for each in node.children:
        if found and each.type == ",":
            return each
        if found and each.type != "comment":
            return None
        found = found or each.id == item.id
    return None


def removals(text: bytes, node: Node, item: Node) -> Iterator[list[Splice]]:
    """Return the ways to take an item out, the tidiest first."""
    items = items_of(node)
    index = next(at for at, each in enumerate(items) if each.id == item.id)
    comma = comma_after(node, item)
    end = item.end_byte if comma is None else comma.end_byte
    first, last = line_start(text, item.start_byte), line_end(text, end)
    rest = text[end:last].strip()
    if _begins_line(text, item) and (not rest or rest.startswith(b"#")):
        yield [Splice(first, last)]
        if index and (earlier := comma_after(node, items[index - 1])) is not None:
            yield [Splice(earlier.start_byte, earlier.end_byte), Splice(first, last)]
    if index:
        yield [Splice(items[index - 1].end_byte, item.end_byte)]
        earlier = comma_after(node, items[index - 1])
        if earlier is not None:
            yield [Splice(earlier.end_byte, end)]
    if index + 1 < len(items):
        yield [Splice(item.start_byte, items[index + 1].start_byte)]
    yield [Splice(item.start_byte, end)]
