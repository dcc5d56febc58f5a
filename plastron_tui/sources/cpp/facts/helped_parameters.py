"""Parameters that functions of Nav2 declare for a node, and the types of defaults.

Source: `nav2_util/node_utils.hpp` of Jazzy, `nav2_ros_common/lifecycle_node.hpp` of later ones.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterUse
from plastron_tui.sources.cpp.analysis import Analysis, NodeSite
from plastron_tui.sources.cpp.arguments import Call
from plastron_tui.sources.cpp.parameter_details import type_of_text, type_of_worth
from plastron_tui.sources.cpp.scopes import Scope, type_text

HELPERS = ("declare_or_get_parameter", "declare_parameter_if_not_declared")
"""What declares a parameter, of the node itself or of one that it gets before the name."""

_LITERALS = frozenset({"number_literal", "string_literal", "raw_string_literal", "true", "false"})
_NAMED_TYPES = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "string"}
_NAMED_TYPE = re.compile(r"(?:.*::)?PARAMETER_(?P<type>[A-Z]+)(?P<list>_ARRAY)?")


def helper_calls(analysis: Analysis) -> Iterator[Call]:
    """Yield the calls of such functions in the files of a unit."""
    for name in HELPERS:
        if name not in analysis.unit.functions:
            yield from (c for c in analysis.unit.calls.get(name, ()) if not c.scope.file.is_beside)


def helped_uses(analysis: Analysis, maker: NodeSite, *, is_dynamic: bool) -> Iterator[ParameterUse]:
    """Yield the parameters that such functions declare of a node, in its own methods."""
    for call in helper_calls(analysis):
        if maker.owner is None or analysis.unit.class_of(call.scope) is not maker.owner:
            continue
        is_first = analysis.receivers.type_of(call.argument(0), call.scope) in ("", "std::string")
        at = 0 if call.receiver is not None or (is_first and not call.qualifier) else 1
        given, default = call.argument(at), call.argument(at + 1)
        value = None if given is None else analysis.evaluator.fold(given, call.scope)
        is_sure = value is not None and not (value.is_default or value.is_guess)
        type_ = None
        if call.type_nodes:
            type_ = type_of_text(type_text(call.scope.file.syntax.word(call.type_nodes[0])))
        elif default is not None:
            type_ = type_of_default(analysis, default, call.scope)
        place = call.node if given is None else given
        yield ParameterUse(
            ParameterAccess.DECLARE,
            value.text if is_sure and value is not None else None,
            Span(place.start_byte, place.end_byte),
            call.scope.file.name,
            None if is_dynamic else type_,
        )


def type_of_default(analysis: Analysis, node: Node, scope: Scope) -> str | None:
    """Return the type of a default; a number that a variable has says nothing of its type."""
    inner = node
    if inner.type == "unary_expression":
        inner = inner.child_by_field_name("argument") or inner
    if inner.type in _LITERALS:
        return type_of_worth(analysis.evaluator.fold(node, scope))
    syntax = scope.file.syntax
    if node.type == "call_expression":
        callee = node.child_by_field_name("function")
        text = type_text(syntax.word(callee)) if callee is not None else ""
        given = node.child_by_field_name("arguments")
        if text.rpartition("::")[2] == "ParameterValue" and given and given.named_child_count == 1:
            return type_of_default(analysis, given.named_children[0], scope)
        return type_of_text(text)
    if node.type == "compound_literal_expression":
        made = node.child_by_field_name("type")
        return None if made is None else type_of_text(type_text(syntax.word(made)))
    if node.type in ("identifier", "qualified_identifier"):
        named = _NAMED_TYPE.fullmatch("".join(syntax.word(node).split()))
        if named is not None:
            found = _NAMED_TYPES.get(named["type"])
            return f"{found}_list" if found and named["list"] else found
    if node.type == "identifier":
        return type_of_text(analysis.receivers.type_of(node, scope))
    return None
