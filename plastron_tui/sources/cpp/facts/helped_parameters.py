"""Parameters that functions of Nav2 declare for a node.

Source: `nav2_util/node_utils.hpp` of Jazzy, `nav2_ros_common/lifecycle_node.hpp` of later ones.
"""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterUse
from plastron_tui.sources.cpp.analysis import Analysis, NodeSite
from plastron_tui.sources.cpp.arguments import Call
from plastron_tui.sources.cpp.parameter_details import type_of_text
from plastron_tui.sources.cpp.scopes import type_text

from .default_types import type_of_default

HELPERS = ("declare_or_get_parameter", "declare_parameter_if_not_declared")
"""What declares a parameter, of the node itself or of one that it gets before the name."""


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
