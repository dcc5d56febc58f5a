"""When the timers of a file tick.

Source: `rospy.timer`, `genpy.rostime` of Noetic, `rclpy.duration`, `rclpy.node` of Jazzy.
"""

from __future__ import annotations

import math

from tree_sitter import Node

from plastron_tui.model.endpoint_details import TimerDetails
from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .arguments import Arguments
from .calls import Argument
from .conventions import target_name
from .evaluated import UNKNOWN, Evaluated
from .evaluation import Evaluator
from .references import statement_of
from .scopes import Scope

_ONESHOT = Argument(2, "oneshot")
_DESTROYED = Argument(0, "timer")
_SECONDS = {
    "rospy.Duration": (Argument(0, "secs"), Argument(1, "nsecs")),
    "rospy.rostime.Duration": (Argument(0, "secs"), Argument(1, "nsecs")),
    "genpy.Duration": (Argument(0, "secs"), Argument(1, "nsecs")),
    "rclpy.duration.Duration": (Argument(-1, "seconds"), Argument(-1, "nanoseconds")),
}
_RATES = frozenset({"rospy.Rate", "rospy.timer.Rate"})
_FROM_SECONDS = frozenset(f"{name}.from_sec" for name in _SECONDS)


def is_wait(analysis: Analysis, site: Site) -> bool:
    """Whether a call site makes a timer that its function also destroys: that only waits.

    The function destroys it later in the block that makes it, or in a `finally`; one that makes a
    timer anew destroys the old one before.
    """
    if site.endpoint.kind is not EndpointKind.TIMER or analysis.library.ros_version == 1:
        return False
    name = target_name(analysis, site)
    function = site.scope.enclosing("function")
    if name is None or function is None:
        return False
    block = statement_of(site.call).parent
    for call in analysis.captures.get("call", []):
        if not site.call.end_byte <= call.start_byte < function.end:
            continue
        given = Arguments.of(call, analysis.syntax).get(_DESTROYED)
        is_it = given is not None and analysis.syntax.slice(given) == name
        if is_it and analysis.syntax.called_name(call) == "destroy_timer":
            place = statement_of(call).parent
            if place == block or _is_final(place):
                return True
    return False


def _is_final(block: Node | None) -> bool:
    return block is not None and block.parent is not None and block.parent.type == "finally_clause"


def timer_details(analysis: Analysis, site: Site, evaluator: Evaluator) -> TimerDetails:
    """Return when the timer of a call site ticks."""
    given = site.arguments.get(site.shape.name)
    period = _seconds(analysis, given, site.scope, evaluator)
    seconds = period.number
    is_known = seconds is not None and math.isfinite(seconds) and seconds >= 0
    is_rospy = analysis.library.ros_version == 1
    once = site.arguments.get(_ONESHOT) if is_rospy else None
    return TimerDetails(
        period=seconds if is_known else None,
        is_oneshot=evaluator.evaluate(once, site.scope).value is True,
        is_guess=is_known and period.is_guess,
    )


def _seconds(
    analysis: Analysis, node: Node | None, scope: Scope, evaluator: Evaluator
) -> Evaluated:
    """Return a number of seconds, or those of a duration."""
    held = evaluator.resolved(node, scope)
    if held is None and node is not None and node.type == "attribute":
        return _slept(analysis, node, scope, evaluator)
    if held is not None and held.node.type == "call":
        callee = held.node.child_by_field_name("function")
        arguments = Arguments.of(held.node, analysis.syntax)
        for name in analysis.resolver.qualified(callee, held.scope):
            if name in _FROM_SECONDS:
                return evaluator.evaluate(arguments.get(Argument(0, "float_secs")), held.scope)
            if name in _SECONDS and not arguments.is_open:
                parts = [arguments.get(each) for each in _SECONDS[name]]
                return _sum(*(_part(each, held.scope, evaluator) for each in parts))
    return evaluator.evaluate(node, scope)


def _slept(analysis: Analysis, node: Node, scope: Scope, evaluator: Evaluator) -> Evaluated:
    """Return the seconds of `rospy.Rate(10).sleep_dur`, and of any other attribute."""
    name = node.child_by_field_name("attribute")
    made = evaluator.resolved(node.child_by_field_name("object"), scope)
    is_slept = name is not None and analysis.syntax.slice(name) == "sleep_dur"
    if not is_slept or made is None or made.node.type != "call":
        return evaluator.evaluate(node, scope)
    callee = made.node.child_by_field_name("function")
    if _RATES.isdisjoint(analysis.resolver.qualified(callee, made.scope)):
        return UNKNOWN
    given = Arguments.of(made.node, analysis.syntax).get(Argument(0, "hz"))
    rate = evaluator.evaluate(given, made.scope)
    return Evaluated("float", 1 / rate.number, rate.is_guess) if rate.number else UNKNOWN


def _part(node: Node | None, scope: Scope, evaluator: Evaluator) -> Evaluated:
    return evaluator.evaluate(node, scope) if node is not None else Evaluated("int", 0)


def _sum(seconds: Evaluated, nanoseconds: Evaluated) -> Evaluated:
    whole, rest = seconds.number, nanoseconds.number
    if whole is None or rest is None:
        return UNKNOWN
    return Evaluated("float", whole + rest / 1e9, seconds.is_guess or nanoseconds.is_guess)
