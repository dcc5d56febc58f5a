"""The files that a node is read from, and what the names in them stand for."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any, NamedTuple

from tree_sitter import Node

from plastron_tui.sources.work_limits import Effort

from .arguments import Call, arguments_of
from .scopes import CppFile, Function, Scope, Variable, type_text

MOST_BASES = 32
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


class Unit:
    """Files that are read together.

    Attributes:
        files: the files, the main one first.
        effort: what is left of the steps for all of them.
        bindings: what the parameters of functions are given in the call that is looked at.
        items: what the variables of loops are in the turn that is looked at.
    """

    def __init__(self, files: Iterable[CppFile]) -> None:
        self.files = list(files)
        self.effort = Effort(sum(len(file.syntax.text) for file in self.files))
        self.bindings: dict[Function, tuple[Call | None, dict[Function, Call]]] = {}
        self.items: dict[Variable, Any] = {}
        self._bases: dict[int, tuple[Scope, ...]] = {}
        self._class_of: dict[Function, Scope | None] = {}
        self._writes: dict[Variable, list[Write]] = {}

    @cached_property
    def classes(self) -> dict[str, list[Scope]]:
        """The classes by their last name."""
        found: dict[str, list[Scope]] = {}
        for scope in self.scopes():
            if scope.kind == "class" and scope.name:
                found.setdefault(scope.name.rpartition("::")[2], []).append(scope)
        return found

    def scopes(self) -> Iterator[Scope]:
        """Yield the scopes of all files."""
        for file in self.files:
            yield from file.scopes

    @cached_property
    def functions(self) -> dict[str, list[Function]]:
        """The functions by name, definitions and declarations."""
        found: dict[str, list[Function]] = {}
        for scope in self.scopes():
            for name, functions in scope.functions.items():
                found.setdefault(name, []).extend(functions)
        return found

    @cached_property
    def calls(self) -> dict[str, list[Call]]:
        """The calls by the last name of what is called."""
        found: dict[str, list[Call]] = {}
        for file in self.files:
            for call in file.calls:
                found.setdefault(call.name, []).append(call)
        return found

    @cached_property
    def _globals(self) -> dict[str, list[Variable]]:
        found: dict[str, list[Variable]] = {}
        for scope in self.scopes():
            if scope.kind in ("file", "namespace"):
                for name, variables in scope.variables.items():
                    found.setdefault(name, []).extend(variables)
        return found

    @cached_property
    def defines(self) -> dict[str, list[str]]:
        """What the macros without arguments are replaced with, by name."""
        found: dict[str, list[str]] = {}
        for file in self.files:
            for define in file.syntax.defines:
                text = file.syntax.between(define.start, define.end).strip()
                found.setdefault(define.name, []).append(text)
        return found

    def find_class(self, name: str, near: Scope | None = None) -> Scope | None:
        """Return the class of the files that a type names, None for none."""
        plain = name.partition("<")[0]
        found = self.classes.get(plain.rpartition("::")[2])
        if found is None:
            return None
        if len(found) > 1 or "::" in plain:
            fitting = [each for each in found if f"::{each.qualified}".endswith(f"::{plain}")]
            if not fitting and "::" in plain:
                space = plain.rpartition("::")[0]
                fitting = [
                    each
                    for each in found
                    if (outer := _outer(each.qualified)) and f"::{space}".endswith(f"::{outer}")
                ]
            found = fitting
        if near is not None and len(found) > 1:
            own = [each for each in found if each.file is near.file]
            found = own or found
        return found[0] if found else None

    def class_of(self, scope: Scope) -> Scope | None:
        """Return the class whose members a scope can name."""
        for each in scope.chain:
            if each.kind == "class":
                return each
            if each.function is not None and each.kind == "function" and each.function.qualifier:
                return self.class_of_function(each.function)
        return None

    def class_of_function(self, function: Function) -> Scope | None:
        """Return the class that a function is a method of, None for none."""
        if function not in self._class_of:
            found = None
            if function.qualifier:
                found = self.find_class(function.qualifier, function.place)
            elif (owner := function.place.enclosing("class", "function", "lambda")) is not None:
                found = owner if owner.kind == "class" else None
            self._class_of[function] = found
        return self._class_of[function]

    def bases(self, owner: Scope) -> tuple[Scope, ...]:
        """Return a class and those of the files that it derives from."""
        found = self._bases.get(id(owner))
        if found is None:
            found = self._bases[id(owner)] = tuple(self._find_bases(owner))
        return found

    def _find_bases(self, owner: Scope) -> Iterator[Scope]:
        pending, seen = [owner], set[int]()
        while pending and len(seen) < MOST_BASES:
            each = pending.pop(0)
            if id(each) in seen:
                continue
            seen.add(id(each))
            yield each
            for base in each.bases:
                found = self.find_class(base, each)
                if found is not None:
                    pending.append(found)

    def foreign_bases(self, owner: Scope) -> Iterator[str]:
        """Yield what a class derives from that is in none of the files."""
        for each in self.bases(owner):
            for base in each.bases:
                if self.find_class(base, each) is None:
                    yield base

    def derives_from(self, owner: Scope, other: Scope) -> bool:
        """Whether a class is another one, or derives from it."""
        return any(each is other for each in self.bases(owner))

    def member(self, owner: Scope, name: str) -> Variable | None:
        """Return a member of a class or of those that it derives from."""
        for each in self.bases(owner):
            found = each.variables.get(name)
            if found:
                return found[0]
        return None

    def lookup(self, name: str, scope: Scope, at: int) -> Variable | None:
        """Return the variable that a name stands for at an offset, None for none."""
        for each in scope.chain:
            found = each.variables.get(name)
            if found:
                if each.kind in ("class", "file", "namespace"):
                    return found[0]
                before = [variable for variable in found if variable.start <= at]
                if before:
                    return before[-1]
            owner = None
            if each.kind == "class":
                owner = each
            elif each.kind == "function" and each.function is not None:
                owner = self.class_of_function(each.function)
            if owner is not None and (member := self.member(owner, name)) is not None:
                return member
        others = self._globals.get(name, [])
        return others[0] if others else None

    def qualified(self, text: str, scope: Scope) -> list[Variable]:
        """Return the variables that `Class::NAME` or `space::NAME` may be."""
        outer, _, name = text.rpartition("::")
        owner = self.find_class(outer, scope) if outer else None
        if owner is not None:
            member = self.member(owner, name)
            return [member] if member is not None else []
        found = []
        for each in self._globals.get(name, ()):
            space = each.scope.qualified
            if not outer or f"::{space}".endswith(f"::{outer}") or outer.endswith(f"::{space}"):
                found.append(each)
        return found

    def returning(self, call: Call) -> Function | None:
        """Return the function that a call calls, if all that it does is to return something."""
        functions = [
            each
            for each in self.functions.get(call.name, ())
            if each.scope is not None and len(each.parameters) == len(call.arguments)
        ]
        if len(functions) != 1 or functions[0].returned is None:
            return None
        return functions[0]

    def function_of(self, scope: Scope) -> Function | None:
        """Return the innermost function or lambda that a scope is in."""
        found = scope.enclosing("function", "lambda")
        return found.function if found is not None else None

    @cached_property
    def _assigned(self) -> dict[str, list[tuple[Node, Node | None, Node, Scope]]]:
        """The assignments by the last name of what gets the value, with the object before that."""
        found: dict[str, list[tuple[Node, Node | None, Node, Scope]]] = {}
        for file in self.files:
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
    def initialized(self) -> dict[str, list[tuple[Node, list[Node], Scope]]]:
        """The initializers of constructors by the name of the member or base, with arguments."""
        found: dict[str, list[tuple[Node, list[Node], Scope]]] = {}
        for file in self.files:
            for node, scope in file.initializers:
                children = node.named_children
                if children:
                    name = "".join(file.syntax.word(children[0]).partition("<")[0].split())
                    given = arguments_of(children[-1]) if len(children) > 1 else []
                    last = name.rpartition("::")[2]
                    found.setdefault(last, []).append((node, given, scope))
        return found

    @cached_property
    def _read_into(self) -> dict[str, list[tuple[Call, Node]]]:
        """The calls that read parameters into variables, and others that change them, by name."""
        found: dict[str, list[tuple[Call, Node]]] = {}
        for reader in PARAMETER_READERS:
            for call in self.calls.get(reader, ()):
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
            for call in self.calls.get(name, ()):
                if call.receiver is not None and call.arguments:
                    found.setdefault(last_name(call.receiver, call.scope), []).append(call)
        return found

    @cached_property
    def _mutated(self) -> set[str]:
        """The names of what methods change."""
        found = set()
        for name in _MUTATORS:
            for call in self.calls.get(name, ()):
                if call.receiver is not None:
                    found.add(last_name(call.receiver, call.scope))
        return found

    @cached_property
    def _changed(self) -> dict[str, list[tuple[CppFile, int]]]:
        """Where something is counted up, read from a stream or handed out to be changed."""
        found: dict[str, list[tuple[CppFile, int]]] = {}
        for file in self.files:
            for change in _CHANGE.finditer(file.syntax.code):
                name = (change[1] or change[2]).decode("utf-8", "replace")
                found.setdefault(name, []).append((file, change.start()))
        return found

    @cached_property
    def _handed(self) -> dict[str, list[tuple[CppFile, int]]]:
        """Where variables are handed to functions that change what they get."""
        found: dict[str, list[tuple[CppFile, int]]] = {}
        for file in self.files:
            for call in file.calls:
                if call.name in NO_CHANGE:
                    continue
                own = self.functions.get(call.name)
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

    def writes(self, variable: Variable) -> list[Write]:
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
            for defined in self._globals.get(variable.name, ()):
                # `const std::string Names::TOPIC = "x";`
                outer = self._outer_class(defined)
                is_set = defined.value is not None or defined.arguments is not None
                if is_set and outer is not None and self.derives_from(outer, owner):
                    yield Write(defined.node, defined.value, defined.scope, None, defined.arguments)
            for node, listed, at in self.initialized.get(variable.name, ()):
                of = self.class_of(at)
                if of is not None and self.derives_from(of, owner):
                    value = listed[0] if len(listed) == 1 else None
                    yield Write(node, value, at, None, listed)

    def _outer_class(self, variable: Variable) -> Scope | None:
        """Return the class whose static member a variable outside of it defines."""
        node = variable.declarator
        if node is None or node.type != "qualified_identifier":
            return None
        text = "".join(variable.file.syntax.word(node).split())
        return self.find_class(text.rpartition("::")[0], variable.scope)

    def _is_it(
        self, variable: Variable, owner: Scope | None, holder: Node | None, left: Node, at: Scope
    ) -> bool:
        """Whether a name at some place is a variable."""
        if holder is not None and holder.type != "this":
            return owner is not None and self._may_hold(holder, owner, at)
        if holder is not None:
            of = self.class_of(at)
            return of is not None and owner is not None and self.derives_from(of, owner)
        return self.lookup(variable.name, at, left.start_byte) is variable

    def _may_hold(self, holder: Node, owner: Scope, at: Scope) -> bool:
        name = last_name(holder, at)
        held = self.lookup(name, at, holder.start_byte) if name else None
        return held is not None and owner.name in held.type

    def statement_of(self, node: Node) -> Node:
        """Return the statement or declaration that a node is in."""
        while node.parent is not None and not node.type.endswith(("statement", "declaration")):
            node = node.parent
        return node


def bound_calls(bound: tuple[Call | None, dict[Function, Call]]) -> list[Call]:
    """Return the call that a function is bound to, none where it is one that nobody makes."""
    return [bound[0]] if bound[0] is not None else []


def _changes(function: Function, position: int) -> bool:
    """Whether a function may change what it gets as an argument."""
    if position >= len(function.parameters):
        return False
    parameter = function.parameters[position]
    return parameter.is_reference and not parameter.is_const


def _outer(qualified: str) -> str:
    return qualified.rpartition("::")[0]


def last_name(node: Node, scope: Scope) -> str:
    """Return the last name of `a`, `this->a`, `b.a`, "" for what is none."""
    if node.type == "field_expression":
        inner = node.child_by_field_name("field")
        node = inner if inner is not None else node
    if node.type in ("identifier", "field_identifier"):
        return scope.file.syntax.word(node)
    return ""


def written_type(node: Node, scope: Scope) -> str:
    """Return a type as it is written, see `type_text`."""
    return type_text(scope.file.syntax.word(node))
