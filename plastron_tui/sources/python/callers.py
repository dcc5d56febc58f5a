"""What the calls in a file give for the parameters of its functions."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

from tree_sitter import Node

from .arguments import Arguments
from .calls import Argument
from .constants import MOST_DEEP, Folded
from .scopes import Binding, Scope, ScopeTree
from .syntax import Syntax

_WORD = re.compile(rb"(?<!super\()\b[A-Za-z_]\w*")

Fold = Callable[[Node | None, Scope, int], Folded]


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
                callee = call.child_by_field_name("function")
                if callee is not None and callee.type == "attribute":
                    callee = callee.child_by_field_name("attribute")
                if callee is not None and callee.type == "identifier":
                    self._by_name.setdefault(self._syntax.slice(callee), []).append(call)
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
            given = arguments.get(self._argument(binding, name))
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
            given = Arguments.of(call, self.syntax).get(self._argument(binding, name))
            value = self._folded(given, call) if given is not None else None
            if value is None:
                return None
            values.add(value)
        return values.pop() if len(values) == 1 else None

    def _argument(self, binding: Binding, name: str) -> Argument:
        is_counted = binding.index >= 0
        return Argument(binding.index - bool(self.function.self_name) if is_counted else -1, name)

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


def count_words(text: bytes) -> Counter[bytes]:
    """Count the words of a text, comments and strings included; `super(Name` says nothing of it."""
    return Counter(_WORD.findall(text))
