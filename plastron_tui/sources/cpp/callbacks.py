"""What is called back: a name, and what it takes, whatever it is wrapped in."""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from .arguments import call_of
from .scopes import Function, Scope, declared, type_text
from .type_texts import split_outside, template_arguments, without_templates
from .unit import Unit

_BINDERS = frozenset({"bind", "bind_front", "mem_fn"})
_WRAPPERS = frozenset({"function", "static_cast", "move", "ref", "make_callback"})
_SIGNATURE = re.compile(
    r"(?:std|boost)::function<[^()]*\((.*)\)>|[^()]*\((?:[\w:]*\*[^()]*)?\)\((.*)\)"
)


class Callback(NamedTuple):
    """What is called back.

    Attributes:
        name: the last part of its name, None where it has none.
        functions: the functions of the files that it may be, definitions first.
        types: the types of its parameters, each with the scope that it is written in.
    """

    name: str | None = None
    functions: tuple[Function, ...] = ()
    types: tuple[tuple[str, Scope], ...] = ()

    def type_at(self, position: int) -> tuple[str, Scope] | None:
        """Return the type of a parameter, None where it is not known."""
        return self.types[position] if position < len(self.types) else None


NONE = Callback()


def callback_of(unit: Unit, node: Node | None, scope: Scope, depth: int = 0) -> Callback:
    """Return what an argument calls back."""
    if node is None or depth > 6:
        return NONE
    syntax = scope.file.syntax
    match node.type:
        case "pointer_expression" | "parenthesized_expression":
            inner = node.child_by_field_name("argument")
            if inner is None and node.named_child_count:
                inner = node.named_children[-1]
            return callback_of(unit, inner, scope, depth + 1)
        case "lambda_expression":
            return Callback(None, (), tuple(_lambda_types(node, scope)))
        case "call_expression":
            call = call_of(node, scope, syntax)
            if call is None or not call.arguments:
                return NONE
            if call.name in _BINDERS:
                return callback_of(unit, call.arguments[0], scope, depth + 1)
            if call.name in _WRAPPERS:
                inner_callback = callback_of(unit, call.arguments[0], scope, depth + 1)
                signature = "".join(
                    f"{call.qualified}{syntax.word(call.template)}" if call.template else ""
                )
                said = _signature_types(signature, scope, call.name)
                return inner_callback._replace(types=said or inner_callback.types)
            return NONE
        case "identifier" | "field_identifier" | "type_identifier":
            return _named(unit, syntax.word(node), node, scope, depth)
        case "field_expression":
            inner = node.child_by_field_name("field")
            return _named(unit, syntax.word(inner), node, scope, depth) if inner else NONE
        case "qualified_identifier" | "template_function" | "template_method":
            text = "".join(syntax.word(node).split()).removeprefix("::")
            outer, _, last = without_templates(text).rpartition("::")
            return _of_template(_of_functions(unit, last, outer, scope), text, scope)
        case _:
            return NONE


def _named(unit: Unit, name: str, node: Node, scope: Scope, depth: int) -> Callback:
    variable = unit.lookup(name, scope, node.start_byte)
    if variable is not None and variable.kind not in ("parameter", "loop"):
        value = variable.value
        if value is None and variable.arguments is not None and len(variable.arguments) == 1:
            value = variable.arguments[0]
        if value is None:
            assigned = [each for each in unit.writes(variable) if each.value is not None]
            if len(assigned) == 1 and assigned[0].value is not None:
                held = callback_of(unit, assigned[0].value, assigned[0].scope, depth + 1)
                return held._replace(name=held.name or name)
        if value is not None:
            held = callback_of(unit, value, variable.scope, depth + 1)
            types = held.types or _signature_types(variable.type, variable.scope, "")
            return held._replace(name=held.name or name, types=types)
        return Callback(name, (), _signature_types(variable.type, variable.scope, ""))
    if variable is not None:
        function = variable.scope.function
        bound = unit.bindings.get(function) if function is not None else None
        if bound is not None and function is not None:
            position = next(
                (at for at, each in enumerate(function.parameters) if each is variable), None
            )
            call = bound[0]
            given = call.argument(position) if call and position is not None else None
            if call is not None and given is not None:
                return callback_of(unit, given, call.scope, depth + 1)
        return Callback(None, (), _signature_types(variable.type, variable.scope, ""))
    return _of_functions(unit, name, "", scope)


def _of_functions(unit: Unit, name: str, outer: str, scope: Scope) -> Callback:
    functions = unit.functions.get(name, [])
    owner = unit.find_class(outer, scope) if outer else unit.class_of(scope)
    if owner is not None:
        bases = list(unit.bases(owner))
        own = [each for each in functions if unit.class_of_function(each) in bases]
        functions = own or ([] if outer else functions)
    functions = sorted(functions, key=lambda each: each.scope is None)
    types: tuple[tuple[str, Scope], ...] = ()
    if functions:
        first = functions[0]
        types = tuple((each.type, first.scope or first.place) for each in first.parameters)
    return Callback(name, tuple(functions), types)


def _of_template(callback: Callback, text: str, scope: Scope) -> Callback:
    """Return what `f<A>` or `C<A>::f` takes, with the arguments of the template in it."""
    if "<" not in text or not callback.functions:
        return callback
    outer, inner = "", ""
    for part in split_outside(text, "::"):
        outer, inner = inner, part.partition("<")[2].rpartition(">")[0]
    function = callback.functions[0]
    put: dict[str, str] = {}
    is_of_class = bool(function.qualifier)
    for place in function.place.chain:
        is_of_class = is_of_class or place.kind == "class"
        if place.kind == "template":
            given = outer if is_of_class else inner
            listed = template_arguments(given) if given else []
            put.update(zip(place.template_names, map(type_text, listed), strict=False))
    if not put:
        return callback
    names = re.compile(rf"(?<![\w:])(?:{'|'.join(map(re.escape, put))})\b")
    return callback._replace(
        types=tuple(
            (names.sub(lambda found: put[found[0]], type_), scope if names.search(type_) else place)
            for type_, place in callback.types
        )
    )


def _lambda_types(node: Node, scope: Scope) -> list[tuple[str, Scope]]:
    declarator = node.child_by_field_name("declarator")
    listed = declarator.child_by_field_name("parameters") if declarator is not None else None
    found = []
    for each in listed.named_children if listed is not None else ():
        type_node = each.child_by_field_name("type")
        text = type_text(scope.file.syntax.word(type_node)) if type_node is not None else ""
        found.append((text, scope))
    return found


def _signature_types(text: str, scope: Scope, name: str) -> tuple[tuple[str, Scope], ...]:
    """Return what `std::function<void(const A&)>` and its like take."""
    if name == "static_cast":
        text = text.partition("<")[2].rpartition(">")[0]
    found = _SIGNATURE.fullmatch("".join(text.split()).removeprefix("::"))
    if found is None:
        return ()
    listed = found[1] if found[1] is not None else found[2]
    # Blanks are gone: `const` stands before the type, or behind it.
    parts = (
        re.sub(r"\bconst(?=[a-z_]\w*::)|const\b", "", each) for each in template_arguments(listed)
    )
    return tuple((type_text(re.sub(r"(?<=&)\w+\Z", "", each)), scope) for each in parts)


__all__ = ["NONE", "Callback", "callback_of", "declared"]
