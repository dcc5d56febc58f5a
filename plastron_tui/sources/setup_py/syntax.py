"""A setup.py as bytes, its syntax tree, and what its names stand for."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import tree_sitter_python
from tree_sitter import Language, Node, Parser

from plastron_tui.diagnostics import codes
from plastron_tui.sources.build_files import check_text, refusal

_SETUP_CALLS = frozenset({"setup", "setuptools.setup", "distutils.core.setup"})
# Names that stand for each other in a circle stand for nothing.
_MOST_NAMES = 20
# What is deeper was made to keep readers busy.
_DEEPEST = 400
_CATKIN_CALL = "generate_distutils_setup"
_CHANGING = frozenset(
    {"append", "clear", "extend", "insert", "pop", "remove", "reverse", "sort", "update"}
)
# The fields that hold the names which are bound.
_BINDING = {
    "for_statement": "left",
    "for_in_clause": "left",
    "as_pattern": "alias",
    "named_expression": "name",
}
# What makes a statement within it run never, once or several times.
_UNSURE = frozenset(
    {"for_statement", "while_statement", "try_statement", "with_statement", "class_definition"}
)


@cache
def _parser() -> Parser:
    return Parser(Language(tree_sitter_python.language()))


@dataclass(frozen=True, slots=True)
class Setup:
    """A parsed setup.py.

    Attributes:
        text: what is in the file.
        path: the file.
        call: the call of `setup`, or catkin's of `generate_distutils_setup`.
        is_catkin: whether it is catkin's.
        constants: what a name stands for that is bound once, where that surely runs.
        changes: where a list or a dictionary of a name is changed after it was made.
        uses: how often each name is read.
    """

    text: bytes
    path: Path
    call: Node
    is_catkin: bool
    constants: Mapping[str, Node]
    changes: Mapping[str, Node]
    uses: Mapping[str, int]

    def source(self, node: Node) -> str:
        """Return the text of a node."""
        return self.text[node.start_byte : node.end_byte].decode()

    def resolve(self, node: Node) -> Node:
        """Return the expression that a name stands for, the node itself where it is no name."""
        for _ in range(_MOST_NAMES):
            if node.type == "parenthesized_expression" and node.named_child_count == 1:
                node = node.named_children[0]
                continue
            value = self.constants.get(self.source(node)) if node.type == "identifier" else None
            if value is None:
                break
            node = value
        return node

    def changed(self, node: Node) -> Node | None:
        """Return where something changes the value of a name later, None where nothing does."""
        for _ in range(_MOST_NAMES):
            if node.type != "identifier":
                break
            name = self.source(node)
            if name in self.changes:
                return self.changes[name]
            if name not in self.constants or self.constants[name].id == node.id:
                break
            node = self.constants[name]
        return None


def parse_setup(text: bytes, path: Path) -> Setup:
    """Parse a setup.py.

    Raises:
        RefusedError: it is no text, has a syntax error, or not one call of `setup`.
    """
    check_text(text, path)
    _check_encoding(text, path)
    root = _parser().parse(text).root_node
    nodes = _nodes(text, path, root)
    if root.has_error:
        wrong = next(each for each in nodes if each.is_error or each.is_missing)
        span = (wrong.start_byte, wrong.end_byte)
        raise refusal(text, path, span, "has a syntax error", codes.BROKEN_BUILD_FILE)
    calls = list(_setup_calls(text, nodes))
    catkin = [each for each, is_catkin in calls if is_catkin]
    chosen = catkin or [each for each, _ in calls]
    if not chosen:
        why = "has no call of `setup` in the file that begins there"
        raise refusal(text, path, (0, 0), why, codes.BROKEN_BUILD_FILE)
    if len(chosen) > 1:
        span = (chosen[1].start_byte, chosen[1].end_byte)
        raise refusal(text, path, span, "calls `setup` a second time")
    constants, changes, uses = _names(text, nodes)
    return Setup(text, path, chosen[0], bool(catkin), constants, changes, uses)


def _check_encoding(text: bytes, path: Path) -> None:
    """Refuse a file whose coding line, one of the first two (PEP 263), names another encoding."""
    at = 0
    for line in text.split(b"\n", 2)[:2]:
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


def descendants(root: Node) -> Iterator[Node]:
    """Return a node and all that is in it, in the order of the text, without recursion."""
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(node.children))


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


def _names(text: bytes, nodes: list[Node]) -> tuple[dict[str, Node], dict[str, Node], Counter[str]]:
    """Return what names stand for, where they are changed, and how often they are read."""
    bound: Counter[str] = Counter()
    constants: dict[str, Node] = {}
    changes: dict[str, Node] = {}
    uses: Counter[str] = Counter()

    def name_of(node: Node | None) -> str:
        is_name = node is not None and node.type == "identifier"
        return text[node.start_byte : node.end_byte].decode() if node and is_name else ""

    for node in nodes:
        if node.type == "assignment":
            left, value = node.child_by_field_name("left"), node.child_by_field_name("right")
            if name_of(left) and value is not None:
                bound[name_of(left)] += 1
                if _surely_runs(node):
                    constants[name_of(left)] = value
            elif left is not None and left.type == "subscript":
                changes.setdefault(name_of(left.child_by_field_name("value")), node)
            elif left is not None:
                bound.update(name_of(each) for each in descendants(left))
        elif node.type == "augmented_assignment":
            changes.setdefault(name_of(node.child_by_field_name("left")), node)
        elif node.type in _BINDING:
            target = node.child_by_field_name(_BINDING[node.type])
            if target is not None:
                bound.update(name_of(each) for each in descendants(target))
        elif node.type in ("parameters", "import_statement", "import_from_statement"):
            bound.update(name_of(each) for each in descendants(node))
        elif node.type in ("function_definition", "class_definition"):
            bound[name_of(node.child_by_field_name("name"))] += 1
        elif node.type == "call":
            function = node.child_by_field_name("function")
            if function is not None and function.type == "attribute":
                method = name_of(function.child_by_field_name("attribute"))
                if method in _CHANGING:
                    changes.setdefault(name_of(function.child_by_field_name("object")), node)
        elif node.type == "delete_statement":
            changes.update((name_of(each), node) for each in descendants(node) if name_of(each))
        elif node.type == "identifier":
            uses[name_of(node)] += 1
    changes.pop("", None)
    sure = {name: node for name, node in constants.items() if bound[name] == 1}
    return sure, changes, uses


def _surely_runs(node: Node) -> bool:
    """Whether a statement runs once: not in a loop, nor in a branch but that of the main guard."""
    parent = node.parent
    while parent is not None:
        if parent.type in _UNSURE or parent.type in ("else_clause", "elif_clause"):
            return False
        if parent.type == "if_statement":
            condition = parent.child_by_field_name("condition")
            if condition is None or b"__name__" not in (condition.text or b""):
                return False
        parent = parent.parent
    return True
