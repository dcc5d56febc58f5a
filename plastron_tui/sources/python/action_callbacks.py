"""The functions that action servers and clients have called, besides the one of their call.

Source: `rclpy.action` of Jazzy, `actionlib` of Noetic.
"""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ActionDetails

from .analysis import Analysis, Site
from .arguments import Arguments
from .callbacks import callback_name
from .calls import Argument
from .references import Use, references, variable_of
from .scopes import Scope

_GIVEN = {
    "rclpy.action.ActionServer": {
        "goal": Argument(-1, "goal_callback"),
        "accepted": Argument(-1, "handle_accepted_callback"),
        "cancel": Argument(-1, "cancel_callback"),
    },
    "actionlib.ActionServer": {"cancel": Argument(3, "cancel_cb")},
}
"""The arguments of what makes one, by the first name of its shape."""

_MOST_USES = 64
_CALLED = {
    "rclpy": {
        "register_goal_callback": {"goal": Argument(0, "goal_callback")},
        "register_handle_accepted_callback": {"accepted": Argument(0, "handle_accepted_callback")},
        "register_cancel_callback": {"cancel": Argument(0, "cancel_callback")},
        "send_goal_async": {"feedback": Argument(1, "feedback_callback")},
        "send_goal": {"feedback": Argument(-1, "feedback_callback")},
    },
    "rospy": {
        "register_goal_callback": {"goal": Argument(0, "cb")},
        "register_preempt_callback": {"cancel": Argument(0, "cb")},
        "send_goal": {
            "result": Argument(1, "done_cb"),
            "accepted": Argument(2, "active_cb"),
            "feedback": Argument(3, "feedback_cb"),
        },
    },
}
"""The arguments of the methods that are called on one."""


def action_details(analysis: Analysis, site: Site, with_uses: bool) -> ActionDetails:
    """Return the functions that the action server or client of a call site has called.

    Args:
        analysis: the file.
        site: the call site.
        with_uses: whether to look at what is done with it as well.
    """
    found: dict[str, set[str]] = {}
    made = _GIVEN.get(site.shape.callees[0], {})
    given = [(site.arguments, made, site.scope)]
    if with_uses:
        given += _calls_on(analysis, site)
    for arguments, named, scope in given:
        for what, argument in named.items():
            name = callback_name(analysis, arguments.get(argument), scope)
            if name is not None:
                found.setdefault(what, set()).add(name)
    # Where each goal has another function, no single one is the endpoint's.
    return ActionDetails(**{what: names.pop() for what, names in found.items() if len(names) == 1})


def _calls_on(
    analysis: Analysis, site: Site
) -> Iterator[tuple[Arguments, dict[str, Argument], Scope]]:
    """Yield the calls of methods of what a call site makes that take functions."""
    parent = site.call.parent
    target = parent.child_by_field_name("left") if parent and parent.type == "assignment" else None
    variable = variable_of(target, analysis) if target is not None else None
    methods = _CALLED[analysis.library.module]
    for reference in references(variable, analysis)[:_MOST_USES] if variable is not None else ():
        call = _method_call(reference.node) if reference.use is Use.OTHER else None
        named = methods.get(analysis.syntax.called_name(call)) if call is not None else None
        if call is not None and named is not None:
            scope = analysis.scopes.at(call.start_byte)
            yield Arguments.of(call, analysis.syntax), named, scope


def _method_call(node: Node) -> Node | None:
    """Return the call of a method of an object."""
    attribute = node.parent
    call = attribute.parent if attribute is not None and attribute.type == "attribute" else None
    is_callee = call is not None and call.child_by_field_name("function") == attribute
    return call if call is not None and call.type == "call" and is_callee else None
