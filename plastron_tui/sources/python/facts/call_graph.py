"""Which functions of a file run while another one of it runs."""

from __future__ import annotations

from collections import defaultdict

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.callers import called_function
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.unreachable import is_unreachable

from .called_back import running_scope

_MOST_REACHED = 64
"""The most functions that are looked at for one."""


class CallGraph:
    """The calls of a file, by the functions that make them; what is called later is not one."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._calls: dict[Scope, list[Node]] = defaultdict(list)
        self._called: dict[Scope, tuple[tuple[Node, Scope], ...]] = {}
        self._own = {scope.name for scope in analysis.scopes.all if scope.name}
        for call in analysis.captures.get("call", []):
            self._calls[running_scope(analysis, call)].append(call)

    def reached(self, function: Scope) -> dict[Scope, tuple[Node, ...]]:
        """Return the functions that run with a function, it among them, and the calls to each."""
        found: dict[Scope, tuple[Node, ...]] = {function: ()}
        pending = [function]
        while pending and len(found) < _MOST_REACHED:
            current = pending.pop(0)
            for call, callee in self._calls_from(current):
                if callee not in found:
                    found[callee] = (*found[current], call)
                    pending.append(callee)
        return found

    def calls(self, function: Scope) -> tuple[Node, ...]:
        """Return the calls that a function makes itself."""
        return tuple(self._calls.get(function, ()))

    def _calls_from(self, function: Scope) -> tuple[tuple[Node, Scope], ...]:
        if function not in self._called:
            found = ((call, self.callee(call)) for call in self._calls.get(function, ()))
            self._called[function] = tuple(
                (call, callee)
                for call, callee in found
                if callee is not None and not is_unreachable(call)
            )
        return self._called[function]

    def callee(self, call: Node) -> Scope | None:
        """Return the function of the file that a call runs, None where that is not sure."""
        analysis = self._analysis
        callee = call.child_by_field_name("function")
        # Nothing else has to be looked up, and most calls are of nothing of the file.
        if callee is None or analysis.syntax.called_name(call) not in self._own:
            return None
        bindings = analysis.resolver.attribute_bindings
        scope = analysis.scopes.at(call.start_byte)
        function = called_function(callee, scope, bindings, analysis.scopes, analysis.syntax)
        return function or self._constructor(callee, scope)

    def _constructor(self, callee: Node, scope: Scope) -> Scope | None:
        """Return the constructor of a class of the file that a call makes an object of."""
        analysis = self._analysis
        found = scope.lookup(analysis.syntax.slice(callee)) if callee.type == "identifier" else None
        if found is None or [each.kind for each in found[1]] != [BindingKind.CLASS]:
            return None
        owner = found[1][0].owner
        bindings = [] if owner is None else analysis.resolver.classes.attribute(owner, "__init__")
        own = [each for each in bindings if each.scope is owner]
        return own[0].owner if len(own) == 1 else None
