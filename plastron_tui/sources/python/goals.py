"""Sending a goal to an action from a file, once the action is there.

Source: `rclpy.action.ActionClient` of Jazzy, `actionlib.SimpleActionClient` of Noetic.
"""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import ActionClient
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind

from .addition import Addition
from .analysis import Site
from .calling import node_info, waiting_log
from .conventions import callback_naming, method_naming
from .messages import CannotAddError
from .repeating import timer_call
from .signatures import signatures_of
from .timer_functions import function_source, timer_variable, write_function
from .written_functions import AWAIT_RESULT, SEND_AND_WAIT, SEND_ASYNC, filled


def check_first(added: Addition, present: Sequence[Site]) -> None:
    """Refuse to send a goal beside those that a file sends: a server may end one for the other.

    Raises:
        CannotAddError: it is to be sent by hand.
    """
    if added.kind is EndpointKind.ACTION_CLIENT:
        line = present[0].endpoint.line
        message = f"the client of `{added.name}` in line {line} may be at work on another goal"
        remedy = "send the goal by hand where that client sends its own"
        raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span, remedy)


def add_goals(added: Addition, client: ActionClient) -> list[str]:
    """Send a goal, if there is one; return the lines that follow the client's creation."""
    if not client.goals:
        return []
    added.stand(is_nested=added.is_nested)
    interface = added.messages.interface(client.type, InterfaceKind.ACTION, client.name)
    goal = added.messages.goal(interface, client.goals[0])
    method = added.free_name(method_naming(added.analysis, "send").name(added.name))
    summary = f"Send a goal to {added.label} once it is there, and log what comes back."
    if added.is_rclpy:
        return _send_async(added, method, summary, goal)
    callback, lines = write_function(added, method, summary, _send_and_wait(added, goal))
    return [*lines, timer_call(added, "0.1", callback, method, ", oneshot=True")]


def _send_and_wait(added: Addition, goal: str) -> list[str]:
    is_outside = not added.is_nested
    client, scope = added.variable, added.place.scope
    return filled(
        SEND_AND_WAIT,
        client=client,
        goal=goal,
        status=added.imports.library("actionlib", "GoalStatus", scope),
        log_feedback=added.log("info", "feedback", in_callback=is_outside),
        log_state=added.log("info", "state", in_callback=is_outside),
        log_result=added.log("info", f"{client}.get_result()", in_callback=is_outside),
    )


def _send_async(added: Addition, method: str, summary: str, goal: str) -> list[str]:
    """Send a goal from a timer of rclpy, so that the node goes on while the server works."""
    timer, info, quote = timer_variable(added), node_info(added), added.writer.conventions.quote
    answer = added.free_name(callback_naming(added.analysis, added.kind).name(f"{added.name}_goal"))
    error = f"{info.removesuffix('info')}error"
    label = f"f{quote}{added.label}: "
    sending = filled(
        SEND_ASYNC,
        client=added.variable,
        goal=goal,
        timer=timer,
        log=waiting_log(added, "action"),
        log_feedback=f"{info}({label}{{message.feedback}}{quote})",
        answer=function_source(added, answer),
    )
    callback, lines = write_function(added, method, summary, sending)
    hearing = filled(
        AWAIT_RESULT,
        label=added.label,
        log_error=f"{error}({quote}{added.label}: the goal was rejected{quote})",
        log_result=f"{info}({label}{{done.result()}}{quote})",
    )
    type_ = ""
    if signatures_of(added.analysis, EndpointKind.TIMER).says_types:
        type_ = added.imports.use("rclpy.task", "Future")
    lines += write_function(added, answer, "", hearing, [("future", type_)])[1]
    return [*lines, f"{timer} = {timer_call(added, '0.1', callback, method)}"]
