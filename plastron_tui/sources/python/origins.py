"""Where the value of an expression comes from: what makes it, through all the names it goes by."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.work_limits import bounded

from .analysis import Analysis
from .arguments import Arguments
from .callers import given_for
from .constants import MOST_BINDINGS, MOST_DEEP, Known, without_none
from .containers import Given, Item, part_of_item
from .flow import reaching
from .runs import LOOPS
from .scopes import Binding, BindingKind, Scope
from .syntax import parts_of

# More values than these differ.
_MOST_VALUES = 8
_MOST_CALLERS = 16
_NAMED = frozenset({"identifier", "attribute"})


class Origin(NamedTuple):
    """What makes a value.

    Attributes:
        analysis: the file that has it.
        node: the expression, of any kind but a name; None for what is imported.
        scope: the scope of the expression.
        name: the qualified name of what is imported, from no file that is read, "" for others.
    """

    analysis: Analysis
    node: Node | None
    scope: Scope
    name: str = ""

    @property
    def key(self) -> tuple[int, int, str]:
        """What tells it from others."""
        return (0, 0, self.name) if self.node is None else (id(self.analysis), self.node.id, "")


Origins = dict[tuple[int, int, str], Origin]


def origins(analysis: Analysis, node: Node, scope: Scope) -> list[Origin] | None:
    """Return all that may make the value of an expression; None where the files do not say it.

    A placeholder `None` is left out where there is something else.
    """
    found = _Tracer(analysis).trace(node, scope)
    if found is None:
        return None
    listed = list(found.values())
    return [each for each in listed if each.node is None or each.node.type != "none"] or listed


class _Tracer:
    """Follows the names of one file, and from there those of others of its package."""

    def __init__(self, analysis: Analysis) -> None:
        self._a = analysis
        self.effort = analysis.resolver.effort

    @bounded(None)
    def trace(self, node: Node | None, scope: Scope, depth: int = 0) -> Origins | None:
        if node is None or depth > MOST_DEEP:
            return None
        match node.type:
            case "parenthesized_expression" if node.named_child_count == 1:
                return self.trace(node.named_children[0], scope, depth + 1)
            case "conditional_expression":
                first, *_, last = parts_of(node)
                return self._all([Given(first, scope), Given(last, scope)], depth)
            case "boolean_operator":
                sides = (node.child_by_field_name(name) for name in ("left", "right"))
                return self._all([Given(side, scope) for side in sides if side], depth)
            case "subscript":
                item = self._a.resolver.containers.subscripted(node, scope, depth)
                return None if item is None else self.trace(*item, depth + 1)
            case "identifier":
                return self._identifier(node, scope, depth)
            case "attribute":
                return self._attribute(node, scope, depth)
            case "call":
                return self._call(node, scope, depth)
        return self._only(Origin(self._a, node, scope))

    def _all(self, given: Iterable[Item | None], depth: int) -> Origins | None:
        """Return what makes any of some values, None where one is not known."""
        found: Origins = {}
        for each in given:
            more = self.trace(*each, depth + 1) if isinstance(each, Given) else None
            if more is None:
                return None
            found |= more
        return found

    @staticmethod
    def _only(origin: Origin) -> Origins:
        return {origin.key: origin}

    def _identifier(self, node: Node, scope: Scope, depth: int) -> Origins | None:
        name = self._a.syntax.slice(node)
        found = scope.lookup(name)
        if found is None:
            return self._named(self._a.resolver.qualified(node, scope, depth), scope, depth)
        if found[0].self_name == name or len(found[1]) > MOST_BINDINGS:
            return None
        return self._bound(reaching(found[1], found[0], node, scope), name, depth)

    def _attribute(self, node: Node, scope: Scope, depth: int) -> Origins | None:
        resolver, holder = self._a.resolver, node.child_by_field_name("object")
        name = self._a.syntax.slice(node.child_by_field_name("attribute") or node)
        bindings = resolver.attribute_bindings(node, scope, depth)
        if bindings:
            return self._bound(bindings, name, depth)
        names = resolver.qualified(node, scope, depth)
        if not names and name == "value" and holder is not None and holder.type in _NAMED:
            # The member of an `Enum` of the file.
            return self.trace(holder, scope, depth + 1)
        return self._named(names, scope, depth)

    def _call(self, node: Node, scope: Scope, depth: int) -> Origins | None:
        """Return what a function of the file gives; any other call makes a value itself."""
        resolver, callee = self._a.resolver, node.child_by_field_name("function")
        given = resolver.result(node, scope)
        if given is None and callee is not None and callee.type == "attribute":
            name = self._a.syntax.slice(callee.child_by_field_name("attribute") or callee)
            is_held = name == "get" and not resolver.qualified(callee, scope, depth)
            given = resolver.containers.value_of(node, scope, depth) if is_held else None
        if given is not None:
            return self.trace(*given, depth + 1)
        return self._only(Origin(self._a, node, scope))

    def _bound(self, bindings: list[Binding], name: str, depth: int) -> Origins | None:
        bindings = without_none(bindings) or bindings
        if not 0 < len(bindings) <= _MOST_VALUES:
            return None
        found: Origins = {}
        for binding in bindings:
            more = self._binding(binding, name, depth)
            if more is None:
                return None
            found |= more
        return found

    def _binding(self, binding: Binding, name: str, depth: int) -> Origins | None:
        if binding.kind is BindingKind.IMPORT:
            return self._named((binding.target,), binding.scope, depth)
        if binding.kind is BindingKind.VALUE:
            return self.trace(binding.value, binding.scope, depth + 1)
        if binding.kind in (BindingKind.CLASS, BindingKind.FUNCTION):
            return None
        item = self._a.resolver.item(binding, name)
        if isinstance(item, Given):
            return self.trace(*item, depth + 1)
        if item is None and binding.kind is BindingKind.PARAMETER:
            return self._parameter(binding, name, depth)
        if item is None and binding.node.type in LOOPS:
            return self._turns(binding, name, depth)
        return None

    def _turns(self, binding: Binding, name: str, depth: int) -> Origins | None:
        """Return what the variable of a loop is in any of its turns."""
        held, target = self._a.resolver.containers, binding.node.child_by_field_name("left")
        items = held.items(binding.node.child_by_field_name("right"), binding.scope, depth)
        if not items:
            return None
        return self._all([part_of_item(target, item, name, held) for item in items], depth)

    def _parameter(self, binding: Binding, name: str, depth: int) -> Origins | None:
        """Return what the calls of the file give for a parameter; None where there are none."""
        function, given = binding.owner, list[Item | None]()
        calls = self._a.resolver.callers_of(function) if function is not None else []
        if function is None or not 0 < len(calls) <= _MOST_CALLERS:
            return None
        default = Given(binding.value, binding.scope) if binding.value is not None else None
        for call in calls:
            value = given_for(call, function, binding, name, self._a.syntax)
            if value is not None:
                given.append(Given(value, self._a.scopes.at(call.start_byte)))
            else:
                is_open = Arguments.of(call, self._a.syntax).is_open
                given.append(None if is_open else default)
        return self._all(given, depth)

    def _named(self, names: tuple[str, ...], scope: Scope, depth: int) -> Origins | None:
        """Return what one of some imported names stands for, here or in a file of the package."""
        found: Origins = {}
        for name in names:
            bound = self._a.package.bound(name, depth) if self._a.package is not None else None
            if bound is not None:
                module, bindings = bound
                more = _Tracer(module)._bound(bindings, name.rpartition(".")[2], depth + 1)
                if more is None:
                    return None
                found |= more
                continue
            package = self._a.package
            for target in (name,) if package is None else package.targets(name, depth):
                found |= self._only(Origin(self._a, None, scope, target))
        return found or None


def constant(analysis: Analysis, node: Node | None, scope: Scope) -> int | float | bool | None:
    """Return the number, or the truth value, that an expression is; None where it is not known."""
    found = origins(analysis, node, scope) if node is not None else None
    values = {_constant(each) for each in found or ()}
    return values.pop() if len(values) == 1 else None


def integer(analysis: Analysis, node: Node | None, scope: Scope) -> int | None:
    """Return the whole number that an expression is; None where it is not known, or is none."""
    value = constant(analysis, node, scope)
    return value if isinstance(value, int) and not isinstance(value, bool) else None


def _constant(origin: Origin) -> int | float | bool | None:
    if origin.node is None:
        return None
    if origin.node.type in ("true", "false"):
        return origin.node.type == "true"
    folded = origin.analysis.resolver.fold(origin.node, origin.scope)
    value = folded.value if isinstance(folded, Known) else None
    return value if isinstance(value, int | float) else None
