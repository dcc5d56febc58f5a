"""The functions that an action server or client has called, besides its callback.

Sources: `actionlib/server/simple_action_server.h`, `actionlib/client/simple_action_client.h` of
Noetic; `rclcpp_action/create_server.hpp`, `rclcpp_action/client.hpp` of Jazzy.
"""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ActionDetails
from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .callbacks import callback_of
from .holders import holder_of
from .scopes import Scope, last_name

_OPTIONS = {
    "goal_response_callback": "accepted",
    "feedback_callback": "feedback",
    "result_callback": "result",
}


def action_details(analysis: Analysis, site: Site) -> ActionDetails:
    """Return the functions of the action of a call site."""
    is_server = site.endpoint.kind is EndpointKind.ACTION_SERVER
    if analysis.ros_version == 2:
        return _server2(analysis, site) if is_server else _client2(analysis, site)
    return _server1(analysis, site) if is_server else _client1(analysis, site)


def _name(analysis: Analysis, node: Node | None, scope: Scope) -> str | None:
    return callback_of(analysis.unit, node, scope).name


def _server2(analysis: Analysis, site: Site) -> ActionDetails:
    given = [*site.arguments, None, None, None, None]
    goal, cancel, accepted = (_name(analysis, each, site.place) for each in given[1:4])
    return ActionDetails(goal=goal, accepted=accepted, cancel=cancel)


def _client2(analysis: Analysis, site: Site) -> ActionDetails:
    """Return what the options for goals say, where there is one client that they may be for."""
    kinds = [each for each in analysis.sites if each.endpoint.kind is site.endpoint.kind]
    found: dict[str, str | None] = {}
    if len(kinds) == 1:
        for node, scope in (pair for file in analysis.unit.files for pair in file.assignments):
            left = node.child_by_field_name("left")
            field = _OPTIONS.get(last_name(left, scope)) if left is not None else None
            if field is not None and left is not None and left.type == "field_expression":
                name = _name(analysis, node.child_by_field_name("right"), scope)
                found[field] = name if found.get(field, name) == name else None
    return ActionDetails(**found)


def _held(analysis: Analysis, site: Site) -> str:
    """Return the name of the variable that has what a call site makes, "" for none."""
    variable = holder_of(analysis, site)
    return variable.name if variable is not None else ""


def _called_on(analysis: Analysis, name: str, method: str, position: int) -> str | None:
    found = {
        _name(analysis, call.argument(position), call.scope)
        for call in analysis.unit.calls.get(method, ())
        if call.receiver is not None and last_name(call.receiver, call.scope) == name
    }
    return found.pop() if len(found) == 1 else None


def _server1(analysis: Analysis, site: Site) -> ActionDetails:
    name = _held(analysis, site)
    if not name:
        return ActionDetails()
    return ActionDetails(
        goal=_called_on(analysis, name, "registerGoalCallback", 0),
        cancel=_called_on(analysis, name, "registerPreemptCallback", 0),
    )


def _client1(analysis: Analysis, site: Site) -> ActionDetails:
    name = _held(analysis, site)
    if not name:
        return ActionDetails()
    return ActionDetails(
        accepted=_called_on(analysis, name, "sendGoal", 2),
        feedback=_called_on(analysis, name, "sendGoal", 3),
        result=_called_on(analysis, name, "sendGoal", 1),
    )
