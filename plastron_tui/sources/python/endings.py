"""What ends an endpoint or a timer, and is of no use when that is gone."""

from __future__ import annotations

from tree_sitter import Node

from .analysis import Analysis, Site
from .functions import callback_scope
from .references import Reference, Use, references, variable_of
from .syntax import parts_of

# What ends an endpoint: its own methods, and those of an rclpy node.
_ENDING = frozenset({"destroy", "shutdown", "unregister"})
_DESTROYING = frozenset(
    {"destroy_client", "destroy_publisher", "destroy_service", "destroy_subscription"}
    | {"destroy_lifecycle_publisher", "destroy_timer"}
)


def ends_endpoint(analysis: Analysis, reference: Reference) -> bool:
    """Whether a statement does nothing but end an endpoint, which is no more."""
    parent = reference.node.parent
    call = reference.statement.named_children[0] if reference.statement.named_children else None
    if parent is None or call is None or call.type != "call" or len(parts_of(call.parent)) != 1:
        return False
    callee, arguments = (call.child_by_field_name(each) for each in ("function", "arguments"))
    name = callee.child_by_field_name("attribute") if callee is not None else None
    if callee is None or arguments is None or name is None:
        return False
    ending = analysis.syntax.slice(name)
    if parent.id == callee.id:
        return ending in _ENDING and not parts_of(arguments)
    return ending in _DESTROYING and [part.id for part in parts_of(arguments)] == [
        reference.node.id
    ]


def destroying(analysis: Analysis, timer: Site) -> list[Node] | None:
    """Return the statements that destroy a timer, None where something else is done with it."""
    parent = timer.call.parent
    if parent is not None and parent.type == "expression_statement":
        return []
    target = parent.child_by_field_name("left") if parent and parent.type == "assignment" else None
    variable = variable_of(target, analysis) if target is not None else None
    if variable is None:
        return None
    uses = references(variable, analysis)
    uses = [each for each in uses if each.use not in (Use.BINDING, Use.NOTHING)]
    function = callback_scope(analysis, timer)
    outside = [
        each
        for each in uses
        if function is None or not analysis.scopes.at(each.node.start_byte).is_within(function)
    ]
    is_ended = all(ends_endpoint(analysis, each) for each in outside)
    return [each.statement for each in outside] if is_ended else None
