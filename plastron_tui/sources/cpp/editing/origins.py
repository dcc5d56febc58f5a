"""Where the texts stand that decide the names of endpoints."""

from __future__ import annotations

import re
from typing import NamedTuple

from tree_sitter import Node

from ..analysis import Analysis, Site
from ..arguments import call_of
from ..scopes import CppFile, Scope, Variable, last_name, scope_at

SAME = frozenset({"c_str", "str", "data", "string", "get", "string_view"})
_MOST_STEPS = 16

# Calls that read a parameter, with the position of what it is without one.
_DEFAULTS = {
    **dict.fromkeys(("param", "get_parameter_or", "getParam"), 2),
    **dict.fromkeys(("declare_parameter",), 1),
}


class Origin(NamedTuple):
    """A text that decides a name.

    Attributes:
        file: the file that has it.
        start: where it begins, quotes included.
        end: where it ends.
        variables: the variables by which it comes to the call.
    """

    file: CppFile
    start: int
    end: int
    variables: tuple[Variable, ...] = ()


def origin_of(analysis: Analysis, site: Site) -> Origin | None:
    """Return the text that alone decides the name of an endpoint, None where there is none."""
    given = name_argument(site)
    if given is None:
        return None
    return _follow(analysis, site, given, site.call.scope, (), 0)


def name_argument(site: Site) -> Node | None:
    """Return the argument that names an endpoint."""
    position = site.shape.name
    return site.arguments[position] if position < len(site.arguments) else None


def _follow(
    analysis: Analysis,
    site: Site,
    node: Node | None,
    scope: Scope,
    through: tuple[Variable, ...],
    depth: int,
) -> Origin | None:
    if node is None or depth > _MOST_STEPS:
        return None
    syntax = scope.file.syntax
    match node.type:
        case "string_literal" | "raw_string_literal":
            return Origin(scope.file, node.start_byte, node.end_byte, through)
        case "parenthesized_expression" | "initializer_list":
            inner = node.named_children
            one = inner[0] if len(inner) == 1 else None
            return _follow(analysis, site, one, scope, through, depth + 1)
        case "identifier" | "field_identifier" | "qualified_identifier":
            return _named(analysis, site, node, scope, through, depth)
        case "field_expression":
            return _named(analysis, site, node, scope, through, depth)
        case "call_expression":
            call = call_of(node, scope, syntax)
            if call is None:
                return None
            if call.name in SAME:
                inner_node = call.receiver or call.argument(0)
                return _follow(analysis, site, inner_node, scope, through, depth + 1)
            position = _DEFAULTS.get(call.name)
            default = None if position is None else call.argument(position)
            return _follow(analysis, site, default, scope, through, depth + 1)
        case _:
            return None


def _named(
    analysis: Analysis,
    site: Site,
    node: Node,
    scope: Scope,
    through: tuple[Variable, ...],
    depth: int,
) -> Origin | None:
    unit = analysis.unit
    name = last_name(node, scope) or scope.file.syntax.word(node).rpartition("::")[2]
    text = "".join(scope.file.syntax.word(node).split())
    if "::" in text and node.type == "qualified_identifier":
        found = unit.qualified(text, scope)
        variable = found[0] if len(found) == 1 else None
    else:
        variable = unit.lookup(name, scope, node.start_byte)
    if variable is None:
        return _macro(analysis, name)
    if variable in through:
        return None
    through = (*through, variable)
    if variable.kind == "parameter":
        return _given(analysis, site, variable, through, depth)
    writes = unit.writes(variable)
    if len(writes) != 1:
        return None
    write = writes[0]
    if write.call is not None:
        position = _DEFAULTS.get(write.call.name)
        default = None if position is None else write.call.argument(position)
        return _follow(analysis, site, default, write.call.scope, through, depth + 1)
    value = write.value
    if value is None and write.arguments is not None and len(write.arguments) == 1:
        value = write.arguments[0]
    return _follow(analysis, site, value, write.scope, through, depth + 1)


def _given(
    analysis: Analysis,
    site: Site,
    variable: Variable,
    through: tuple[Variable, ...],
    depth: int,
) -> Origin | None:
    """Follow a parameter to what the call that is looked at gives it, or to its default."""
    function = variable.scope.function
    if function is None:
        return None
    position = next((at for at, each in enumerate(function.parameters) if each is variable), None)
    if position is None:
        return None
    for bound, call in site.bindings:
        if bound is function:
            given = call.argument(position)
            if given is not None:
                return _follow(analysis, site, given, call.scope, through, depth + 1)
    if site.bindings:
        return None
    callers = analysis.callers.of(function)
    if len(callers) > 1:
        return None
    given = callers[0].argument(position) if callers else None
    if given is not None:
        return _follow(analysis, site, given, callers[0].scope, through, depth + 1)
    default = analysis.callers.default_of(function, position)
    if default is None:
        return None
    return _follow(analysis, site, default, _place_of(analysis, default, variable), through, depth)


def _place_of(analysis: Analysis, node: Node, variable: Variable) -> Scope:
    """Return the scope of a default, which a header may have."""
    if variable.value is not None and variable.value.id == node.id:
        return variable.scope
    for file in analysis.unit.files:
        inner = file.syntax.root.named_descendant_for_byte_range(node.start_byte, node.end_byte)
        if inner is not None and inner.id == node.id:
            return scope_at(file, node.start_byte)
    return variable.scope


def _macro(analysis: Analysis, name: str) -> Origin | None:
    """Return the text of a macro that is defined once."""
    found = [
        Origin(file, define.start, define.end)
        for file in analysis.unit.files
        for define in file.syntax.defines
        if define.name == name
    ]
    if len(found) != 1:
        return None
    text = found[0].file.syntax.between(found[0].start, found[0].end)
    stripped = text.strip()
    start = found[0].start + len(text[: len(text) - len(text.lstrip())])
    is_text = re.fullmatch(r'"(?:[^"\\]|\\.)*"', stripped) is not None
    return found[0]._replace(start=start, end=start + len(stripped.encode())) if is_text else None
