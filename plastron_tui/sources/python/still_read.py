"""What only an uncalled function set, and other functions go on reading."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change, Remove, Update
from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.left_behind import no_longer_set

from .analysis import Analysis
from .creation import line_of
from .functions import function_uses
from .nodes import part_of
from .references import (
    Use,
    Variable,
    function_of,
    identifiers,
    is_member,
    references,
    statement_of,
    variable_of,
)
from .removal import find_sites
from .runs import LOOPS
from .scopes import Scope
from .syntax import nodes_in, parts_of
from .uncalled import path_of, span_of
from .unused_locals import value_of

# Methods that give what they are called on a value, or wake who waits for it.
_SETTING = frozenset(
    {"add", "append", "appendleft", "extend", "insert", "notify", "notify_all", "put", "put_nowait"}
    | {"set", "set_result", "update"}
)
# What has these methods, by the name of what makes it.
_CONTAINERS = re.compile(
    rb"\[|\{|([\w.]+\.)?(\w*Queue|bytearray|Condition|\w*[dD]ict|deque|Event|Future|list|set)\("
)
# One that leaves what it is called on without a value.
_CLEARING = "clear"
_TARGETS = frozenset({"list_pattern", "pattern_list", "tuple_pattern"})
_ASSIGNING = frozenset({"assignment", "augmented_assignment", "for_statement"})
_EMPTY = frozenset(
    {b"None", b"False", b"0", b"0.0", b"''", b'""', b"[]", b"{}", b"()"}
    | {b"dict()", b"list()", b"set()", b"deque()"}
)

Path = tuple[str, ...]


class _Access(NamedTuple):
    """What is done with a variable, or with a part of what it holds.

    Attributes:
        path: the names of the part: `('linear', 'x')` of `self.twist.linear.x`.
        is_set: whether it gets a value.
        method: the method of it that is called or handed on, "" for none.
    """

    path: Path
    is_set: bool
    method: str = ""


def tell_still_read(
    before: Analysis, after: Analysis, changes: Sequence[Change], uncalled: Sequence[Scope]
) -> Diagnostic | None:
    """Return a warning that names what nothing sets any more, and who reads it all the same.

    Args:
        before: the file as it was.
        after: the file as it is.
        changes: what was asked for.
        uncalled: the functions that nothing calls any more.
    """
    gone = _never_run(after, uncalled)
    found = _set_in(after, [each.node for each in gone])
    for variable, paths in _set_in(before, _callbacks(before, changes)).items():
        if (same := _found_again(after, variable)) is not None:
            found.setdefault(same, set()).update(paths)
    told: list[tuple[str, list[str]]] = []
    for variable, paths in found.items():
        if any(variable.scope.is_within(each) for each in gone):
            continue
        told.append((_written(variable), list(_Uses(after, variable, gone).readers(paths))))
    return no_longer_set(told, span_of(before, changes, {each.name for each in uncalled}))


def _never_run(analysis: Analysis, uncalled: Sequence[Scope]) -> list[Scope]:
    """Return functions that nothing calls, and those that only they call."""
    gone = list(uncalled)
    for function in gone:
        for call in _calls_in(analysis, function):
            callee = call.child_by_field_name("function")
            called = function_of(callee, analysis) if callee is not None else None
            if called is not None and called not in gone:
                uses = function_uses(analysis, called)
                if all(any(is_inside(use, each.node) for each in gone) for use in uses):
                    gone.append(called)
    return gone


def _calls_in(analysis: Analysis, function: Scope) -> list[Node]:
    return [each for each in analysis.captures.get("call", []) if is_inside(each, function.node)]


def _callbacks(before: Analysis, changes: Sequence[Change]) -> list[Node]:
    """Return what the endpoints that change were given to call."""
    found = []
    for change in changes:
        if not isinstance(change, Remove | Update):
            continue
        for site in find_sites(part_of(before, change.node), change):
            shape = site.shape.callback
            given = site.arguments.get(shape) if shape is not None else None
            found += [given] if given is not None else []
    return found


def _set_in(analysis: Analysis, parts: Sequence[Node]) -> dict[Variable, set[Path]]:
    """Return the variables that parts of a file set, each with what of it they set."""
    found: dict[Variable, set[Path]] = {}
    ranges = [(each.start_byte, each.end_byte) for each in parts]
    nodes = sorted(nodes_in(analysis.syntax.root, ranges), key=lambda each: each.start_byte)
    for node in nodes:
        is_name = node.type == "identifier" and not is_member(node)
        access = _access(analysis, node) if is_name or node.type == "attribute" else None
        variable = variable_of(node, analysis) if access is not None and access.is_set else None
        if access is None or variable is None:
            continue
        if not access.method or _is_container(variable):
            found.setdefault(variable, set()).add(access.path)
    return found


def _is_container(variable: Variable) -> bool:
    """Whether a variable is sure to have what can be filled, or waited for."""
    bindings = variable.scope.attributes if variable.is_attribute else variable.scope.bindings
    values = [each.value for each in bindings.get(variable.name, []) if each.value is not None]
    values = [each for each in values if each.type != "none"]
    return bool(values) and all(_CONTAINERS.match(each.text or b"") for each in values)


def _found_again(after: Analysis, variable: Variable) -> Variable | None:
    """Return a variable of a file as it was, in the file as it is."""
    path = path_of(variable.scope)
    scope = next((each for each in after.scopes.all if path_of(each) == path), None)
    return Variable(scope, variable.name, variable.is_attribute) if scope is not None else None


def _written(variable: Variable) -> str:
    return f"self.{variable.name}" if variable.is_attribute else variable.name


def _access(analysis: Analysis, node: Node) -> _Access:
    """Return what is done with an expression that is a variable."""
    names: list[str] = []
    whole, is_plain = node, True
    while (parent := whole.parent) is not None:
        name = parent.child_by_field_name("attribute")
        if parent.type == "attribute" and name is not None and name.id != whole.id:
            word = analysis.syntax.slice(name)
            if word in _SETTING or _is_callee(parent):
                return _Access(tuple(names), word in _SETTING, word)
            if is_plain:
                names.append(word)
        elif parent.type == "subscript" and parent.child_by_field_name("value") == whole:
            is_plain = False
        else:
            break
        whole = parent
    while whole.parent is not None and whole.parent.type in _TARGETS:
        whole = whole.parent
    owner = whole.parent
    is_target = owner is not None and owner.type in _ASSIGNING
    is_set = owner is not None and is_target and owner.child_by_field_name("left") == whole
    return _Access(tuple(names), is_set)


class _Uses:
    """The uses of a variable outside of what never runs."""

    def __init__(self, analysis: Analysis, variable: Variable, gone: Sequence[Scope]) -> None:
        self._analysis = analysis
        self._variable = variable
        self._gone = gone

    def readers(self, paths: set[Path]) -> Iterator[str]:
        """Yield who reads what nothing sets of some parts of the variable, and in which line."""
        set_: list[tuple[Node, Path]] = []
        read: list[tuple[Node, _Access]] = []
        for use in references(self._variable, self._analysis):
            if use.use is Use.NOTHING or not self._may_run(use.node):
                continue
            access = _access(self._analysis, use.node)
            if access.is_set:
                set_.append((use.node, access.path))
            elif access.method != _CLEARING:
                read.append((use.node, access))
        set_ += self._set_elsewhere()
        first = {node.id for node, _ in set_ if self._is_first(node)}
        values = {_value(node) for node, _ in set_ if node.id in first} - {None} | _EMPTY
        again = {path for node, path in set_ if node.id not in first and _value(node) not in values}
        left = [path for path in paths if not any(path[: len(each)] == each for each in again)]
        told: dict[Scope, str] = {}
        for node, access in read:
            function = self._function(node)
            is_first = self._is_first(node) and self._variable.is_attribute
            if not is_first and function not in told and any(_reads(access, each) for each in left):
                told[function] = self._told(node, function)
        yield from told.values()

    def _may_run(self, node: Node) -> bool:
        return not any(is_inside(node, each.node) for each in self._gone)

    def _set_elsewhere(self) -> Iterator[tuple[Node, Path]]:
        """Yield what sets an attribute of the name of an object that the file does not tell."""
        for node in identifiers(self._variable.name, self._analysis):
            attribute = node.parent
            if attribute is None or attribute.type != "attribute" or not is_member(node):
                continue
            if variable_of(attribute, self._analysis) is None and self._may_run(attribute):
                access = _access(self._analysis, attribute)
                if access.is_set:
                    yield attribute, access.path

    def _is_first(self, node: Node) -> bool:
        """Whether something is done once, before any callback is called."""
        current: Node | None = node
        while current is not None and not current.type.endswith("_definition"):
            if current.type in LOOPS or current.type in ("while_statement", "lambda"):
                return False
            current = current.parent
        function = self._function(node)
        if function is self._variable.scope or function.name in ("__init__", ""):
            return True
        uses = function_uses(self._analysis, function)
        return bool(uses) and all(
            _is_callee(each.parent if is_member(each) else each)
            and self._function(each).name == "__init__"
            for each in uses
        )

    def _function(self, node: Node) -> Scope:
        scope = self._analysis.scopes.at(node.start_byte)
        return scope.enclosing("function") or self._analysis.scopes.module

    def _told(self, node: Node, function: Scope) -> str:
        who = f" by `{function.name}`" if function.name else ""
        return f"{'waited for' if self._is_wait(node) else 'read'}{who} in line {line_of(node)}"

    def _is_wait(self, node: Node) -> bool:
        """Whether a use of the variable keeps a function waiting for its value."""
        parent = node.parent
        call = parent.parent if parent is not None else None
        if call is not None and call.type == "call":
            called = self._analysis.syntax.called_name(call)
            is_queue = b".put" in (self._analysis.syntax.text or b"")
            if called == "wait" or (called == "get" and is_queue and not _given(call)):
                return True
        asked = False
        current: Node = node
        while (parent := current.parent) is not None and current != statement_of(node):
            is_none = parent.type == "comparison_operator" and parts_of(parent)[-1].type == "none"
            asked = asked or parent.type == "not_operator" or is_none
            if parent.type == "while_statement":
                return asked and parent.child_by_field_name("condition") == current
            if parent.type == "lambda" and parent.parent is not None:
                waiting = self._analysis.syntax.called_name(parent.parent.parent)
                return waiting.startswith("wait")
            current = parent
        return False


def _is_callee(node: Node | None) -> bool:
    """Whether an expression is what a call calls."""
    call = node.parent if node is not None else None
    return call is not None and call.child_by_field_name("function") == node


def _given(call: Node) -> list[Node]:
    """Return the positional arguments of a call."""
    given = parts_of(call.child_by_field_name("arguments"))
    return [each for each in given if each.type not in ("keyword_argument", "true")]


def _value(node: Node) -> bytes | None:
    """Return the text of what a statement gives to a variable, None where it does more."""
    statement = statement_of(node)
    inner = next(iter(parts_of(statement)), None)
    is_plain = inner is not None and inner.type == "assignment"
    value = value_of(statement) if is_plain else None
    while value is not None and value.type == "assignment":
        value = value.child_by_field_name("right")
    return value.text if value is not None else None


def _reads(access: _Access, part: Path) -> bool:
    """Whether an access takes a part of what a variable holds, or more, or less of it.

    What a method does with the other parts of its object is not known.
    """
    shorter = len(part) if access.method else min(len(access.path), len(part))
    return access.path[:shorter] == part[:shorter]
