"""Calling services from a file: once, or at a rate."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence

from plastron_tui.model.kinds import Client, Rate
from plastron_tui.ros.interfaces import InterfaceKind

from .addition import Addition
from .conventions import method_naming
from .loggers import own_logger
from .own_calls import call_in_own_method, keep_running
from .repeating import timer_call
from .timer_functions import start_timer, timer_variable, write_function


def add_calls(added: Addition, client: Client) -> list[str]:
    """Call a service with each request; return the lines that follow the client's creation."""
    if not client.requests:
        return []
    added.stand(is_nested=added.is_nested)
    interface = added.messages.interface(client.type, InterfaceKind.SERVICE, client.name)
    once: list[str] = []
    by_rate: dict[Rate, list[str]] = defaultdict(list)
    for each in client.requests:
        request = added.messages.request(interface, each.value)
        (once if each.rate is None else by_rate[each.rate]).append(request)
    if once and call_in_own_method(added, once):
        once = []
    if once or by_rate:
        keep_running(added)
    lines = _call_once(added, once) if once else []
    for rate, requests in by_rate.items():
        lines += _call_again(added, rate, requests)
    return lines


def _call_once(added: Addition, requests: Sequence[str]) -> list[str]:
    name = added.free_name(method_naming(added.analysis, "call").name(added.name))
    if added.is_rclpy:
        # From a timer, so that the node goes on while the service answers.
        timer = timer_variable(added)
        summary = f"Call {added.label} once it is there, and log its answer."
        body = [*_return_unless_there(added), f"{timer}.cancel()", *_call_async(added, requests)]
        callback, lines = write_function(added, name, summary, body)
        return [*lines, f"{timer} = {timer_call(added, '0.1', callback, name)}"]
    summary = f"Call {added.label} within 10 s, and log its answer."
    wait = [f"{added.variable}.wait_for_service(timeout=10.0)"]
    callback, lines = write_function(added, name, summary, _tried(added, requests, wait))
    return [*lines, timer_call(added, "0.1", callback, name, ", oneshot=True")]


def _call_again(added: Addition, rate: Rate, requests: Sequence[str]) -> list[str]:
    name = added.free_name(method_naming(added.analysis, "call").name(added.name))
    summary = f"Call {added.label} if it is there, and log its answer."
    if added.is_rclpy:
        body = [*_return_unless_there(added), *_call_async(added, requests)]
    else:
        body = _tried(added, requests)
    callback, lines = write_function(added, name, summary, body)
    return [*lines, *start_timer(added, rate, callback, name)]


def _tried(added: Addition, requests: Sequence[str], first: Sequence[str] = ()) -> list[str]:
    """Return the lines of rospy that call a service, or log why they cannot."""
    is_outside = not added.is_nested
    errors = [
        added.rospy(error, in_callback=is_outside) for error in ("ROSException", "ServiceException")
    ]
    body = ["try:", *("\t" + line for line in first)]
    for request in requests:
        body.append(f"\tresponse = {added.variable}({request})")
        body.append("\t" + added.log("info", "response", in_callback=is_outside))
    body.append(f"except ({', '.join(errors)}) as error:")
    return [*body, "\t" + added.log("error", "error", in_callback=is_outside)]


def _return_unless_there(added: Addition) -> list[str]:
    """Return the lines of rclpy that leave a function while a service is not there."""
    # A call that waits would hold up all else that the node does.
    return [
        f"if not {added.variable}.service_is_ready():",
        f"\t{waiting_log(added, 'service')}",
        "\treturn",
    ]


def waiting_log(added: Addition, what: str) -> str:
    """Return the statement of rclpy that logs, now and then, that nobody serves something yet."""
    quote = added.writer.conventions.quote
    text = f"{quote}{added.label}: waiting for the {what}{quote}"
    return f"{node_info(added)}({text}, throttle_duration_sec=10.0)"


def _call_async(added: Addition, requests: Sequence[str]) -> list[str]:
    """Return the lines of rclpy that call a service, and log the answer when it comes."""
    quote = added.writer.conventions.quote
    logs = f"{node_info(added)}(f{quote}{added.label}: {{done.result()}}{quote})"
    body = []
    for request in requests:
        body.append(f"future = {added.variable}.call_async({request})")
        body.append(f"future.add_done_callback(lambda done: {logs})")
    return body


def node_info(added: Addition) -> str:
    """Return what logs for a node of rclpy: the file's own logger, where it is the node's."""
    own = own_logger(added.analysis, added.place, "info")
    holder = re.escape(own.rpartition(".")[0])
    is_of_node = re.search(
        rf"^[ \t]*{holder}(:[^=\n]*)? *= *[\w.]+\.get_logger\(\)[ \t\r]*$".encode(),
        added.analysis.syntax.text,
        re.M,
    )
    receiver = added.receiver_in_callback() or added.place.receiver
    return own if own and is_of_node else f"{receiver}.get_logger().info"
