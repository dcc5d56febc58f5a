"""How the lines of a file come to run: who calls their function, and what their loop takes.

A name that a parameter or the variable of a loop decides is one for each call and each turn.
"""

from __future__ import annotations

from abc import abstractmethod
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager

from tree_sitter import Node

from plastron_tui.sources.work_limits import Effort, bounded

from .arguments import Arguments
from .callers import Callers, Calls, called_function, count_words, given_for
from .classes import Classes
from .command_line import Defaults, is_parsed, option_defaults
from .constants import MOST_BINDINGS, Folded, Known, as_default
from .containers import Containers, Given, Item, changed_names, part_of_item
from .runs import (
    EVERYWHERE,
    LOOPS,
    Frame,
    Turn,
    World,
    is_made_in,
    is_making,
    is_related,
    result_of,
)
from .scopes import Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax

MOST_PASSES = 64
"""The most passes through a line that are told apart."""

MOST_IN_ALL = 2_000
"""The most passes that are looked at for all lines of a file."""


class Passes:
    """The calls of the functions of one file, and the turns of its loops."""

    def __init__(self, syntax: Syntax, scopes: ScopeTree, calls: list[Node]) -> None:
        self._syntax = syntax
        self._scopes = scopes
        self._calls = Calls(calls, syntax)
        self._words: Counter[bytes] | None = None
        self._changed: frozenset[bytes] | None = None
        self._world = EVERYWHERE
        self._open: list[Binding] | None = None
        self.passes_left = MOST_IN_ALL
        self._defaults: Defaults | None = None
        self.classes = Classes(syntax, scopes)
        self.effort = Effort(len(syntax.text))

    @abstractmethod
    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""

    @abstractmethod
    def attribute_bindings(self, node: Node, scope: Scope, depth: int = 0) -> list[Binding]:
        """Return what binds `object.name` where the object is of a class of the file."""

    @property
    def containers(self) -> Containers:
        """The containers of the file, as they are in the pass that is looked at."""
        if self._changed is None:
            self._changed = changed_names(self._syntax.text)
        # Not kept: each would hold the other, and only the cycle collector would free them.
        return Containers(self, self._syntax, self._changed)

    @contextmanager
    def during(self, world: World) -> Iterator[None]:
        """Answer for one pass, in which nothing else is chosen."""
        before = self._world, self._open
        self._world, self._open = world, None
        try:
            yield
        finally:
            self._world, self._open = before

    @bounded([EVERYWHERE])
    def passes(self, node: Node, scope: Scope, call: Node) -> list[World]:
        """Return the passes in which an argument of a call has a value of its own.

        A single one that says nothing where there are no more, or where it is not sure that the
        call is made in each of them.
        """
        if self.passes_left <= 0:
            return [EVERYWHERE]
        found: list[World] = []
        pending = [EVERYWHERE]
        is_known = False
        while pending:
            world = pending.pop(0)
            self.passes_left -= world is not EVERYWHERE
            with self.during(world):
                self._open = []
                folded = self.fold(node, scope)
                options = self._options(self._open) if folded is None else []
            pending += [{**world, key: option} for key, option in options]
            if not options:
                found.append(world)
                is_known = is_known or folded is not None
            if len(found) + len(pending) > MOST_PASSES or self.passes_left <= 0:
                return [EVERYWHERE]
        is_made = (is_made_in(world, call, self._syntax, self.effort) for world in found)
        if not is_known or not all(is_made):
            return [EVERYWHERE]
        file = self._scopes, self.classes, self._syntax
        related = [world for world in found if is_related(world, call, *file)]
        return related or [EVERYWHERE]

    def _options(self, bindings: list[Binding]) -> list[tuple[int, Frame | Turn]]:
        """Return what the first binding that leaves a choice may come from."""
        for binding in bindings[:MOST_BINDINGS]:
            found: list[tuple[int, Frame | Turn]] = []
            function, loop = binding.owner, binding.node
            if function is not None:
                calls = self._sure_callers(function)
                found = [(function.node.id, Frame(function, call)) for call in calls]
            else:
                taken = loop.child_by_field_name("right")
                items = self.containers.items(taken, binding.scope) or ()
                found = [(loop.id, Turn(loop, binding.scope, item)) for item in items]
            if found:
                return found
        return []

    def item(self, binding: Binding, name: str) -> Item | None:
        """Return what a parameter or the variable of a loop stands for in this pass."""
        is_parameter = binding.kind is BindingKind.PARAMETER and binding.owner is not None
        if not is_parameter and binding.node.type not in LOOPS:
            return None
        key = binding.owner.node.id if binding.owner is not None else binding.node.id
        chosen = self._world.get(key)
        if chosen is None:
            if self._open is not None:
                self._open.append(binding)
            return None
        if isinstance(chosen, Turn):
            pattern = chosen.loop.child_by_field_name("left")
            return part_of_item(pattern, chosen.item, name, self.containers)
        given = given_for(chosen.call, chosen.function, binding, name, self._syntax)
        if given is not None:
            return Given(given, self._scopes.at(given.start_byte))
        is_default = not Arguments.of(chosen.call, self._syntax).is_open
        return Given(binding.value, binding.scope) if is_default and binding.value else None

    def fold_item(self, binding: Binding, name: str, depth: int) -> Folded:
        """Return the constant that a parameter or the variable of a loop is in this pass."""
        item = self.item(binding, name)
        if not isinstance(item, Given):
            return item if isinstance(item, Known) else None
        frame = self._world.get(binding.owner.node.id) if binding.owner is not None else None
        before = self._world
        if isinstance(frame, Frame) and frame.world is not None:
            self._world = frame.world
        try:
            return self.fold(item.node, item.scope, depth)
        finally:
            self._world = before

    def fold_held(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Return the constant that `TOPICS['scan']` or `TOPICS.get('scan')` is."""
        held = self.containers
        is_call = node.type == "call"
        item = (held.value_of if is_call else held.subscripted)(node, scope, depth)
        return self.fold(item.node, item.scope, depth) if item is not None else None

    def option(self, node: Node, scope: Scope, depth: int) -> Folded:
        """Return the default of `args.topic`, an option of the command line."""
        if self._defaults is None:
            self._defaults = option_defaults(self, self._scopes, self._syntax)
        name = node.child_by_field_name("attribute")
        found = self._defaults.get(self._syntax.slice(name), ()) if name is not None else ()
        if not 0 < len(found) <= 8 or not is_parsed(node, scope, self, self._syntax, depth):
            return None
        values = {self.fold(*each, depth) for each in found}
        return as_default(values.pop()) if len(values) == 1 else None

    def result(self, call: Node, scope: Scope) -> Given | None:
        """Return the expression that a call of a function of the file gives."""
        callee = call.child_by_field_name("function")
        if callee is None:
            return None
        function = self._called(callee, scope)
        value = result_of(function) if function is not None else None
        return Given(value, function) if value is not None and function is not None else None

    def returned(self, call: Node, scope: Scope, depth: int) -> Folded:
        """Return the constant that a call of a function of the file gives."""
        given = self.result(call, scope)
        if given is None or given.scope.node.id in self._world:
            return None
        before = self._world
        self._world = {**before, given.scope.node.id: Frame(given.scope, call, before)}
        try:
            return self.fold(given.node, given.scope, depth)
        finally:
            self._world = before

    def _sure_callers(self, function: Scope) -> list[Node]:
        """Return the calls of the file that call a function for sure, and not from within."""
        calls = self.callers_of(function)
        known = [(call, self._scopes.at(call.start_byte)) for call in calls[: MOST_BINDINGS + 1]]
        outside = [each for each in known if not each[1].is_within(function)]
        is_known = len(calls) <= MOST_BINDINGS
        return [each for each, at in outside if is_known and self._is_call_of(each, at, function)]

    def _is_call_of(self, call: Node, scope: Scope, function: Scope) -> bool:
        callee = call.child_by_field_name("function")
        if function.name == "__init__" and function.self_name:
            return is_making(call, scope, function, self.classes, self._syntax)
        return callee is not None and self._called(callee, scope) is function

    def _called(self, callee: Node, scope: Scope) -> Scope | None:
        return called_function(callee, scope, self.attribute_bindings, self._scopes, self._syntax)

    def calls_of(self, name: str) -> list[Node]:
        """Return the calls whose callee ends in a name."""
        return self._calls.of(name)

    def callers_of(self, function: Scope) -> list[Node]:
        """Return the calls in the file that may call a function."""
        owner = function.parent
        if function.name != "__init__" or owner is None:
            return self.calls_of(function.name)
        callers = list(self.calls_of(owner.name))
        for other in self.classes.derived(owner):
            callers += self.calls_of(other.name)
        for call in self.calls_of("__init__"):
            inside = self._scopes.at(call.start_byte).enclosing("class")
            if inside is not owner and inside is not None and owner in self.classes.bases(inside):
                callers.append(call)
        return callers

    def keeps_default(self, binding: Binding, name: str, depth: int = 0) -> bool:
        """Whether no caller in the file gives a parameter another value than its default."""
        callers = self._callers(binding, depth)
        return callers is not None and callers.keep_default(binding, name)

    def parameter(self, binding: Binding, name: str, depth: int) -> Folded:
        """Return the constant that a parameter has wherever the file calls the function."""
        if binding.owner is not None and binding.owner.node.id in self._world:
            return self.fold_item(binding, name, depth)
        callers = self._callers(binding, depth)
        with self.during(EVERYWHERE):
            folded = callers.value(binding, name) if callers is not None else None
        return folded if folded is not None else self.fold_item(binding, name, depth)

    def given(self, binding: Binding, name: str) -> list[tuple[Node | None, Scope]]:
        """Return what the callers in the file give for a parameter."""
        function = binding.owner
        if function is None or function.kind != "function":
            return []
        found: list[tuple[Node | None, Scope]] = []
        for call in self.callers_of(function)[:16]:
            value = given_for(call, function, binding, name, self._syntax)
            found.append((value, self._scopes.at(call.start_byte)))
        return found

    def _callers(self, binding: Binding, depth: int = 0) -> Callers | None:
        function = binding.owner
        if function is None:
            return None
        if self._words is None:
            self._words = count_words(self._syntax.text)
        calls = self.callers_of(function)
        if len(calls) > MOST_BINDINGS:
            return None
        known = (self._syntax, self._scopes, self.fold, self._words)
        return Callers(function, calls, *known, depth)
