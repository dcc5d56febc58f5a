"""A setup.py as bytes, its syntax tree, and what its names stand for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import tree_sitter_python
from tree_sitter import Language, Node

from plastron_tui.diagnostics import codes
from plastron_tui.sources.build_files import check_text, refusal
from plastron_tui.sources.grammars import BoundedParser, first_error, python_lines

from .branches import Branching, are_apart, never_runs, read_branchings, way_to
from .names import Names, descendants, read_names

_SETUP_CALLS = frozenset({"setup", "setuptools.setup", "distutils.core.setup"})
# Names that stand for each other in a circle stand for nothing.
_MOST_NAMES = 20
# What is deeper was made to keep readers busy.
_DEEPEST = 400
_CATKIN_CALL = "generate_distutils_setup"
_MOST_SETUP_CALLS = 20


def parse_python(text: bytes) -> Node:
    """Return the root of the tree of a text in Python, over exactly its bytes."""
    return _parser().parse(python_lines(text)).root_node


@cache
def _parser() -> BoundedParser:
    return BoundedParser(Language(tree_sitter_python.language()))


@dataclass(frozen=True, slots=True)
class Setup:
    """A parsed setup.py.

    Attributes:
        text: what is in the file.
        path: the file.
        call: the call of `setup`, or catkin's of `generate_distutils_setup`.
        is_catkin: whether it is catkin's.
        names: what its names stand for, and where that is changed.
        is_sure: whether the call hangs on no condition, but for the generation of ROS.
    """

    text: bytes
    path: Path
    call: Node
    is_catkin: bool
    names: Names
    is_sure: bool = True

    def source(self, node: Node) -> str:
        """Return the text of a node."""
        return self.text[node.start_byte : node.end_byte].decode()

    def quote(self, *nodes: Node) -> str:
        """Return the quotes that strings have in the first of some nodes that has any."""
        for each in (part for node in nodes for part in descendants(node)):
            if each.type == "string":
                return self.source(each).lstrip("rRfFbBuU")[:1] or "'"
        return "'"

    def resolve(self, node: Node) -> Node:
        """Return the expression that a name stands for, the node itself where it is no name."""
        for _ in range(_MOST_NAMES):
            if node.type == "parenthesized_expression" and node.named_child_count == 1:
                node = node.named_children[0]
                continue
            value = (
                self.names.constants.get(self.source(node)) if node.type == "identifier" else None
            )
            if value is None:
                break
            node = value
        return node

    def changed(self, node: Node) -> Node | None:
        """Return where something may change the value of a name, None where nothing does."""
        while node.type == "parenthesized_expression" and node.named_child_count == 1:
            node = node.named_children[0]
        return self.names.changes.get(self.source(node)) if node.type == "identifier" else None


def parse_setup(text: bytes, path: Path, ros_version: int = 2) -> Setup:
    """Parse a setup.py.

    Args:
        text: what is in the file.
        path: the file.
        ros_version: the generation of ROS that it is run for.

    Raises:
        RefusedError: it is no text, has a syntax error, or not one call of `setup`.
    """
    check_text(text, path)
    _check_encoding(text, path)
    root = parse_python(text)
    nodes = _nodes(text, path, root)
    if root.has_error:
        wrong = first_error(root)
        span = (wrong.start_byte, wrong.end_byte)
        raise refusal(text, path, span, "has a syntax error", codes.BROKEN_BUILD_FILE)
    calls = list(_setup_calls(text, nodes))
    branchings = read_branchings(text, nodes, ros_version)
    chosen = _chosen(calls, branchings, ros_version)
    if not chosen:
        why = "has no call of `setup` in the file that begins there"
        raise refusal(text, path, (0, 0), why, codes.BROKEN_BUILD_FILE)
    if len(chosen) > 1:
        span = (chosen[1].start_byte, chosen[1].end_byte)
        raise refusal(text, path, span, "calls `setup` a second time")
    way = way_to(chosen[0], branchings)
    names = read_names(text, root, [each for each, _ in calls], way)
    is_catkin = any(each for call, each in calls if call == chosen[0])
    return Setup(text, path, chosen[0], is_catkin, names, way.is_sure)


def _chosen(
    calls: list[tuple[Node, bool]], branchings: list[Branching], ros_version: int
) -> list[Node]:
    """Return the calls that may say what is installed: catkin's where there is one."""
    if len(calls) <= _MOST_SETUP_CALLS:
        calls = [each for each in calls if not never_runs(each[0], branchings)]
    catkin = [each for each, is_catkin in calls if is_catkin]
    plain = [each for each, is_catkin in calls if not is_catkin]
    if ros_version == 2 and catkin and len(calls) <= _MOST_SETUP_CALLS:
        # The call that takes what catkin's returns is in its branch.
        apart = [x for x in plain if all(are_apart(x, each, branchings) for each in catkin)]
        return apart or catkin
    return catkin or plain


def _check_encoding(text: bytes, path: Path) -> None:
    """Refuse a file whose coding line, one of the first two (PEP 263), names another encoding."""
    at = 0
    for line in python_lines(text).split(b"\n", 2)[:2]:
        comment, _, said = line.lower().partition(b"coding")
        name = said[1:].strip().replace(b"_", b"-")
        is_coding = comment.lstrip(b"\xef\xbb\xbf \t").startswith(b"#") and said[:1] in (b":", b"=")
        if is_coding and not name.startswith((b"utf-8", b"utf8", b"ascii", b"us-ascii")):
            span = (at + len(comment), at + len(line))
            raise refusal(text, path, span, "is not UTF-8", codes.UNREADABLE_FILE)
        at += len(line) + 1


def _nodes(text: bytes, path: Path, root: Node) -> list[Node]:
    """Return every node of a file; to ask one for its parent takes as long as it is deep."""
    found: list[Node] = []
    stack = [(root, 0)]
    while stack:
        node, depth = stack.pop()
        if depth > _DEEPEST:
            span = (node.start_byte, node.end_byte)
            raise refusal(text, path, span, "is within too many others", codes.BROKEN_BUILD_FILE)
        found.append(node)
        stack.extend((each, depth + 1) for each in reversed(node.children))
    return found


def _setup_calls(text: bytes, nodes: list[Node]) -> Iterator[tuple[Node, bool]]:
    for node in nodes:
        function = node.child_by_field_name("function") if node.type == "call" else None
        if function is None:
            continue
        name = text[function.start_byte : function.end_byte].decode()
        arguments = node.child_by_field_name("arguments")
        if arguments is None or arguments.type != "argument_list":
            continue
        is_catkin = name.rpartition(".")[2] == _CATKIN_CALL
        if name in _SETUP_CALLS or is_catkin:
            yield node, is_catkin
