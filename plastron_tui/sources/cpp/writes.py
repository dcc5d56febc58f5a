"""What gives the variables of a unit their values, and what may change them besides."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from tree_sitter import Node

from .arguments import Call
from .scopes import CppFile, Function, Scope, Variable, last_name

if TYPE_CHECKING:
    from .unit import Unit

_MUTATORS = ("append", "assign", "insert", "erase", "replace", "swap", "push_back", "clear")


_CHANGE = re.compile(
    rb"(?:>>\s*|(?<![&\w)\]])&\s*|\+\+\s*|--\s*)(?:this->)?([A-Za-z_]\w*)\b(?!\s*(?:::|\())"
    rb"|\b([A-Za-z_]\w*)\s*(?:\+\+|--)"
)


class Write(NamedTuple):
    """What gives a variable a value.

    Attributes:
        node: the place.
        value: the value, None where it is not one expression.
        scope: the scope of the place.
        call: the call that reads a parameter into it, None for none.
        arguments: what its constructor gets, None where none is called.
    """

    node: Node
    value: Node | None
    scope: Scope
    call: Call | None = None
    arguments: list[Node] | None = None


# Which calls read a parameter of ROS into a variable, their second argument.
PARAMETER_READERS = (
    *("param", "getParam", "getParamCached", "get", "getCached"),
    *("get_parameter", "get_parameter_or"),
)


_CHANGES = re.compile(
    r"get|read|load|parse|fetch|param|scan|printf|cpy|strcat|trim|lower|upper|replace|erase|swap"
    r"|search|fill",
    re.IGNORECASE,
)
NO_CHANGE = frozenset(
    {
        *PARAMETER_READERS,
        *("setParam", "hasParam", "deleteParam", "set", "has", "printf", "get_node", "make_shared"),
        *("declare_parameter", "declare_parameters", "has_parameter", "set_parameter", "getenv"),
        *("declare_parameter_if_not_declared", "getMessage", "target_frame", "getChild"),
    }
)
"""The functions that change nothing, whatever their names may say."""


class Writers:
    """What writes to the variables of a unit."""

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._writes: dict[Variable, list[Write]] = {}

    @cached_property
    def _assigned(self) -> dict[str, list[tuple[Node, Node | None, Node, Scope]]]:
        """The assignments by the last name of what gets the value, with the object before that."""
        found: dict[str, list[tuple[Node, Node | None, Node, Scope]]] = {}
        for file in self._unit.all_files:
            for node, scope in file.assignments:
                left = node.child_by_field_name("left")
                holder = None
                if left is not None and left.type == "field_expression":
                    holder = left.child_by_field_name("argument")
                    left = left.child_by_field_name("field")
                if left is not None and left.type in ("identifier", "field_identifier"):
                    name = file.syntax.word(left)
                    found.setdefault(name, []).append((node, holder, left, scope))
        return found

    @cached_property
    def _read_into(self) -> dict[str, list[tuple[Call, Node]]]:
        """The calls that read parameters into variables, and others that change them, by name."""
        found: dict[str, list[tuple[Call, Node]]] = {}
        for reader in PARAMETER_READERS:
            for call in self._unit.calls.get(reader, ()):
                given = call.argument(1)
                if given is not None:
                    name = last_name(given, call.scope)
                    if name:
                        found.setdefault(name, []).append((call, given))
        return found

    @cached_property
    def _made_anew(self) -> dict[str, list[Call]]:
        """The calls that give pointers something new to point to, by the pointer's name."""
        found: dict[str, list[Call]] = {}
        for name in ("reset", "emplace"):
            for call in self._unit.calls.get(name, ()):
                if call.receiver is not None and call.arguments:
                    found.setdefault(last_name(call.receiver, call.scope), []).append(call)
        return found

    @cached_property
    def _mutated(self) -> set[str]:
        """The names of what methods change."""
        found = set()
        for name in _MUTATORS:
            for call in self._unit.calls.get(name, ()):
                if call.receiver is not None:
                    found.add(last_name(call.receiver, call.scope))
        return found

    @cached_property
    def _changed(self) -> dict[str, list[tuple[CppFile, int]]]:
        """Where something is counted up, read from a stream or handed out to be changed."""
        found: dict[str, list[tuple[CppFile, int]]] = {}
        for file in self._unit.files:
            for change in file.syntax.matches(_CHANGE):
                name = (change[1] or change[2]).decode("utf-8", "replace")
                found.setdefault(name, []).append((file, change.start()))
        return found

    @cached_property
    def _handed(self) -> dict[str, list[tuple[CppFile, int]]]:
        """Where variables are handed to functions that change what they get."""
        found: dict[str, list[tuple[CppFile, int]]] = {}
        for file in self._unit.files:
            for call in file.calls:
                if call.name in NO_CHANGE:
                    continue
                own = self._unit.functions.get(call.name)
                if own is None and not _CHANGES.search(call.name):
                    continue
                for position, given in enumerate(call.arguments):
                    if given.type not in ("identifier", "field_expression"):
                        continue
                    if own is None or any(_changes(each, position) for each in own):
                        name = last_name(given, call.scope)
                        found.setdefault(name, []).append((file, given.start_byte))
        return found

    def is_changed_unseen(self, variable: Variable) -> bool:
        """Whether something may change a variable that is neither an assignment nor a parameter."""
        if variable.is_const:
            return False
        if variable.name in self._mutated:
            return True
        changed = self._changed.get(variable.name, []) + self._handed.get(variable.name, [])
        if variable.kind in ("member", "global"):
            return bool(changed)
        around = variable.scope.enclosing("function") or variable.scope
        return any(
            file is variable.file and around.start <= at < around.end for file, at in changed
        )

    def of(self, variable: Variable) -> list[Write]:
        """Return what gives a variable its values, in no special order."""
        if variable not in self._writes:
            self._writes[variable] = list(self._find_writes(variable))
        return self._writes[variable]

    def _find_writes(self, variable: Variable) -> Iterator[Write]:
        scope = variable.scope
        if variable.value is not None or variable.arguments is not None:
            yield Write(variable.node, variable.value, scope, None, variable.arguments)
        owner = scope.enclosing("class") if variable.kind == "member" else None
        for node, holder, left, at in self._assigned.get(variable.name, ()):
            if not self._is_it(variable, owner, holder, left, at):
                continue
            operator = node.child_by_field_name("operator")
            is_plain = operator is None or operator.type == "="
            yield Write(node, node.child_by_field_name("right") if is_plain else None, at)
        for call in self._made_anew.get(variable.name, ()):
            receiver = call.receiver
            if receiver is None:
                continue
            holder = receiver.child_by_field_name("argument")
            if not self._is_it(variable, owner, holder, receiver, call.scope):
                continue
            if call.name == "emplace":
                yield Write(call.node, None, call.scope, None, call.arguments)
            else:
                yield Write(call.node, call.arguments[0], call.scope)
        for call, given in self._read_into.get(variable.name, ()):
            holder = given.child_by_field_name("argument")
            if self._is_it(variable, owner, holder, given, call.scope):
                yield Write(call.node, None, call.scope, call)
        if owner is not None:
            for defined in self._unit.globals.get(variable.name, ()):
                # `const std::string Names::TOPIC = "x";`
                outer = self._outer_class(defined)
                is_set = defined.value is not None or defined.arguments is not None
                if is_set and outer is not None and self._unit.derives_from(outer, owner):
                    yield Write(defined.node, defined.value, defined.scope, None, defined.arguments)
            for node, listed, at in self._unit.initialized.get(variable.name, ()):
                of = self._unit.class_of(at)
                if of is not None and self._unit.derives_from(of, owner):
                    value = listed[0] if len(listed) == 1 else None
                    yield Write(node, value, at, None, listed)

    def _outer_class(self, variable: Variable) -> Scope | None:
        """Return the class whose static member a variable outside of it defines."""
        node = variable.declarator
        if node is None or node.type != "qualified_identifier":
            return None
        text = "".join(variable.file.syntax.word(node).split())
        return self._unit.find_class(text.rpartition("::")[0], variable.scope)

    def _is_it(
        self, variable: Variable, owner: Scope | None, holder: Node | None, left: Node, at: Scope
    ) -> bool:
        """Whether a name at some place is a variable."""
        if holder is not None and holder.type != "this":
            return owner is not None and self._may_hold(holder, owner, at)
        if holder is not None:
            of = self._unit.class_of(at)
            return of is not None and owner is not None and self._unit.derives_from(of, owner)
        return self._unit.lookup(variable.name, at, left.start_byte) is variable

    def _may_hold(self, holder: Node, owner: Scope, at: Scope) -> bool:
        name = last_name(holder, at)
        held = self._unit.lookup(name, at, holder.start_byte) if name else None
        return held is not None and owner.name in held.type


def _changes(function: Function, position: int) -> bool:
    """Whether a function may change what it gets as an argument."""
    if position >= len(function.parameters):
        return False
    parameter = function.parameters[position]
    return parameter.is_reference and not parameter.is_const
