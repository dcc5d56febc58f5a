"""Values of expressions in launch files in Python, as far as literals and plain names go."""

from __future__ import annotations

import ast
from collections.abc import Callable
from itertools import chain
from typing import Any

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.ros.launch import Group, Item
from plastron_tui.ros.launch_text import Kind, Substitution, Text, text

from .python_actions import ACTIONS, SEQUENCES, Computed, Written, as_text, placed
from .python_deferred import LATER, maybe
from .python_functions import Function
from .python_nodes import arguments_of, callee, field, positional_of, short, source_of

_DEEPEST = 60
_MOST_TURNS = 1000
"""How many turns all loops and comprehensions of a file have that are followed."""

_KNOWN = ACTIONS | LATER
_PERFORMING = frozenset(("perform", "perform_substitution"))
_PLAIN = (bool, int, str, type(None))
_LONGEST_LITERAL = 20_000
MOST_WORK = 1_000_000
"""How many values are copied at most where lists are changed again and again."""

HEAVIEST = 50_000
"""How many values and characters a value has at most: one that is doubled again and again is none
that a person wrote."""


class Performed(Text):
    """What a substitution comes to when the file runs: a text of Python."""


class Values:
    """Reads expressions.

    Attributes:
        names: the values of plain names. A list in it is replaced, never changed.
        run: returns what a function of the file returns for arguments.
        work: how many values were copied where lists and names are changed.
    """

    def __init__(self, run: Callable[[Function, list[Any], dict[str, Any]], Any]) -> None:
        self.names: dict[str, Any] = {}
        self.run = run
        self.work = 0
        self._depth = 0
        self._turns = 0

    def turns(self, left: Node | None, right: Node | None) -> list[dict[str, Any]] | None:
        """Return the names of each turn of a `for`, None where they are not known.

        Args:
            left: what stands for an element: a name, or some.
            right: what it goes over.
        """
        if left is None or right is None:
            return None
        parts = [left] if left.type == "identifier" else left.named_children
        elements = self._elements(right)
        self._turns += 0 if elements is None else len(elements)
        if elements is None or any(each.type != "identifier" for each in parts):
            return None
        found = []
        for element in elements if self._turns <= _MOST_TURNS else ():
            values = [element] if left.type == "identifier" else element
            if type(values) not in SEQUENCES or len(values) != len(parts):
                return None
            found.append(dict(zip(map(source_of, parts), values, strict=True)))
        return found if self._turns <= _MOST_TURNS else None

    def _elements(self, node: Node) -> list[Any] | None:
        """Return what a loop goes over, None where that is not known."""
        if node.type == "call" and callee(node) == "range" and "range" not in self.names:
            bounds = [self.value(each) for each in arguments_of(node)]
            if all(type(each) is int for each in bounds) and 0 < len(bounds) < 3:
                numbers = range(*bounds)
                return list(numbers) if len(numbers) <= _MOST_TURNS else None
            return None
        found = self.value(node)
        return list(found) if type(found) in SEQUENCES else None

    def value(self, node: Node) -> Any:
        """Return what an expression comes to, `Computed` where that is not known."""
        self._depth += 1
        try:
            if self._depth > _DEEPEST:
                return Computed("what is nested too deep")
            reader = _VALUES.get(node.type)
            found = Computed(short(node)) if reader is None else reader(self, node)
            return Computed("a huge value") if weight_of(found) > HEAVIEST else found
        finally:
            self._depth -= 1

    def _literal(self, node: Node) -> Any:
        source = node.text or b""
        if len(source) > _LONGEST_LITERAL:
            return Computed("a long literal")
        try:
            return ast.literal_eval(source.decode("utf-8", "replace"))
        except (ValueError, SyntaxError, MemoryError, RecursionError):
            return Computed(short(node))

    def _string(self, node: Node) -> Any:
        if any(child.type == "interpolation" for child in node.named_children):
            return self._formatted(node)
        if source_of(node)[:1] in "fF":
            return Computed(short(node))
        return self._literal(node)

    def _formatted(self, node: Node) -> Any:
        """Return what an f-string of plain texts and whole numbers comes to."""
        source = source_of(node)
        if not source.lower().startswith("f") or any(each in source for each in ("\\", "{{", "}}")):
            return Computed(short(node))
        parts: list[str | Text] = []
        for child in node.named_children:
            if child.type == "string_content":
                parts.append(source_of(child))
            elif child.type == "interpolation":
                inner = child.named_children
                value = self.value(inner[0]) if len(inner) == 1 else None
                if type(value) is int:
                    parts.append(str(value))
                elif isinstance(value, (str, Performed)):
                    parts.append(value)
                else:
                    return Computed(short(node))
        return text(*parts)

    def _comprehension(self, node: Node) -> Any:
        """Return the list of a comprehension over one sequence that leaves nothing out."""
        body, *clauses = (each for each in node.named_children if each.type != "comment")
        if len(clauses) != 1 or clauses[0].type != "for_in_clause":
            return Computed(short(node))
        over = clauses[0]
        left, right = over.child_by_field_name("left"), over.child_by_field_name("right")
        turns = self.turns(left, right)
        if turns is None:
            return Computed(short(node))
        names = self.names
        try:
            found = []
            for turn in turns:
                self.names = {**names, **turn}
                found.append(self.value(body))
            return found
        finally:
            self.names = names

    def _concatenated(self, node: Node) -> Any:
        parts = [self.value(child) for child in node.named_children if child.type == "string"]
        if all(isinstance(part, str) for part in parts):
            return "".join(parts)
        return Computed(short(node))

    def _identifier(self, node: Node) -> Any:
        return self.names.get(source_of(node), Computed(short(node)))

    def _list(self, node: Node) -> Any:
        found: list[Any] = []
        for child in node.named_children:
            if child.type == "list_splat" and child.named_children:
                inner = self.value(child.named_children[0])
                found += inner if type(inner) in SEQUENCES else (Computed(short(child)),)
            elif child.type != "comment":
                found.append(self.value(child))
        return found

    def _tuple(self, node: Node) -> Any:
        found = Written(self._list(node))
        found.place = placed(node)
        return found

    def _dictionary(self, node: Node) -> Any:
        found = {}
        for pair in node.named_children:
            if pair.type == "comment":
                continue
            key, value = pair.child_by_field_name("key"), pair.child_by_field_name("value")
            if pair.type != "pair" or key is None or value is None:
                return Computed(short(node))
            word = self.value(key)
            name = _written(key, word) or as_text(word)
            if name is None:
                return Computed(short(node))
            found[name] = self.value(value)
        return found

    def _binary(self, node: Node) -> Any:
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if left is None or right is None or field(node, "operator") != "+":
            return Computed(short(node))
        values = self.value(left), self.value(right)
        if isinstance(values[0], list) and isinstance(values[1], list):
            return values[0] + values[1]
        if any(isinstance(each, list) for each in values):
            pairs = zip(values, (left, right), strict=True)
            lists = (x if type(x) in SEQUENCES else [Computed(short(side))] for x, side in pairs)
            return [*chain.from_iterable(lists)]
        parts = [each if isinstance(each, (str, Text)) else None for each in values]
        known = [part for part in parts if part is not None]
        return text(*known) if len(known) == len(parts) else Computed(short(node))

    def _parenthesized(self, node: Node) -> Any:
        inner = [child for child in node.named_children if child.type != "comment"]
        return self.value(inner[0]) if len(inner) == 1 else Computed(short(node))

    def _call(self, node: Node) -> Any:
        name = callee(node)
        function = node.child_by_field_name("function")
        if name == "items" and function is not None:
            of = function.child_by_field_name("object")
            found = self.value(of) if of is not None else None
            return list(found.items()) if isinstance(found, dict) else Computed(short(node))
        if name == "float" and len(positional_of(node)) == 1:
            word = self.value(positional_of(node)[0])
            return float(word) if word in ("inf", "-inf", "nan") else Computed(short(node))
        if name == "join" and function is not None and not _is_of_paths(function):
            return self._joined(node, function)
        if name in ("str", "dict", "float", "int"):
            values = [self.value(each) for each in positional_of(node)]
            is_one = len(values) == 1 and name == "str" and isinstance(values[0], (str, Text))
            return values[0] if is_one else Computed(short(node))
        if name in _PERFORMING and len(positional_of(node)) == 1:
            return self._performed(node)
        of = self.names.get(name)
        action = _KNOWN.get(name)
        is_own = isinstance(of, Function) and function is not None and function.type == "identifier"
        if not is_own and (action is None or name in self.names):
            return Computed(name or short(node))
        positional: list[Any] = []
        named: dict[str, Any] = {}
        for argument in arguments_of(node):
            if argument.type == "keyword_argument":
                value = argument.child_by_field_name("value")
                word = field(argument, "name")
                found = value and self.value(value)
                placed_text = _written(value, found) if word in _PLACED else None
                named[word] = found if placed_text is None else placed_text
            elif argument.type in ("list_splat", "dictionary_splat"):
                return Computed(name)
            else:
                positional.append(self.value(argument))
        if is_own and isinstance(of, Function):
            return self.run(of, positional, named)
        found = None if action is None else action(positional, named, placed(node))
        return Computed(name) if found is None else found

    def _performed(self, node: Node) -> Any:
        """Return what `x.perform(context)` and `context.perform_substitution(x)` come to."""
        function = node.child_by_field_name("function")
        of = None if function is None else function.child_by_field_name("object")
        is_own = callee(node) == "perform"
        value = None if of is None else self.value(of if is_own else positional_of(node)[0])
        return Performed(value.parts) if isinstance(value, Text) else Computed(short(node))

    def _function(self, node: Node) -> Function:
        return Function(node, self.names)

    def _subscript(self, node: Node) -> Any:
        of, words = node.child_by_field_name("value"), node.children_by_field_name("subscript")
        key = self.value(words[0]) if len(words) == 1 else None
        if of is None:
            return Computed(short(node))
        if is_of_context(of) and isinstance(key, str):
            return Performed((Substitution(Kind.ARGUMENT, text(key)),))
        found = self.value(of)
        if isinstance(found, dict) and isinstance(key, str):
            return found.get(text(key), Computed(short(node)))
        is_inside = type(key) is int and type(found) in SEQUENCES and 0 <= key < len(found)
        return found[key] if is_inside else Computed(short(node))

    def truth(self, node: Node | None) -> bool | None:
        """Tell whether a condition holds, None where that is not known."""
        found = Computed("") if node is None else self.value(node)
        return bool(found) if type(found) in _PLAIN else None

    def _comparison(self, node: Node) -> Any:
        sides = [self.value(each) for each in node.named_children]
        if len(sides) != 2:
            return Computed(short(node))
        first, second = (source_of(each) for each in node.named_children)
        word = source_of(node)[len(first) :].removesuffix(second).strip()
        if all(type(each) in _PLAIN for each in sides) and word in ("==", "!="):
            return (sides[0] == sides[1]) is (word == "==")
        # A group stands for what one branch names, and others do not.
        is_sure = not isinstance(sides[0], (Computed, Group))
        if second == "None" and word in ("is", "is not") and is_sure:
            return (sides[0] is None) is (word == "is")
        return Computed(short(node))

    def _negated(self, node: Node) -> Any:
        found = self.truth(node.child_by_field_name("argument"))
        return Computed(short(node)) if found is None else not found

    def _conditional(self, node: Node) -> Any:
        """Return what `one if condition else other` comes to; lists of both are doubtful."""
        inner = [child for child in node.named_children if child.type != "comment"]
        if len(inner) != 3:
            return Computed(short(node))
        one, condition, other = inner
        truth = self.truth(condition)
        if truth is not None:
            return self.value(one if truth else other)
        found = [self.value(each) for each in (one, other)]
        if all(isinstance(each, list) and all(isinstance(x, Item) for x in each) for each in found):
            place = placed(node)
            return [maybe(each, short(condition), place) for each in found if each]
        return Computed(short(node))

    def _joined(self, node: Node, function: Node) -> Any:
        """Return what the `join` of a text comes to."""
        of = function.child_by_field_name("object")
        between = None if of is None else as_text(self.value(of))
        values = [self.value(each) for each in arguments_of(node)]
        parts = values[0] if len(values) == 1 and type(values[0]) in SEQUENCES else None
        known = [] if parts is None else [each for each in map(as_text, parts) if each is not None]
        if between is None or parts is None or len(known) < len(parts):
            return Computed(short(node))
        return text(
            *(x for i, each in enumerate(known) for x in ((between, each) if i else (each,)))
        )


_VALUES: dict[str, Callable[[Values, Node], Any]] = {
    "string": Values._string,
    "concatenated_string": Values._concatenated,
    "integer": Values._literal,
    "float": Values._literal,
    "unary_operator": Values._literal,
    "true": lambda reader, node: True,
    "false": lambda reader, node: False,
    "none": lambda reader, node: None,
    "identifier": Values._identifier,
    "list": Values._list,
    "list_comprehension": Values._comprehension,
    "tuple": Values._tuple,
    "dictionary": Values._dictionary,
    "binary_operator": Values._binary,
    "parenthesized_expression": Values._parenthesized,
    "call": Values._call,
    "attribute": lambda reader, node: Computed(short(node)),
    "subscript": Values._subscript,
    "lambda": Values._function,
    "comparison_operator": Values._comparison,
    "not_operator": Values._negated,
    "conditional_expression": Values._conditional,
}


_PLACED = frozenset(("package", "executable", "plugin", "node_executable", "node_plugin"))
"""The arguments of which it is told where they stand."""


def _written(node: Node | None, value: Any) -> Text | None:
    """Return a literal as a text that has its place, None for what is written otherwise."""
    if node is None or node.type != "string" or source_of(node)[1:-1] != value:
        return None
    return Text(text(value).parts, Span(node.start_byte + 1, node.end_byte - 1))


def weight_of(value: Any) -> int:
    """Return how many values and characters a value has, up to a bit more than the most."""
    weight = 0
    stack = [value]
    while stack and weight <= HEAVIEST:
        each = stack.pop()
        weight += 1
        if isinstance(each, str):
            weight += len(each)
        elif isinstance(each, Text):
            weight += sum(len(part) if isinstance(part, str) else 1 for part in each.parts)
        elif isinstance(each, (list, tuple)) and not isinstance(each, Computed):
            stack.extend(each[:HEAVIEST])
        elif isinstance(each, dict):
            stack.extend(each.values())
        elif isinstance(each, Group):
            stack.extend(each.items)
    return weight


def _is_of_paths(function: Node) -> bool:
    """Tell whether a function called `join` is that of `os.path`."""
    if function.type == "identifier":
        return True
    return field(function, "object") in ("os.path", "path", "osp", "posixpath")


def is_of_context(node: Node) -> bool:
    """Tell whether something is where a launch context keeps the values of arguments."""
    return source_of(node).endswith(".launch_configurations")
