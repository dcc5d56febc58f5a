"""Whether a node of a file goes on, and hears what comes, once it has started."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import EndpointKind

from .analysis import Analysis
from .own_loop import is_endless, sleeps_by_spinning

# rclpy calls nothing unless something spins: a function, an executor, or a navigator's methods.
_SPINNING = re.compile(r"spin|executor|add_node|navigator", re.IGNORECASE)
# These spin for a while, so that they have to be in a loop.
_BRIEF = frozenset({"spin_once", "spin_until_future_complete"})
# rospy calls in threads of its own, for as long as the main thread does anything.
_STAYING = re.compile(
    r"spin|shutdown|sleep|wait(?!_for_(service|message|server|transform))|loop|exec_?$|show|run"
    r"|start|join|serve|input|pause|listen|main",
    re.IGNORECASE,
)
_CALLED = (
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.TIMER,
    EndpointKind.ACTION_SERVER,
)


def never_called(before: Analysis, after: Analysis) -> Diagnostic | None:
    """Return what is wrong with callbacks of a changed file, None where they are called.

    A file that starts ROS itself has to spin, or to stay. One that had callbacks before is taken
    to know how.
    """
    if any(site.endpoint.kind in _CALLED for site in before.sites) or not _starts(after):
        return None
    callback = next((s.endpoint.callback for s in after.sites if s.endpoint.kind in _CALLED), None)
    # What is new may wait in a callback, and may spin.
    names = {*_called(before), *(name for name in _called(after) if name.startswith("spin"))}
    if callback is None:
        return None
    if any(
        body is not None and sleeps_by_spinning(before, body)
        for loop in before.captures.get("while", [])
        for body in [loop.child_by_field_name("body")]
    ):
        message = "the loop of the file sleeps until `spin_once` calls its rate: if that calls"
        message += f" `{callback}` instead, it sleeps for ever"
        remedy = "let the node spin in a thread of its own first"
        return Diagnostic(codes.EDIT_REFUSED, message, help=remedy)
    if after.library.node_classes:
        spinning = {name for name in names if _SPINNING.search(name)}
        runs = bool(spinning - _BRIEF) or (bool(spinning) and _is_repeated(before))
        what, remedy = "does not keep spinning", "let the node spin first, with `rclpy.spin(node)`"
    else:
        has_loop = before.captures.get("while") or before.captures.get("loop")
        # What a function of the file does is in the file as well.
        foreign = names - {each.name for each in before.scopes.all if each.kind == "function"}
        runs = bool(has_loop) or any(_STAYING.search(name) for name in foreign)
        what, remedy = "ends at once", "let the node go on first, with `rospy.spin()`"
    if runs:
        return None
    message = f"the file {what}, so that `{callback}` would not be called"
    return Diagnostic(codes.EDIT_REFUSED, message, help=remedy)


def _is_repeated(analysis: Analysis) -> bool:
    """Whether a file has a loop that may go on, or one around what spins for a while."""
    loops = [*analysis.captures.get("while", []), *analysis.captures.get("loop", [])]
    return any(
        is_endless(analysis, loop) or any(each in analysis.syntax.slice(loop) for each in _BRIEF)
        for loop in loops
    )


def _called(analysis: Analysis) -> list[str]:
    """Return the names of the functions and classes that a file calls."""
    names = map(analysis.syntax.called_name, analysis.captures.get("call", []))
    return [name for name in names if name]


def _starts(analysis: Analysis) -> bool:
    """Whether a file starts ROS, rather than being a part of what another one starts."""
    start = "rclpy.init" if analysis.library.node_classes else "rospy.init_node"
    for call in analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        scope = analysis.scopes.at(call.start_byte)
        if start in analysis.resolver.qualified(callee, scope):
            return True
    return False
