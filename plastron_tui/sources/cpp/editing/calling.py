"""Calling services from files that exist: once, or at a rate, while the node goes on.

In ROS 2 the answer is logged when it comes. A call of ROS 1 waits: a timer of a thread of its own
makes it.
"""

from __future__ import annotations

from collections import defaultdict

from plastron_tui.model.kinds import Client, Rate, Request
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from ..guarded import Conditions
from .adding import Addition
from .computing import computing_for
from .logging import log_line
from .manner import Naming, variable_naming
from .members import declare
from .place import node_in_methods
from .sending import Sender
from .timers import capture, duration_of, node_captures, period_of, run_at, timer_name

_SOON = 10.0
"""How often a node looks whether a service or an action is there, in hertz."""


def add_requests(added: Addition, client: Client, sender: Sender, type_: InterfaceName) -> None:
    """Call a service with each request."""
    once: list[Request] = []
    by_rate: dict[Rate, list[Request]] = defaultdict(list)
    for each in client.requests:
        (once.append if each.rate is None else by_rate[each.rate].append)(each)
    if not client.requests:
        return
    handle = "" if added.is_ros2 else _own_thread(added)
    if once:
        _call(added, sender, type_, once, None, handle)
    for rate, requests in by_rate.items():
        _call(added, sender, type_, requests, rate, handle)


def _call(
    added: Addition,
    sender: Sender,
    type_: InterfaceName,
    requests: list[Request],
    rate: Rate | None,
    handle: str,
) -> None:
    period = period_of(added, _SOON if rate is None else rate)
    # A timer asks its queue when it goes, so it has to go before the queue.
    timer = timer_name(added, added.topic, last=bool(handle))
    body = []
    if added.is_ros2:
        body += waits(added, f"{sender.call}service_is_ready()", "service")
        if rate is None:
            body.append(f"{timer}->cancel();")
    for at, each in enumerate(requests):
        number = "" if not at else f"_{at + 1}"
        if added.is_ros2:
            body += _ask_in_ros2(added, sender, type_, each, number)
        else:
            body += _ask_in_ros1(added, sender, type_, each, number, rate is None)
    own = capture(added, sender.variable, is_pointer=added.is_ros2)
    taken = (*node_captures(added), own)
    if added.is_ros2 and rate is None:
        # The timer is there once it was created, and holds the lambda itself.
        taken = (*taken, f"&{timer}")
    run_at(
        added,
        added.topic,
        "call",
        period,
        body,
        timer=timer,
        captures=taken,
        handle=handle,
        once=rate is None and not added.is_ros2,
    )


def waits(added: Addition, is_there: str, what: str) -> list[str]:
    """Return the lines that leave a function while nobody serves what it needs."""
    said = log_line(added, f"{added.prose}: waiting for the {what}", "")
    head, _, rest = said.partition("(")
    if added.is_ros2:
        logger, text = rest.rsplit(', "', 1)
        node = node_in_methods(added.analysis, added.place)
        throttled = f'{head}_THROTTLE({logger}, *{node}get_clock(), 10000, "{text}'
        # There is no clock without a node.
        said = throttled if node is not None else f"{head}_ONCE({rest}"
    else:
        said = f"{head}_THROTTLE(10, {rest}"
    return added.style(added.place.file).block(f"if (!{is_there})", [said, "return;"])


def _ask_in_ros2(
    added: Addition, sender: Sender, type_: InterfaceName, request: Request, number: str
) -> list[str]:
    interface = added.interfaces.find(type_, InterfaceKind.SERVICE, added.span)
    class_ = added.interfaces.class_of(interface.name, InterfaceKind.SERVICE)
    computing, conditions = computing_for(added, added.span)
    name = f"request{number}"
    lines = [f"auto {name} = std::make_shared<{class_}::Request>();"]
    lines += added.interfaces.fill(
        interface, interface.fields, request.value, f"{name}->", computing, added.span
    )
    log = log_line(added, added.prose, "to_yaml(*future.get())")
    taken = "this" if added.owner is not None else ", ".join(node_captures(added))
    if added.owner is None and added.place.node not in log:
        taken = ""
    lines += [
        f"{sender.call}async_send_request(",
        f"\v{name}, [{taken}](rclcpp::Client<{class_}>::SharedFuture future) {{",
        f"\v\t{log}",
        "\v});",
    ]
    return _guarded(added, conditions, lines)


def _ask_in_ros1(
    added: Addition, sender: Sender, type_: InterfaceName, request: Request, number: str, once: bool
) -> list[str]:
    interface = added.interfaces.find(type_, InterfaceKind.SERVICE, added.span)
    class_ = added.interfaces.class_of(interface.name, InterfaceKind.SERVICE)
    computing, conditions = computing_for(added, added.span)
    name = f"call{number}"
    lines = [f"{class_} {name};"]
    lines += added.interfaces.fill(
        interface, interface.fields, request.value, f"{name}.request.", computing, added.span
    )
    style = added.style(added.place.file)
    wait = f"{sender.call}waitForExistence(ros::Duration(10.0)) && " if once else ""
    asks = style.block(
        f"if ({wait}{sender.call}call({name}))",
        [log_line(added, added.prose, f"{name}.response")],
    )
    fails = [log_line(added, f"{added.prose}: there was no answer", "", level="ERROR")]
    if style.is_control_broken:
        lines += [*asks, *style.block("else", fails)]
    else:
        lines += [*asks[:-1], *style.block("} else", fails)]
    return _guarded(added, conditions, lines)


def _guarded(added: Addition, conditions: Conditions, lines: list[str]) -> list[str]:
    if not conditions:
        return lines
    return added.style(added.place.file).block(f"if ({conditions.text})", lines)


def _own_thread(added: Addition) -> str:
    """Declare the thread of ROS 1 that makes calls, and return the handle of its timers.

    What is declared last goes first: the thread has ended before its queue goes.
    """
    is_member = added.owner is not None
    like = variable_naming(added.analysis, EndpointKind.TIMER, added.sites, is_member=is_member)
    queue, spinner, handle = (
        added.free(Naming(like.casing, "", part, like.start, like.end).name(added.topic), like.end)
        for part in ("queue", "spinner", "nh")
    )
    file = added.place.file
    if not is_member:
        # None of them can be there before `ros::init`.
        kept = duration_of(added)
        added.lines.append(f"{kept}ros::CallbackQueue {queue};")
        added.lines.append(f"{kept}ros::AsyncSpinner {spinner}(1, &{queue});")
        added.lines.append(f"{kept}ros::NodeHandle {handle};")
    else:
        declare(added, f"ros::CallbackQueue {queue};")
        declare(added, f"ros::AsyncSpinner {spinner}{{1, &{queue}}};")
        file = declare(added, f"ros::NodeHandle {handle};")
    added.include(file, "ros/callback_queue.h")
    added.lines.append(f"{handle}.setCallbackQueue(&{queue});")
    added.lines.append(f"{spinner}.start();")
    return f"{handle}."
