"""The clients of parameters that a class makes for its own node, and what is asked of them.

Source: `rclcpp/parameter_client.hpp` of Jazzy. An `AsyncParametersClient` is made of clients of
services of the node that it gets; a `SyncParametersClient` spins that node for each question.
"""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call, call_of
from plastron_tui.sources.cpp.scopes import Scope, Variable, last_name

ASYNC, SYNC = "rclcpp::AsyncParametersClient", "rclcpp::SyncParametersClient"

ASKING = frozenset(
    {
        "delete_parameters", "describe_parameters", "get_parameter_types", "get_parameters",
        "list_parameters", "load_parameters", "set_parameters", "set_parameters_atomically",
    }
)  # fmt: skip
"""What asks another node about its parameters."""

_ITSELF = re.compile(r"this|(?:this->)?shared_from_this\(\)")
_BASE = re.compile(r"(?:this->)?(?:shared_from_this\(\)->)?get_node_base_interface\(\)")
_GROUP, _GROUP_BEHIND_INTERFACES = 3, 6


def own_client(analysis: Analysis, call: Call, type_: str) -> Scope | None:
    """Return the class whose node a client of parameters belongs to, None where that is not sure.

    Args:
        analysis: the files.
        call: what is asked of the client.
        type_: what the client is, `ASYNC` or `SYNC`, in the group of callbacks of every node.
    """
    receiver, scope = call.receiver, call.scope
    if receiver is None or analysis.receivers.type_of(receiver, scope) != type_:
        return None
    name = last_name(receiver, scope)
    variable = analysis.unit.lookup(name, scope, receiver.start_byte) if name else None
    if variable is None or variable.is_list or variable.kind == "parameter":
        return None
    return _owner(analysis, variable, type_)


def is_of(analysis: Analysis, site: Site, owner: Scope) -> bool:
    """Tell whether a call site creates its endpoint on the node that an object of a class is."""
    if site.node is not None or site.owner is not None:
        return site.node is None and site.owner is owner
    # An action server may get the interfaces of the node instead.
    first, scope = site.call.argument(0), site.call.scope
    said = "" if first is None else "".join(scope.file.syntax.word(first).split())
    return _BASE.fullmatch(said) is not None and analysis.unit.class_of(scope) is owner


def _owner(analysis: Analysis, variable: Variable, type_: str) -> Scope | None:
    writes = analysis.unit.writes(variable)
    if len(writes) != 1:
        return None
    value, scope = writes[0].value, writes[0].scope
    given = writes[0].arguments
    if value is not None and value.type == "call_expression":
        made = call_of(value, scope, scope.file.syntax)
        if made is None or analysis.receivers.type_of(value, scope) != type_:
            return None
        given = made.arguments if made.name == "make_shared" else None
    owner = analysis.unit.class_of(scope)
    if not given or owner is None or not analysis.receivers.is_node_class(owner):
        return None
    return owner if _is_in_default_group(given, scope) else None


def _is_in_default_group(given: list[Node], scope: Scope) -> bool:
    """Tell whether a client gets the node around it, and no group of callbacks."""
    first = "".join(scope.file.syntax.word(given[0]).split())
    if _ITSELF.fullmatch(first):
        return len(given) <= _GROUP
    return _BASE.fullmatch(first) is not None and len(given) <= _GROUP_BEHIND_INTERFACES
