"""When the functions of a file run: once, as the node starts, or whenever something calls them."""

from __future__ import annotations

import re
from collections import defaultdict
from enum import IntEnum

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .references import statement_of
from .scopes import Scope
from .syntax import is_main_guard, parts_of

# Functions that run as a node starts, whoever calls them.
_STARTING = frozenset({"__init__", "main", "on_configure", "setUp"})
# Functions that run as a node starts if another file calls them.
_SETTING_UP = re.compile(r"_*(on_?)?(init|set_?up|configure|ros_|main|run$)", re.IGNORECASE)
_REPEATED = frozenset(
    {
        "for_statement",
        "list_comprehension",
        "set_comprehension",
        "dictionary_comprehension",
        "generator_expression",
    }
)
# What runs never, or more than once, or later than what is around it.
_CONDITIONS = frozenset(
    {
        "if_statement",
        "for_statement",
        "while_statement",
        "except_clause",
        "conditional_expression",
        "boolean_operator",
        "match_statement",
        "lambda",
        "list_comprehension",
        "set_comprehension",
        "dictionary_comprehension",
        "generator_expression",
    }
)


class When(IntEnum):
    """When a call site runs, the best time for another one beside it first."""

    START = 0
    SETTING_UP = 1
    ELSEWHERE = 2
    LATER = 3
    ON_DEMAND = 4


class Starting:
    """Tells when the call sites of a file run."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._named: dict[str, list[Scope]] = defaultdict(list)
        for scope in analysis.scopes.all:
            if scope.kind == "function":
                self._named[scope.name].append(scope)
        makers = (node.scope.enclosing("function") for node in analysis.nodes if node.call)
        self._makers = {scope for scope in makers if scope is not None}
        self._constructors = {
            scope.parent.name: scope
            for scope in self._named["__init__"]
            if scope.parent is not None and scope.parent.kind == "class"
        }
        self._repeated: set[Scope] = set()
        self._calls: dict[Scope, list[tuple[Scope, bool]]] = defaultdict(list)
        for call in analysis.captures.get("call", []):
            self._note(call)
        owners = {node.owner for node in analysis.nodes}
        self._repeated = {scope for scope in self._repeated if scope.parent not in owners}
        self._starting = self._closure()

    def when(self, site: Site) -> When:
        """Return when a call site runs."""
        function = site.scope.enclosing("function")
        if function is None:
            return When.START
        if self._is_root(function):
            return When.START
        if _is_property(function):
            return When.ON_DEMAND
        is_starting = function in self._starting
        if self._is_let_go(site, function) and not (
            is_starting and site.endpoint.kind is not EndpointKind.CLIENT
        ):
            return When.ON_DEMAND
        if is_starting:
            return When.START
        if site.endpoint.kind is EndpointKind.CLIENT:
            # Such a function connects, and waits for the service, or gives up.
            return When.LATER
        if self._calls.get(function) or function in self._repeated:
            return When.ON_DEMAND
        return When.SETTING_UP if _SETTING_UP.match(function.name) else When.ELSEWHERE

    def is_starting(self, function: Scope) -> bool:
        """Whether a function surely runs as the node starts; the module does."""
        return function in self._starting

    def _note(self, call: Node) -> None:
        """Note which function a call runs, and whether it does so once, for sure."""
        callee = call.child_by_field_name("function")
        if callee is None or callee.type not in ("identifier", "attribute"):
            return
        holder, _, name = self._analysis.syntax.slice(callee).rpartition(".")
        scope = self._analysis.scopes.at(call.start_byte)
        if not holder and name in self._constructors and _is_repeated(call):
            self._repeated.add(self._constructors[name])
        alike = self._named.get(name)
        if alike is None:
            return
        caller = scope.enclosing("function") or self._analysis.scopes.module
        if caller.self_name and holder == caller.self_name:
            alike = [scope for scope in alike if scope.parent is caller.parent] or alike
        else:
            alike = [scope for scope in alike if bool(scope.self_name) is bool(holder)]
        if len(alike) == 1 and alike[0] is not caller:
            self._calls[alike[0]].append((caller, is_sure(call, caller)))

    def _closure(self) -> set[Scope]:
        """Return the functions that start the node, and those that they call once."""
        found = {scope for alike in self._named.values() for scope in alike if self._is_root(scope)}
        found.add(self._analysis.scopes.module)
        calling: dict[Scope, list[Scope]] = defaultdict(list)
        for function, calls in self._calls.items():
            if len(calls) == 1 and calls[0][1]:
                calling[calls[0][0]].append(function)
        pending = list(found)
        while pending:
            called = [each for each in calling[pending.pop()] if each not in found]
            found.update(called)
            pending += called
        return found

    def _is_root(self, function: Scope) -> bool:
        is_starting = function.name in _STARTING and function not in self._repeated
        return is_starting or function in self._makers

    def _is_let_go(self, site: Site, function: Scope) -> bool:
        """Whether the endpoint is held by a name that is gone when the function returns.

        A client is so that is called at once and not held at all.
        """
        if site.endpoint.kind is EndpointKind.PARAMETER:
            return False
        parent = site.call.parent
        if parent is not None and parent.type in ("call", "attribute"):
            return site.endpoint.kind is EndpointKind.CLIENT
        assignment = next(iter(statement_of(site.call).named_children), None)
        target = assignment.child_by_field_name("left") if assignment is not None else None
        if assignment is None or assignment.type != "assignment" or target is None:
            return False
        names = [target] if target.type == "identifier" else parts_of(target)
        outer = function.globals | function.nonlocals
        return target.type != "attribute" and all(
            each.type == "identifier" and self._analysis.syntax.slice(each) not in outer
            for each in names
        )


def _is_property(function: Scope) -> bool:
    """Whether a function runs when somebody reads an attribute."""
    around = function.node.parent
    decorators = around.children if around is not None else []
    return any(
        each.type == "decorator" and re.match(rb"@[\w.]*property\b", each.text or b"")
        for each in decorators
    )


def _is_repeated(call: Node) -> bool:
    """Whether a call is made for each of some things."""
    current = call.parent
    while current is not None and current.type != "function_definition":
        if current.type in _REPEATED:
            return True
        current = current.parent
    return False


def is_sure(node: Node, caller: Scope) -> bool:
    """Whether a function runs a part of it once, whatever happens."""
    current = node.parent
    while current is not None and current.id != caller.node.id:
        if current.type in _CONDITIONS and not is_main_guard(current):
            return False
        current = current.parent
    return True
