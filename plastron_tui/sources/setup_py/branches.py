"""Which branches of a setup.py run: the environment variable `ROS_VERSION` chooses among them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

_VERSION = re.compile(
    rb"(?:int\(\s*|str\(\s*)?(?:os\.)?"
    rb"(?:environ\[\s*['\"]ROS_VERSION['\"]\s*\]"
    rb"|(?:environ\.get|getenv)\(\s*['\"]ROS_VERSION['\"]\s*(?:,[^()]*)?\))\s*\)?"
)
_LITERAL = re.compile(rb"['\"]?(\d+)['\"]?")


class Branching(NamedTuple):
    """An `if` statement.

    Attributes:
        node: the statement.
        blocks: its branches.
        runs: of each whether it runs, None where that is not known.
    """

    node: Node
    blocks: tuple[Node, ...]
    runs: tuple[bool | None, ...]

    def which(self, node: Node) -> int | None:
        """Return which of the branches a node is in, None for none of them."""
        for at, block in enumerate(self.blocks):
            if block.start_byte <= node.start_byte and node.end_byte <= block.end_byte:
                return at
        return None


class Way(NamedTuple):
    """What runs on the way to a node.

    Attributes:
        taken: the branches that run, by the ids of their blocks; each with its `if` statement.
        left_out: the branches that do not run, by the ids of their blocks.
        is_sure: whether the node surely runs.
    """

    taken: dict[int, Node]
    left_out: frozenset[int]
    is_sure: bool


def read_branchings(text: bytes, nodes: Iterable[Node], ros_version: int) -> list[Branching]:
    """Return the `if` statements of a file.

    Args:
        text: the file.
        nodes: all nodes of its tree.
        ros_version: the generation of ROS, which `ROS_VERSION` is.
    """
    bound: Counter[bytes] = Counter()
    versions: set[bytes] = set()
    statements: list[Node] = []
    for node in nodes:
        if node.type == "assignment":
            left, right = (node.child_by_field_name(each) for each in ("left", "right"))
            name = _source(text, left)
            bound[name] += 1
            if _VERSION.fullmatch(_source(text, right)):
                versions.add(name)
        elif node.type == "if_statement":
            statements.append(node)
    known = frozenset(name for name in versions if bound[name] == 1)
    return [_branching(text, each, known, str(ros_version).encode()) for each in statements]


def way_to(node: Node, branchings: Iterable[Branching]) -> Way:
    """Return what runs on the way to a node, if it runs."""
    taken: dict[int, Node] = {}
    left_out: set[int] = set()
    is_sure = True
    for each in branchings:
        at = each.which(node)
        for other, (block, runs) in enumerate(zip(each.blocks, each.runs, strict=True)):
            if other == at or (at is None and runs):
                taken[block.id] = each.node
            elif at is not None or runs is False:
                left_out.add(block.id)
        is_sure = is_sure and (at is None or each.runs[at] is True)
    return Way(taken, frozenset(left_out), is_sure)


def never_runs(node: Node, branchings: Iterable[Branching]) -> bool:
    """Tell whether a node is in a branch that does not run."""
    return any((at := x.which(node)) is not None and x.runs[at] is False for x in branchings)


def are_apart(one: Node, other: Node, branchings: Iterable[Branching]) -> bool:
    """Tell whether two nodes are in branches of which only one runs."""
    for each in branchings:
        first, second = each.which(one), each.which(other)
        if first is not None and second is not None and first != second:
            return True
    return False


def _branching(text: bytes, node: Node, versions: frozenset[bytes], version: bytes) -> Branching:
    blocks, runs = list[Node](), list[bool | None]()
    before: bool | None = False
    for condition, block in _clauses(node):
        # An `else` has no condition.
        holds = True if condition is None else _holds(text, condition, versions, version)
        if before is True or holds is False:
            runs.append(False)
        else:
            runs.append(holds if before is False else None)
            before = True if holds else None
        blocks.append(block)
    return Branching(node, tuple(blocks), tuple(runs))


def _clauses(node: Node) -> Iterator[tuple[Node | None, Node]]:
    """Yield the branches of an `if` statement, each with its condition."""
    for each in (node, *node.children_by_field_name("alternative")):
        block = each.child_by_field_name("body" if each.type == "else_clause" else "consequence")
        if block is not None:
            yield each.child_by_field_name("condition"), block


def _holds(text: bytes, condition: Node, versions: frozenset[bytes], version: bytes) -> bool | None:
    """Tell whether a condition holds, None where it is not a comparison with `ROS_VERSION`."""
    while condition.type == "parenthesized_expression" and condition.named_child_count == 1:
        condition = condition.named_children[0]
    if b"__name__" in _source(text, condition):
        return True
    sides: Sequence[Node] = condition.named_children
    if condition.type != "comparison_operator" or len(sides) != 2:
        return None
    sign = text[sides[0].end_byte : sides[1].start_byte].strip()
    given = [_source(text, each) for each in sides]
    literals = [found[1] for each in given if (found := _LITERAL.fullmatch(each))]
    is_asked = any(each in versions or _VERSION.fullmatch(each) for each in given)
    if not is_asked or len(literals) != 1 or sign not in (b"==", b"!="):
        return None
    return (literals[0] == version) is (sign == b"==")


def _source(text: bytes, node: Node | None) -> bytes:
    return b"" if node is None else text[node.start_byte : node.end_byte]
