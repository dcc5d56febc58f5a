"""What the lists and dictionaries hold that a file writes out and never changes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from itertools import islice
from typing import NamedTuple, Protocol

from tree_sitter import Node

from .arguments import Arguments
from .calls import Argument
from .constants import MOST_BINDINGS, MOST_DEEP, Folded, Known, without_none
from .flow import reaching
from .scopes import Binding, BindingKind, Scope
from .syntax import Syntax, parts_of

MOST_ITEMS = 64
"""The most items of a list that are looked at; what people loop over for endpoints has ten."""

_LARGEST = 200
"""The most items of a container that anything is looked up in."""

_LISTS = frozenset({"list", "tuple", "set", "expression_list"})
_COPIES = frozenset({"list", "tuple", "set", "sorted", "reversed"})
_CHANGED = re.compile(
    rb"\b(\w+)\s{0,3}"
    rb"(?:\.\s{0,3}(?:append|extend|insert|update|setdefault|add|pop|popitem|remove|discard|clear)"
    rb"\s{0,3}\("
    rb"|(?:\[[^\]\n]{0,100}\]){1,4}\s{0,3}(?:[-+*/%&|^]|//|\*\*)?=(?!=))"
    rb"|\bdel\s{1,3}(?:\w{1,80}\.){0,4}(\w+)\s{0,3}\["
)


class Given(NamedTuple):
    """An expression that something stands for, and the scope that it is of."""

    node: Node
    scope: Scope


Item = Given | Known | tuple["Item", ...]
"""What a loop takes: an expression, a number that is counted, or several of both."""


class Values(Protocol):
    """What containers ask of names."""

    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""

    def item(self, binding: Binding, name: str) -> Item | None:
        """Return what a parameter or the variable of a loop stands for just now."""

    def attribute_bindings(self, node: Node, scope: Scope, depth: int = 0) -> list[Binding]:
        """Return what an attribute of an object of the file is bound to."""

    def result(self, call: Node, scope: Scope) -> Given | None:
        """Return the expression that a call of a function of the file gives."""


def changed_names(text: bytes) -> frozenset[bytes]:
    """Return the names of what a file changes the items of; attributes by their last name."""
    return frozenset(first or second for first, second in _CHANGED.findall(text))


class Containers:
    """Looks into the containers of one file."""

    def __init__(self, values: Values, syntax: Syntax, changed: frozenset[bytes]) -> None:
        self._values = values
        self._syntax = syntax
        self._changed = changed

    def literal(self, node: Node | None, scope: Scope, depth: int = 0) -> Given | None:
        """Return the expression that an expression stands for: a literal container, if it is one.

        None where the file does not say it, or changes it.
        """
        if node is None or depth > MOST_DEEP:
            return None
        if node.type == "parenthesized_expression" and node.named_child_count == 1:
            return self.literal(node.named_children[0], scope, depth + 1)
        if node.type == "identifier":
            name = self._syntax.slice(node)
            found = scope.lookup(name)
            if found is None or len(found[1]) > MOST_BINDINGS or self._is_changed(name):
                return None
            return self._bound(reaching(found[1], found[0], node, scope), name, depth)
        if node.type == "attribute":
            name = self._syntax.slice(node.child_by_field_name("attribute") or node)
            bindings = self._values.attribute_bindings(node, scope, depth)
            return None if self._is_changed(name) else self._bound(bindings, name, depth)
        if node.type == "subscript":
            item = self.subscripted(node, scope, depth)
            return self.literal(item.node, item.scope, depth + 1) if item else Given(node, scope)
        given = self._values.result(node, scope) if node.type == "call" else None
        if given is not None and not has_parameters(given.scope):
            return self.literal(given.node, given.scope, depth + 1)
        return Given(node, scope) if node.named_child_count <= _LARGEST else None

    def subscripted(self, node: Node, scope: Scope, depth: int = 0) -> Given | None:
        """Return what `TOPICS['scan']` or `TOPICS[0]` stands for."""
        keys = node.children_by_field_name("subscript")
        held = self.literal(node.child_by_field_name("value"), scope, depth + 1)
        if held is None or len(keys) != 1:
            return None
        key = self._values.fold(keys[0], scope, depth + 1)
        return self.at(held, key.value, depth) if isinstance(key, Known) else None

    def at(self, held: Given, key: object, depth: int) -> Given | None:
        """Return the item of a container that has a key, or an index; None for no such item."""
        if held.node.type in _LISTS:
            parts = parts_of(held.node)
            is_index = isinstance(key, int) and -len(parts) <= key < len(parts)
            if not is_index or held.node.type == "set" or _has_splat(parts):
                return None
            return Given(parts[int(str(key))], held.scope)
        pairs = self._pairs(held, depth)
        found = [value for name, value in pairs or () if name == Known(key)]  # type: ignore[arg-type]
        return found[-1] if found else None

    def items(self, node: Node | None, scope: Scope, depth: int = 0) -> list[Item] | None:
        """Return what a loop over an expression takes, one after the other."""
        held = self.literal(node, scope, depth)
        if held is None:
            return None
        found: list[Item] | None = None
        if held.node.type in _LISTS:
            parts = parts_of(held.node)
            is_plain = not _has_splat(parts) and "comprehension" not in held.node.type
            found = [Given(part, held.scope) for part in parts] if is_plain else None
        elif held.node.type == "dictionary":
            pairs = self._pairs(held, depth)
            found = [name for name, _ in pairs] if pairs is not None else None
        elif held.node.type == "call":
            found = self._called(held, depth)
        elif held.node.type == "string":
            text = self._values.fold(held.node, held.scope, depth + 1)
            found = [Known(each) for each in str(text.value)] if isinstance(text, Known) else None
        return found if found is not None and len(found) <= MOST_ITEMS else None

    def _called(self, held: Given, depth: int) -> list[Item] | None:
        """Return what a loop over `enumerate(…)`, `zip(…)`, `range(…)`, `x.items()` takes."""
        callee = held.node.child_by_field_name("function")
        arguments = Arguments.of(held.node, self._syntax)
        if callee is None or arguments.is_open or depth > MOST_DEEP:
            return None
        if callee.type == "attribute":
            return self._view(callee, arguments, held.scope, depth)
        name = self._syntax.slice(callee)
        if held.scope.lookup(name) is not None:
            return None
        if name == "range":
            return self._range(arguments, held.scope, depth)
        each = [self.items(part, held.scope, depth + 1) for part in arguments.positional]
        known = [items for items in each if items is not None]
        if not known or len(known) != len(each):
            return None
        if name in _COPIES and len(known) == 1:
            return known[0]
        if name == "enumerate" and len(each) == 1 and not arguments.keywords:
            return [(Known(index), item) for index, item in enumerate(known[0])]
        if name == "zip" and not arguments.keywords:
            return list(zip(*known, strict=False))
        return None

    def _range(self, arguments: Arguments, scope: Scope, depth: int) -> list[Item] | None:
        bounds: list[int] = []
        for part in arguments.positional:
            folded = self._values.fold(part, scope, depth + 1)
            if not isinstance(folded, Known) or not isinstance(folded.value, int):
                return None
            bounds.append(folded.value)
        if not 1 <= len(bounds) <= 3 or bounds[2:] == [0]:
            return None
        return [Known(number) for number in islice(range(*bounds), MOST_ITEMS + 1)]

    def _view(
        self, callee: Node, arguments: Arguments, scope: Scope, depth: int
    ) -> list[Item] | None:
        method = callee.child_by_field_name("attribute")
        held = self.literal(callee.child_by_field_name("object"), scope, depth + 1)
        if method is None or held is None or arguments.positional or arguments.keywords:
            return None
        pairs = self._pairs(held, depth)
        views: dict[str, Callable[[Known, Given], Item]] = {
            "items": lambda name, value: (name, value),
            "iteritems": lambda name, value: (name, value),
            "keys": lambda name, value: name,
            "values": lambda name, value: value,
            "itervalues": lambda name, value: value,
        }
        view = views.get(self._syntax.slice(method))
        if pairs is None or view is None:
            return None
        return [view(name, value) for name, value in pairs]

    def _pairs(self, held: Given, depth: int) -> list[tuple[Known, Given]] | None:
        """Return the keys and values of a dictionary; None where they are not all known."""
        found: list[tuple[Known, Given]] = []
        if held.node.type == "call":
            callee = held.node.child_by_field_name("function")
            arguments = Arguments.of(held.node, self._syntax)
            is_dict = callee is not None and self._syntax.slice(callee) == "dict"
            if not is_dict or arguments.positional or arguments.is_open:
                return None
            return [(Known(name), Given(v, held.scope)) for name, v in arguments.keywords.items()]
        if held.node.type != "dictionary":
            return None
        for pair in parts_of(held.node):
            key = self._values.fold(pair.child_by_field_name("key"), held.scope, depth + 1)
            value = pair.child_by_field_name("value")
            if not isinstance(key, Known) or value is None:
                return None
            found.append((key, Given(value, held.scope)))
        return found

    def value_of(self, call: Node, scope: Scope, depth: int) -> Given | None:
        """Return what `TOPICS.get('scan', default)` stands for, where it is no method of another.

        None where the file does not say it; a default alone never is an answer.
        """
        callee = call.child_by_field_name("function")
        held = self.literal(callee.child_by_field_name("object"), scope, depth) if callee else None
        arguments = Arguments.of(call, self._syntax)
        key = self._values.fold(arguments.get(Argument(0, "")), scope, depth + 1)
        if (
            held is None
            or not isinstance(key, Known)
            or (pairs := self._pairs(held, depth)) is None
        ):
            return None
        found = [value for name, value in pairs if name == key]
        default = arguments.get(Argument(1, ""))
        return found[-1] if found else Given(default, scope) if default is not None else None

    def _bound(self, bindings: list[Binding], name: str, depth: int) -> Given | None:
        bindings = without_none(bindings)
        if len(bindings) != 1:
            return None
        binding = bindings[0]
        if _is_first_of_call(binding, name):
            # `args, rest = parser.parse_known_args()`
            return Given(binding.node.child_by_field_name("right") or binding.node, binding.scope)
        if binding.kind is BindingKind.VALUE and binding.value is not None:
            return self.literal(binding.value, binding.scope, depth + 1)
        item = self._values.item(binding, name)
        return self.literal(item.node, item.scope, depth + 1) if isinstance(item, Given) else None

    def _is_changed(self, name: str) -> bool:
        return name.encode() in self._changed


def part_of_item(pattern: Node | None, item: Item, name: str, within: Containers) -> Item | None:
    """Return what of an item the name in a target gets: `(a, b)` takes two of it."""
    if pattern is None:
        return None
    if pattern.type == "identifier":
        return item if (pattern.text or b"").decode("utf-8", "replace") == name else None
    targets = parts_of(pattern)
    if isinstance(item, Given):
        held = within.literal(item.node, item.scope)
        parts = parts_of(held.node) if held is not None and held.node.type in _LISTS else []
        if held is None or _has_splat(parts):
            return None
        within_item: tuple[Item, ...] = tuple(Given(part, held.scope) for part in parts)
        item = within_item
    if isinstance(item, Known) or len(item) != len(targets) or _has_splat(targets):
        return None
    pairs: Iterable[tuple[Node, Item]] = zip(targets, item, strict=True)
    found = (part_of_item(target, part, name, within) for target, part in pairs)
    return next((part for part in found if part is not None), None)


def has_parameters(function: Scope) -> bool:
    """Whether a function takes anything but the object that it is a method of."""
    bindings = (each for bound in function.bindings.values() for each in bound)
    parameters = [each for each in bindings if each.kind is BindingKind.PARAMETER]
    return len(parameters) > bool(function.self_name)


def _is_first_of_call(binding: Binding, name: str) -> bool:
    """Whether a name gets the first of several values that a call gives."""
    if binding.node.type != "assignment" or binding.value is not None:
        return False
    value, target = (binding.node.child_by_field_name(each) for each in ("right", "left"))
    parts = parts_of(target)
    first = (parts[0].text or b"") if parts else b""
    is_call = value is not None and value.type == "call"
    return is_call and first.decode("utf-8", "replace").rpartition(".")[2] == name


def _has_splat(parts: list[Node]) -> bool:
    return any("splat" in part.type for part in parts)
