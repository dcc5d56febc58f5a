"""What the names of a setup.py stand for, and where the values of names are changed.

A value counts as changed wherever something may change it: by an assignment to a part of it, by a
method that is not known to only read, by a function that it is given to, or by another name that it
is given.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from tree_sitter import Node

from .branches import Way

# Functions and methods that change nothing that they are given, or called on.
_READING = frozenset(
    {"all", "any", "bool", "dict", "enumerate", "filter", "float", "format", "frozenset", "int"}
    | {"isinstance", "iter", "len", "list", "map", "max", "min", "next", "open", "print", "range"}
    | {"repr", "reversed", "set", "sorted", "str", "sum", "tuple", "zip", "Path", "Extension"}
    | {"copy", "count", "get", "index", "items", "keys", "values"}
    | {"decode", "encode", "endswith", "join", "lower", "lstrip", "partition", "replace", "rfind"}
    | {"rpartition", "rsplit", "rstrip", "split", "splitlines", "startswith", "strip", "title"}
    | {"find", "upper", "capitalize", "removeprefix", "removesuffix", "read", "readlines"}
    | {"abspath", "basename", "dirname", "exists", "expanduser", "isdir", "isfile", "listdir"}
    | {"normpath", "realpath", "relpath", "splitext", "walk", "getenv", "glob", "iglob", "rglob"}
    | {"find_packages", "find_namespace_packages", "read_text"}
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
_BRANCHES = frozenset({"if_statement", "elif_clause", "else_clause"})
# What hands a value to places that are not followed.
_LEAVING = frozenset({"return_statement", "yield", "lambda"})
_CHAINS = {"subscript": "value", "attribute": "object", "call": "function"}


class Names(NamedTuple):
    """The names of a setup.py.

    Attributes:
        constants: what a name stands for that is bound once, where that surely runs.
        changes: where the value of a name may be changed after it was made, by that name or by
            another one that it is given, or is put into.
        uses: how often each name is read.
    """

    constants: Mapping[str, Node]
    changes: Mapping[str, Node]
    uses: Mapping[str, int]


class _Place(NamedTuple):
    """What becomes of the values of the names in a part of a file.

    Attributes:
        change: what may change them, None where nothing does.
        given: the names that they are given.
        looped: the names that their items are given.
    """

    change: Node | None = None
    given: tuple[str, ...] = ()
    looped: tuple[str, ...] = ()


def read_names(text: bytes, root: Node, setup_calls: Sequence[Node], way: Way) -> Names:
    """Return the names of a file.

    Args:
        text: the file.
        root: the root of its tree.
        setup_calls: the calls that change nothing that they are given, as they end the file.
        way: the branches that run, and those that do not.
    """
    reader = _Reader(text, frozenset(each.id for each in setup_calls), way)
    for node in descendants(root, way.left_out):
        reader.bind(node)
    reader.follow(root)
    sure = {
        name: node
        for name, node in reader.constants.items()
        if reader.bound[name] == 1 and reader.is_after_its_parts(node)
    }
    for name, other in reader.looped:
        if name not in sure or not _has_only_texts(sure[name]):
            reader.given.setdefault(name, []).append(other)
    for name, node in sure.items():
        if other := reader.name_alone(node):
            reader.given.setdefault(name, []).append(other)
    return Names(sure, _spread(reader.changes, reader.given), reader.uses)


def _spread(changes: Mapping[str, Node], given: Mapping[str, Sequence[str]]) -> dict[str, Node]:
    """Return the changes with those of each name that a name is given, however far."""
    takers: dict[str, list[str]] = {}
    for name, others in given.items():
        for other in others:
            takers.setdefault(other, []).append(name)
    found = dict(changes)
    waiting = list(found)
    while waiting:
        other = waiting.pop()
        for name in takers.get(other, ()):
            if name not in found:
                found[name] = found[other]
                waiting.append(name)
    return found


class _Reader:
    def __init__(self, text: bytes, setup_calls: frozenset[int], way: Way) -> None:
        self._text, self._setup_calls, self._way = text, setup_calls, way
        self.bound: Counter[str] = Counter()
        self.uses: Counter[str] = Counter()
        self.constants: dict[str, Node] = {}
        self.changes: dict[str, Node] = {}
        self.given: dict[str, list[str]] = {}
        self.looped: list[tuple[str, str]] = []

    def bind(self, node: Node) -> None:
        """Note what a node binds, and which name it reads."""
        if node.type == "assignment":
            left, value = node.child_by_field_name("left"), node.child_by_field_name("right")
            if self._name(left) and value is not None:
                self.bound[self._name(left)] += 1
                if _surely_runs(node, self._way.taken):
                    self.constants[self._name(left)] = value
            elif left is not None and left.type not in _CHAINS:
                self.bound.update(self._names(left))
        elif node.type in _BINDING:
            target = node.child_by_field_name(_BINDING[node.type])
            if target is not None:
                self.bound.update(self._names(target))
        elif node.type in ("parameters", "import_statement", "import_from_statement"):
            self.bound.update(self._names(node))
        elif node.type in ("function_definition", "class_definition"):
            self.bound[self._name(node.child_by_field_name("name"))] += 1
        elif node.type == "identifier":
            self.uses[self._name(node)] += 1

    def is_after_its_parts(self, value: Node) -> bool:
        """Whether the names in a value are bound before it, so that none stands for itself."""
        known = (self.constants.get(each) for each in self._names(value))
        return all(each is None or each.start_byte < value.start_byte for each in known)

    def name_alone(self, value: Node) -> str:
        """Return the name that a value is nothing but, "" for other values."""
        while value.type == "parenthesized_expression" and value.named_child_count == 1:
            value = value.named_children[0]
        return self._name(value)

    def follow(self, root: Node) -> None:
        """Note where the values of names are changed, and which other names they are given."""
        stack = [(root, _Place())]
        while stack:
            node, place = stack.pop()
            if node.id in self._way.left_out:
                continue
            if node.type == "identifier":
                self._note(self._name(node), place)
            else:
                stack.extend(self._parts(node, place))

    def _note(self, name: str, place: _Place) -> None:
        if place.change is not None:
            self.changes.setdefault(name, place.change)
        if place.given:
            self.given.setdefault(name, []).extend(place.given)
        self.looped += [(name, each) for each in place.looped]

    def _parts(self, node: Node, place: _Place) -> Iterator[tuple[Node, _Place]]:
        """Yield the parts of a node, each with what becomes of the names in it."""
        match node.type:
            case "assignment" | "augmented_assignment" | "named_expression":
                yield from self._assigned(node, place)
            case "for_statement" | "for_in_clause":
                left, right = (node.child_by_field_name(each) for each in ("left", "right"))
                for each in node.children:
                    looped = tuple(self._names(left)) if left and each == right else ()
                    yield each, place._replace(looped=(*place.looped, *looped))
            case "call":
                yield from self._called(node, place)
            case "attribute" | "keyword_argument":
                for at, each in enumerate(node.children):
                    if node.field_name_for_child(at) not in ("attribute", "name"):
                        yield each, place
            case "subscript":
                for at, each in enumerate(node.children):
                    yield each, place if node.field_name_for_child(at) == "value" else _Place()
            case "delete_statement":
                yield from ((each, _Place(node)) for each in node.children)
            case _ if node.type in _LEAVING:
                yield from ((each, _Place(node)) for each in node.children)
            case "block" | "module":
                yield from ((each, _Place()) for each in node.children)
            case _:
                yield from ((each, place) for each in node.children)

    def _assigned(self, node: Node, place: _Place) -> Iterator[tuple[Node, _Place]]:
        target = "name" if node.type == "named_expression" else "left"
        left = node.child_by_field_name(target)
        if left is None:
            return
        is_change = left.type in _CHAINS or node.type == "augmented_assignment"
        names = tuple(self._names(_root(left)))
        for each in node.children:
            if each == left:
                yield each, _Place(node if is_change else None)
            else:
                yield each, place._replace(given=(*place.given, *names))

    def _called(self, node: Node, place: _Place) -> Iterator[tuple[Node, _Place]]:
        function = node.child_by_field_name("function")
        if node.id in self._setup_calls:
            yield from ((each, _Place()) for each in node.children if each != function)
            return
        name = function
        if function is not None and function.type == "attribute":
            name = function.child_by_field_name("attribute")
        is_reading = self._name(name) in _READING
        inner = place if is_reading or place.change is not None else place._replace(change=node)
        yield from ((each, inner) for each in node.children)

    def _name(self, node: Node | None) -> str:
        is_name = node is not None and node.type == "identifier"
        return self._text[node.start_byte : node.end_byte].decode() if node and is_name else ""

    def _names(self, root: Node) -> Iterator[str]:
        return (self._name(each) for each in descendants(root) if each.type == "identifier")


def _root(node: Node) -> Node:
    """Return what a chain such as `a['b'].c` begins with."""
    while node.type in _CHAINS:
        inner = node.child_by_field_name(_CHAINS[node.type])
        if inner is None:
            break
        node = inner
    return node


def _has_only_texts(node: Node) -> bool:
    """Whether a value is a list of texts, which cannot be changed by its items."""
    items = [each for each in node.named_children if each.type != "comment"]
    return node.type in ("list", "tuple") and all(each.type == "string" for each in items)


def descendants(root: Node, left_out: Collection[int] = ()) -> Iterator[Node]:
    """Return a node and all that is in it, in the order of the text, without recursion.

    Args:
        root: the node.
        left_out: the ids of nodes that are left out, with all that is in them.
    """
    stack = [root]
    while stack:
        node = stack.pop()
        if node.id not in left_out:
            yield node
            stack.extend(reversed(node.children))


def _surely_runs(node: Node, taken: Mapping[int, Node]) -> bool:
    """Whether a statement runs once: not in a loop, nor in a branch but one that is taken.

    Args:
        node: the statement.
        taken: the branches that are taken, by the ids of their blocks; each with its statement.
    """
    parent = node.parent
    while parent is not None:
        if parent.id in taken:
            parent = taken[parent.id].parent
            continue
        if parent.type in _UNSURE or parent.type in _BRANCHES:
            return False
        parent = parent.parent
    return True
