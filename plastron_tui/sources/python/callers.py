"""What the calls in a file give for the parameters of its functions."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

from tree_sitter import Node

from .arguments import Arguments
from .calls import Argument
from .constants import MOST_BINDINGS, MOST_DEEP, Folded
from .flow import reaching
from .scopes import Binding, BindingKind, Scope, ScopeTree
from .syntax import Syntax

_WORD = re.compile(rb"(?<!super\()\b[A-Za-z_]\w*")

Fold = Callable[[Node | None, Scope, int], Folded]
Bindings = Callable[[Node, Scope], list[Binding]]


class Calls:
    """The calls of a file, by the names of what they call."""

    def __init__(self, calls: list[Node], syntax: Syntax) -> None:
        self._calls = calls
        self._syntax = syntax
        self._by_name: dict[str, list[Node]] | None = None

    def of(self, name: str) -> list[Node]:
        """Return the calls whose callee ends in a name."""
        if self._by_name is None:
            self._by_name = {}
            for call in self._calls:
                if called := self._syntax.called_name(call):
                    self._by_name.setdefault(called, []).append(call)
        return self._by_name.get(name, [])


@dataclass(frozen=True, slots=True)
class Callers:
    """The calls in the file that may call a function."""

    function: Scope
    calls: list[Node]
    syntax: Syntax
    scopes: ScopeTree
    fold: Fold
    words: Counter[bytes]
    depth: int

    def keep_default(self, binding: Binding, name: str) -> bool:
        """Whether no call gives a parameter another value than its default."""
        for call in self.calls:
            arguments = Arguments.of(call, self.syntax)
            if arguments.is_open:
                return False
            given = given_for(call, self.function, binding, name, self.syntax)
            if given is None:
                continue
            value = self._folded(given, call)
            if value is None or value != self.fold(binding.value, binding.scope, self.depth):
                return False
        return True

    def value(self, binding: Binding, name: str) -> Folded:
        """Return the constant that a parameter has, whichever of the calls is made.

        Where that is not its default, nothing else may be done with the function in the file
        than to call it: what hands it on may call it with anything.
        """
        if self.keep_default(binding, name):
            return self.fold(binding.value, binding.scope, self.depth)
        if not self.calls or not self._is_only_called():
            return None
        values = set()
        for call in self.calls:
            given = given_for(call, self.function, binding, name, self.syntax)
            value = self._folded(given, call) if given is not None else None
            if value is None:
                return None
            values.add(value)
        return values.pop() if len(values) == 1 else None

    def _folded(self, given: Node, call: Node) -> Folded:
        scope = self.scopes.at(call.start_byte)
        if scope.is_within(self.function):
            return None
        return self.fold(given, scope, max(self.depth, MOST_DEEP - 4))

    def _is_only_called(self) -> bool:
        """Whether the file names the function, or its class, only where it calls it by name."""
        owner = self.function.parent
        if self.function.self_name and self.function.name != "__init__":
            return False
        named = owner if self.function.self_name and owner is not None else self.function
        callees = [call.child_by_field_name("function") for call in self.calls]
        if any(callee is None or callee.type != "identifier" for callee in callees):
            return False
        return self.words[named.name.encode()] == len(callees) + 1


def given_for(
    call: Node, function: Scope, binding: Binding, name: str, syntax: Syntax
) -> Node | None:
    """Return what a call gives for a parameter; None where it does not say it."""
    arguments = Arguments.of(call, syntax)
    if arguments.is_open:
        return None
    is_counted = binding.index >= 0
    position = binding.index - (bool(function.self_name) and not _gives_self(call))
    return arguments.get(Argument(position if is_counted else -1, name))


def _gives_self(call: Node) -> bool:
    """Whether a call is `Base.__init__(self, …)`, which gives the object as well."""
    callee = call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    method = callee.child_by_field_name("attribute") if callee is not None else None
    is_constructor = method is not None and method.text == b"__init__"
    return is_constructor and holder is not None and holder.type != "call"


def called_function(
    callee: Node, scope: Scope, bindings_of: Bindings, scopes: ScopeTree, syntax: Syntax
) -> Scope | None:
    """Return the function of the file that a call runs, None where that is not sure.

    Args:
        callee: what is called.
        scope: the scope of the call.
        bindings_of: returns what binds an attribute.
        scopes: the scopes of the file.
        syntax: the file.
    """
    if callee.type == "attribute":
        holder = callee.child_by_field_name("object")
        bindings = bindings_of(callee, scope)
        function = bindings[0].owner if len(bindings) == 1 else None
        owner = function.parent if function is not None else None
        # `Class.method(object, …)` gives the object as well.
        is_bound = owner is None or holder is None or syntax.slice(holder) != owner.name
        return function if is_bound and function and function.kind == "function" else None
    found = scope.lookup(syntax.slice(callee)) if callee.type == "identifier" else None
    if found is None or len(found[1]) > MOST_BINDINGS:
        return None
    bindings = reaching(found[1], found[0], callee, scope)
    if len(bindings) > 1:
        return None
    value = bindings[0].value
    if value is not None and value.type == "lambda":
        body = value.child_by_field_name("body")
        return scopes.at(body.start_byte) if body is not None else None
    return bindings[0].owner if bindings[0].kind is BindingKind.FUNCTION else None


def count_words(text: bytes) -> Counter[bytes]:
    """Count the words of a text, comments and strings included; `super(Name` says nothing of it."""
    return Counter(_WORD.findall(text))
