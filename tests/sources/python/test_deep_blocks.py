"""Blocks within blocks: more of them than the scanner of tree-sitter-python has room for."""

from __future__ import annotations

import pytest
from tree_sitter import Node

from plastron_tui.sources.python.error_recovery import bound_indents
from plastron_tui.sources.python.syntax import parse


@pytest.mark.parametrize("unit", [b" ", b"\t", b"\f ", b" \\\n"])
def test_no_more_blocks_are_within_each_other_than_the_scanner_has_room_for(unit: bytes) -> None:
    text = b"".join(unit * depth + b"if x:\n" for depth in range(300)) + unit * 300 + b"pass\n"
    syntax = parse(text)
    assert syntax.text == text
    assert syntax.root.end_byte == len(text)
    assert _depth(syntax.root) <= 257


def test_indents_that_people_write_stay() -> None:
    text = b"if x:\n" + b" " * 200 + b"y = 1\n\t\t\tz = '''\n" + b" " * 255 + b"'''\n"
    assert bound_indents(text) == text


def _depth(node: Node) -> int:
    """Return how many blocks are within each other."""
    deepest, stack = 0, [(node, 0)]
    while stack:
        node, depth = stack.pop()
        deepest = max(deepest, depth)
        stack += [(child, depth + (child.type == "block")) for child in node.named_children]
    return deepest
