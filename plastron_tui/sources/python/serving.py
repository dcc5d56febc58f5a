"""Providing an action from a file: what works on its goals, one after the other.

A cancel is accepted and ends a goal early, and so does a new goal.

Source: `rclpy.action.ActionServer` of Jazzy, `actionlib.SimpleActionServer` of Noetic.
"""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import codes
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import Interface

from .addition import Addition
from .conventions import method_naming
from .function_place import FunctionPlace
from .messages import CannotAddError
from .signatures import Signatures, signatures_of
from .written_functions import ACCEPT_CANCEL, EXECUTE, EXECUTE_ASYNC, SLEEP, filled, is_one_of


class Serving(NamedTuple):
    """What is written around the call that makes an action server.

    Attributes:
        callback: the source of the function that works on a goal.
        more: keywords of the call, with what they are.
        above: the lines above the call.
        below: the lines below it.
    """

    callback: str
    more: tuple[tuple[str, str], ...] = ()
    above: tuple[str, ...] = ()
    below: tuple[str, ...] = ()


def serve_with(added: Addition, callback: str) -> Serving:
    """Let a function of the file work on the goals of an action."""
    if added.is_rclpy:
        return Serving(callback)
    # A server that starts by itself may get a goal before anything holds it.
    return Serving(callback, (("auto_start", "False"),), below=(f"{added.variable}.start()",))


def serve(
    added: Addition, interface: Interface, wanted: str | None, place: FunctionPlace
) -> Serving:
    """Write the function that works on the goals of an action, and what that needs.

    Args:
        added: the action server; its variable is known.
        interface: the action.
        wanted: the function's name, None for one of the edit's own.
        place: where the functions go.

    Raises:
        CannotAddError: nothing that the function sees holds the server.
    """
    is_method = added.is_method_place and "." in added.variable
    if not is_method and (added.is_rclpy or added.place.scope.parent is not None):
        what = "a class that is a node" if added.is_rclpy else "a class, or outside of functions"
        raise CannotAddError(
            codes.EDIT_REFUSED,
            f"what works on the goals of `{added.name}` is only written into {what}",
            added.endpoint.span,
            "write it by hand, and name it with `calling`",
        )
    name = wanted or added.free_name(method_naming(added.analysis, "execute").name(added.name))
    added.writer.names.add(name)
    added.stand(is_nested=False)
    manner = signatures_of(added.analysis, EndpointKind.ACTION_SERVER)
    write = _execute_async if added.is_rclpy else _execute
    serving = write(added, interface, name, manner, place)
    added.stand(is_nested=True)
    return serving


def _execute(
    added: Addition, interface: Interface, name: str, manner: Signatures, place: FunctionPlace
) -> Serving:
    """Write what works on a goal in a thread of its own, as actionlib has it."""
    body = filled(
        EXECUTE,
        log=added.log("info", "goal"),
        server=added.variable,
        feedback=f"{added.messages.part(interface, 'Feedback')}()",
        pause=added.rospy("sleep", in_callback=True),
        result=f"{added.messages.part(interface, 'Result')}()",
    )
    type_ = added.messages.part(interface, "Goal") if manner.says_types else ""
    own = [(added.place.self_name, "")] if added.place.owner is not None else []
    head = manner.head(name, [*own, ("goal", type_)], "None")
    added.writer.function(place, _documented(added, manner, head, body))
    return serve_with(added, f"{added.place.self_name}.{name}" if own else name)


def _execute_async(
    added: Addition, interface: Interface, name: str, manner: Signatures, place: FunctionPlace
) -> Serving:
    """Write what works on a goal and awaits: the node goes on, however it spins."""
    self_name, use = added.place.self_name, added.imports.use
    wanted = f"{added.variable.rpartition('.')[2].removesuffix('_server')}_goal"
    goal = f"{self_name}.{added.free_name(wanted)}"
    node = added.receiver_in_callback()
    accept, is_accepting = _helper(added, "accept_cancel", ACCEPT_CANCEL)
    sleep, is_sleeping = _helper(added, "sleep", SLEEP)
    result = added.messages.part(interface, "Result")
    body = filled(
        EXECUTE_ASYNC,
        log=added.log("info", "goal_handle.request"),
        goal=goal,
        result=f"{result}()",
        feedback=f"{added.messages.part(interface, 'Feedback')}()",
        sleep=f"{self_name}.{sleep}",
    )
    handle = use("rclpy.action.server", "ServerGoalHandle") if manner.says_types else ""
    takes = [(self_name, ""), ("goal_handle", handle)]
    head = f"async {manner.head(name, takes, result)}"
    added.writer.function(place, _documented(added, manner, head, body))
    if not is_accepting:
        response = use("rclpy.action", "CancelResponse")
        body = filled(ACCEPT_CANCEL, cancel_response=response)
        added.writer.function(place, _indented(manner.head(accept, takes, response), body))
    if not is_sleeping:
        head = manner.head(sleep, [(self_name, ""), ("seconds", "float")], "None")
        body = filled(SLEEP, future=use("rclpy.task", "Future"), node=node)
        added.writer.function(place, _indented(f"async {head}", body))
        added.writer.endpoints.append((EndpointKind.TIMER, "seconds", "None", ""))
    return Serving(
        f"{self_name}.{name}",
        more=(("cancel_callback", f"{self_name}.{accept}"),),
        above=(f"{goal} = None",),
    )


def _helper(added: Addition, wanted: str, function: tuple[str, ...]) -> tuple[str, bool]:
    """Return the name of a method, and whether the class has it already."""
    for scope in added.analysis.scopes.all:
        is_method = scope.kind == "function" and scope.parent is added.place.owner
        if is_method and is_one_of(added.analysis, scope, (function,)):
            return scope.name, True
    return added.free_name(wanted), False


def _documented(added: Addition, manner: Signatures, head: str, body: list[str]) -> list[str]:
    summary = f"Work on a goal of {added.label}; a cancel ends it early, and so does a new goal."
    return _indented(head, [f'"""{summary}"""', *body] if manner.is_documented else body)


def _indented(head: str, body: list[str]) -> list[str]:
    return [head, *("\t" + line for line in body)]
