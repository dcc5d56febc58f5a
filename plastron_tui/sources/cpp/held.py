"""What an expression is, behind the variables and parameters that have it."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.work_limits import bounded

from .arguments import Call, arguments_of, call_of
from .callers import Callers
from .scopes import Scope, Variable, last_name, type_text
from .types import Types
from .unit import Unit, bound_calls


class Held(NamedTuple):
    """Something that is made, or an expression that names no variable.

    Attributes:
        node: the expression, or the declaration of an object.
        scope: the scope that it is in.
        type: the type that is made, see `type_text`; "" for another expression.
        arguments: what its constructor gets.
        variables: the variables that it was held by, the outermost first.
        call: the call that it is, None for no call.
        is_guess: whether a caller elsewhere may give another one.
    """

    node: Node
    scope: Scope
    type: str = ""
    arguments: tuple[Node, ...] = ()
    variables: tuple[Variable, ...] = ()
    call: Call | None = None
    is_guess: bool = False


class Holding:
    """What the variables of a unit hold."""

    def __init__(self, unit: Unit, types: Types, callers: Callers) -> None:
        self._unit = unit
        self._types = types
        self._callers = callers
        self.effort = unit.effort

    @bounded(None)
    def of(self, node: Node | None, scope: Scope) -> Held | None:
        """Return what an expression is, None where that is not one thing."""
        if node is None:
            return None
        match node.type:
            case "identifier" | "field_identifier" | "type_identifier":
                name = scope.file.syntax.word(node)
                variable = self._unit.lookup(name, scope, node.start_byte)
                return Held(node, scope) if variable is None else self.of_variable(variable)
            case "field_expression":
                holder = node.child_by_field_name("argument")
                owner = self._unit.class_of(scope)
                name = last_name(node, scope)
                is_own = holder is not None and holder.type == "this" and owner is not None
                member = self._unit.member(owner, name) if is_own and owner is not None else None
                return Held(node, scope) if member is None else self.of_variable(member)
            case "qualified_identifier":
                text = "".join(scope.file.syntax.word(node).split()).removeprefix("::")
                variables = self._unit.qualified(text, scope)
                return self.of_variable(variables[0]) if len(variables) == 1 else Held(node, scope)
            case "parenthesized_expression":
                inner = node.named_children
                return self.of(inner[0], scope) if len(inner) == 1 else None
            case "pointer_expression":
                return self.of(node.child_by_field_name("argument"), scope)
            case "new_expression" | "compound_literal_expression":
                return self._made(node, scope)
            case "call_expression":
                call = call_of(node, scope, scope.file.syntax)
                return None if call is None else self._called(call)
            case _:
                return Held(node, scope)

    def _made(self, node: Node, scope: Scope) -> Held:
        type_node = node.child_by_field_name("type")
        given = node.child_by_field_name("arguments") or node.child_by_field_name("value")
        text = type_text(scope.file.syntax.word(type_node)) if type_node is not None else ""
        arguments = tuple(arguments_of(given))
        return Held(node, scope, self._types.expand(text, scope), arguments)

    def _called(self, call: Call) -> Held | None:
        if call.name == "move" and len(call.arguments) == 1:
            return self.of(call.arguments[0], call.scope)
        if call.receiver is not None:
            return Held(call.node, call.scope, call=call)
        function = self._unit.returning(call)
        if function is not None and not function.parameters:
            return self.of(function.returned, function.scope or function.place)
        text = self._types.expand(call.qualified, call.scope)
        if call.template is not None:
            text += "".join(call.scope.file.syntax.word(call.template).split())
        return Held(call.node, call.scope, text, tuple(call.arguments), call=call)

    @bounded(None)
    def of_variable(self, variable: Variable) -> Held | None:
        """Return what a variable holds, None where that is not one thing."""
        if variable.kind == "parameter":
            return self._given(variable)
        if variable.kind == "loop":
            return None
        writes = self._unit.writes(variable)
        if len(writes) > 1:
            writes = [each for each in writes if each.value is None or each.value.type != "null"]
        if not writes:
            # Made without arguments.
            text = self._types.expand(variable.type, variable.scope)
            return Held(variable.node, variable.scope, text, (), (variable,))
        if len(writes) > 1:
            return None
        (write,) = writes
        if write.value is not None and write.arguments is None:
            if write.value.type == "initializer_list":
                given = tuple(arguments_of(write.value))
                return self._of_type(variable, write.node, given)
            found = self.of(write.value, write.scope)
            return None if found is None else found._replace(variables=(variable, *found.variables))
        if write.arguments is not None:
            return self._of_type(variable, write.node, tuple(write.arguments))
        return None

    def _of_type(self, variable: Variable, node: Node, given: tuple[Node, ...]) -> Held:
        text = self._types.expand(variable.type, variable.scope)
        writes = self._unit.writes(variable)
        scope = writes[0].scope if writes else variable.scope
        return Held(node, scope, text, given, (variable,))

    def _given(self, parameter: Variable) -> Held | None:
        function = parameter.scope.function
        if function is None:
            return None
        position = next(
            (at for at, each in enumerate(function.parameters) if each is parameter), None
        )
        if position is None:
            return None
        bound = self._unit.bindings.get(function)
        calls = bound_calls(bound) if bound is not None else self._callers.of(function)
        if len(calls) == 1:
            given = calls[0].argument(position)
            if given is not None:
                return self.of(given, calls[0].scope)
        default = self._callers.default_of(function, position)
        if len(calls) > 1 or default is None:
            return None
        found = self.of(default, function.place)
        return None if found is None else found._replace(is_guess=not calls)
