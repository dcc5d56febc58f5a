"""The files that a node is read from, and what the names in them stand for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any

from tree_sitter import Node

from plastron_tui.sources.work_limits import Effort

from .arguments import Call, arguments_of
from .scopes import CppFile, Function, Scope, Variable, type_text
from .writes import Write, Writers

MOST_BASES = 32


class Unit:
    """Files that are read together.

    Attributes:
        files: the files, the main one first.
        all_files: these, and the other sources that define and make what they declare.
        effort: what is left of the steps for all of them.
        bindings: what the parameters of functions are given in the call that is looked at.
        items: what the variables of loops are in the turn that is looked at.
    """

    def __init__(self, files: Iterable[CppFile], beside: Iterable[CppFile] = ()) -> None:
        self.files = list(files)
        self.all_files = [*self.files, *beside]
        self.effort = Effort(sum(len(file.syntax.text) for file in self.files))
        self.bindings: dict[Function, tuple[Call | None, dict[Function, Call]]] = {}
        self.items: dict[Variable, Any] = {}
        self._bases: dict[int, tuple[Scope, ...]] = {}
        self._class_of: dict[Function, Scope | None] = {}
        self._writers = Writers(self)

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
        for file in self.all_files:
            for scope in file.scopes:
                for name, functions in scope.functions.items():
                    # Of another source only the methods are those of classes of these files.
                    seen = [each for each in functions if each.qualifier or not file.is_beside]
                    if seen:
                        found.setdefault(name, []).extend(seen)
        return found

    @cached_property
    def calls(self) -> dict[str, list[Call]]:
        """The calls by the last name of what is called."""
        found: dict[str, list[Call]] = {}
        for file in self.all_files:
            for call in file.calls:
                found.setdefault(call.name, []).append(call)
        return found

    @cached_property
    def globals(self) -> dict[str, list[Variable]]:
        """The variables outside of classes and functions, by name."""
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

    def functions_of(self, owner: Scope | None, name: str) -> list[Function]:
        """Return what declares and defines the functions of a name of a class, or of no class."""
        named = self.functions.get(name, ())
        return [each for each in named if self.class_of_function(each) is owner]

    def with_declarations(self, function: Function) -> list[Function]:
        """Return a function with its declarations, and with the others that share its name."""
        return self.functions_of(self.class_of_function(function), function.name)

    def functions_by_class(self, name: str) -> list[list[Function]]:
        """Return the functions of a name, those of one class or of none together."""
        by_class: dict[str, list[Function]] = {}
        for each in self.functions.get(name, ()):
            by_class.setdefault(each.class_name, []).append(each)
        return list(by_class.values())

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
                before = [variable for variable in found if variable.is_visible(at)]
                if before:
                    return before[-1]
            owner = None
            if each.kind == "class":
                owner = each
            elif each.kind == "function" and each.function is not None:
                owner = self.class_of_function(each.function)
            if owner is not None and (member := self.member(owner, name)) is not None:
                return member
        others = self.globals.get(name, [])
        return others[0] if others else None

    def qualified(self, text: str, scope: Scope) -> list[Variable]:
        """Return the variables that `Class::NAME` or `space::NAME` may be."""
        outer, _, name = text.rpartition("::")
        owner = self.find_class(outer, scope) if outer else None
        if owner is not None:
            member = self.member(owner, name)
            return [member] if member is not None else []
        found = []
        for each in self.globals.get(name, ()):
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
    def initialized(self) -> dict[str, list[tuple[Node, list[Node], Scope]]]:
        """The initializers of constructors by the name of the member or base, with arguments."""
        found: dict[str, list[tuple[Node, list[Node], Scope]]] = {}
        for file in self.all_files:
            for node, scope in file.initializers:
                children = node.named_children
                if children:
                    name = "".join(file.syntax.word(children[0]).partition("<")[0].split())
                    given = arguments_of(children[-1]) if len(children) > 1 else []
                    last = name.rpartition("::")[2]
                    found.setdefault(last, []).append((node, given, scope))
        return found

    def writes(self, variable: Variable) -> list[Write]:
        """Return what gives a variable its values, in no special order."""
        return self._writers.of(variable)

    def is_changed_unseen(self, variable: Variable) -> bool:
        """Whether something may change a variable that is neither an assignment nor a parameter."""
        return self._writers.is_changed_unseen(variable)

    def statement_of(self, node: Node) -> Node:
        """Return the statement or declaration that a node is in."""
        while node.parent is not None and not node.type.endswith(("statement", "declaration")):
            node = node.parent
        return node


def bound_calls(bound: tuple[Call | None, dict[Function, Call]]) -> list[Call]:
    """Return the call that a function is bound to, none where it is one that nobody makes."""
    return [bound[0]] if bound[0] is not None else []


def _outer(qualified: str) -> str:
    return qualified.rpartition("::")[0]


def written_type(node: Node, scope: Scope) -> str:
    """Return a type as it is written, see `type_text`."""
    return type_text(scope.file.syntax.word(node))
