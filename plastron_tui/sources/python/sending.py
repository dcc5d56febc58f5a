"""Publishing messages and calling services from a file, in its own loop or timer if it has one."""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Client, Publication, Publisher, Rate
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind

from . import naming
from .addition import Addition
from .conventions import leading_space, method_naming, variable_naming
from .function_place import function_place, method_place
from .lifecycle import is_transition
from .loggers import own_logger
from .own_calls import call_in_own_method, keep_running
from .own_loop import is_sleep, own_block, statements_of, woken_loop
from .removal import callback_scope
from .repeating import period_of
from .sending_once import PERIOD, when_heard
from .signatures import parameter_names, signatures_of
from .splices import line_end, line_start
from .surroundings import holds_handles


def add_publishing(added: Addition, publisher: Publisher) -> list[str]:
    """Publish a publisher's messages; return the lines that follow its creation."""
    if not publisher.publications:
        return []
    unasked = [each for each in publisher.publications if each.reaction is None]
    once = [each for each in unasked if each.is_once]
    again = [each for each in unasked if not each.is_once]
    return [*_again(added, again), *_once(added, once)]


def _once(added: Addition, publications: Sequence[Publication]) -> list[str]:
    """Return the lines that send some messages once, behind the publisher's creation."""
    if not publications:
        return []
    added.stand(is_nested=added.is_nested)
    lines = []
    for each in publications:
        lines += sending(added, each, f"{naming.words(added.name)}_message", False)
    if not added.is_rclpy:
        return lines
    holder, dot, _ = added.variable.rpartition(".")
    timer = _timer_variable(added)
    bare = timer.rpartition(".")[2].removesuffix("_timer").removesuffix("_")
    heard = f"{holder}{dot}{added.free_name(f'{bare}_is_heard')}"
    name = added.free_name(method_naming(added.analysis, "publish").name(added.name))
    summary = f"Publish to {added.label}, once: when somebody listens."
    callback, above = _function(added, name, summary, when_heard(added, heard, timer, lines))
    added.writer.endpoints.append((EndpointKind.TIMER, PERIOD, "None", name))
    return [f"{heard} = False", *above, f"{timer} = {_timer_call(added, PERIOD, callback)})"]


def _again(added: Addition, sent: Sequence[Publication]) -> list[str]:
    """Publish some messages again and again; return the lines that follow the creation."""
    if not sent:
        return []
    block = own_block(added)
    fitting: list[Publication] = []
    by_rate: dict[Rate, list[Publication]] = defaultdict(list)
    for publication in sent:
        is_fitting = block is not None and _fits(publication, block.rate)
        rate = Rate(publication.rate, publication.parameter)
        (fitting if is_fitting else by_rate[rate]).append(publication)
    if block is not None and fitting:
        scope = added.analysis.scopes.at(block.body.start_byte)
        added.stand(is_nested=scope.is_within(added.place.scope))
        _publish_in(added, block.body, fitting)
    if by_rate:
        added.stand(is_nested=added.is_nested)
    lines: list[str] = []
    for rate, publications in by_rate.items():
        lines += _timer(added, rate, publications)
    if by_rate and (loop := woken_loop(added)) is not None:
        added.writer.notes.append(_wakes(added, int(loop.start_point.row) + 1))
    return lines


def _wakes(added: Addition, line: int) -> Diagnostic:
    """Return the warning that a timer lets a loop run more often."""
    message = f"the loop in line {line} goes on whenever something comes: with the timer that sends"
    message += f" `{added.name}` it runs more often than before"
    help_ = "let the loop sleep at a rate, or spin in a thread of its own"
    return Diagnostic(codes.WAKES_LOOP, message, added.endpoint.span, help=help_)


def _fits(publication: Publication, own_rate: float | None) -> bool:
    """Whether a message goes into a loop: its rate is not written, or the loop's."""
    is_same = own_rate is not None and math.isclose(publication.rate, own_rate)
    return publication.is_rate_open or (is_same and publication.parameter is None)


def _publish_in(added: Addition, block: Node, publications: Sequence[Publication]) -> None:
    """Publish at the end of a block, before it sleeps or leaves."""
    statements = statements_of(block)
    last = statements[-1]
    text = added.analysis.syntax.text
    leaves = last.type == "return_statement" or is_sleep(added.analysis, last)
    indent = leading_space(added.analysis, statements[0])
    offset = line_start(text, last.start_byte) if leaves else line_end(text, last.end_byte)
    lines = []
    prefix = naming.words(added.name)
    for publication in publications:
        lines += sending(added, publication, added.free_name(f"{prefix}_message"), False)
    added.writer.lines(offset, indent, lines)


def sending(added: Addition, publication: Publication, variable: str, is_named: bool) -> list[str]:
    """Return the lines that send one message; a header gets the time."""
    messages, value = added.messages, publication.message.value
    if publication.reaction is not None:
        messages.when(publication.reaction.condition)
    message = messages.message(value)
    needs_stamp = messages.needs_stamp(value)
    now = ""
    if needs_stamp and added.is_rclpy:
        receiver = added.receiver_in_callback() or added.place.receiver
        now = f"{receiver}.get_clock().now().to_msg()"
    elif needs_stamp:
        now = f"{added.rospy('Time')}.now()"
    if not now and not is_named:
        return messages.conditions.around([f"{added.variable}.publish({message})"])
    stamp = [f"{variable}.header.stamp = {now}"] if now else []
    lines = [f"{variable} = {message}", *stamp, f"{added.variable}.publish({variable})"]
    return messages.conditions.around(lines)


def _timer(added: Addition, rate: Rate, publications: list[Publication]) -> list[str]:
    """Publish in a timer of its own; return the lines that follow the creation."""
    # A function of the file that published may be left, and do something else now.
    names = (method_naming(added.analysis, each).name(added.name) for each in ("publish", "send"))
    method = added.free_name(*names)
    is_silent = signatures_of(added.analysis, EndpointKind.TIMER).is_silent
    summary = "" if is_silent else f"Publish to {added.label}."
    body: list[str] = []
    for publication in publications:
        body += sending(added, publication, "message", True)
    callback, lines = _function(added, method, summary, body)
    period = period_of(added, rate)
    added.writer.endpoints.append((EndpointKind.TIMER, _timer_name(added, period), "None", method))
    timer = f"{_timer_call(added, period, callback)})"
    is_held = holds_handles(added.analysis, added.place, EndpointKind.TIMER)
    if is_transition(added.analysis, added.place) or is_held:
        return [*lines, f"{_timer_variable(added)} = {timer}"]
    return [*lines, timer]


def _timer_variable(added: Addition) -> str:
    """Return the attribute of the node, or the variable, that a timer is held by."""
    wanted = variable_naming(added.analysis, EndpointKind.TIMER).name(added.name)
    holder, dot, _ = added.variable.rpartition(".")
    name = added.free_name(wanted if dot else wanted.lstrip("_"))
    return f"{holder}{dot}{name}"


def _timer_call(added: Addition, period: str, callback: str) -> str:
    if added.is_rclpy:
        group = added.callback_group(EndpointKind.TIMER)
        end = f", callback_group={group}" if group else ""
        return f"{added.place.receiver}.create_timer({period}, {callback}{end}"
    timer = added.rospy("Timer")
    duration = added.rospy("Duration")
    return f"{timer}({duration}({period}), {callback}"


def _timer_name(added: Addition, period: str) -> str:
    """Return the expression that a reader finds as the timer's period."""
    if added.is_rclpy:
        return period
    return f"{added.rospy('Duration')}({period})"


def _function(added: Addition, name: str, summary: str, body: list[str]) -> tuple[str, list[str]]:
    """Write a timer's method, or return the lines of a function that sees the local variables."""
    self_name = added.place.self_name
    manner = signatures_of(added.analysis, EndpointKind.TIMER)
    taken = () if added.is_rclpy else parameter_names(added.analysis, EndpointKind.TIMER, ["event"])
    parameters = [(each, "") for each in taken]
    if summary:
        body = [f'"""{summary}"""', *body]
    if added.is_method_place and "." in added.variable:
        head = manner.head(name, [(self_name, ""), *parameters], "None")
        lines = [head, *("\t" + line for line in body)]
        senders = [
            scope
            for site in added.analysis.sites
            if site.endpoint.kind is EndpointKind.TIMER
            and (scope := callback_scope(added.analysis, site)) is not None
        ]
        added.writer.function(method_place(added.analysis, added.place, senders), lines)
        return f"{self_name}.{name}", []
    lines = [manner.head(name, parameters, "None"), *("\t" + line for line in body)]
    if added.place.scope.parent is None:
        gap = added.writer.conventions.blank_lines
        added.writer.function(function_place(added.analysis, added.place, (), gap), lines)
        return name, []
    return name, ["", *lines, ""]


def add_calls(added: Addition, client: Client) -> list[str]:
    """Call a service with each request; return the lines that follow the client's creation."""
    if not client.requests:
        return []
    added.stand(is_nested=added.is_nested)
    interface = added.messages.interface(client.type, InterfaceKind.SERVICE, client.name)
    requests = [added.messages.request(interface, each.value) for each in client.requests]
    if call_in_own_method(added, requests):
        return []
    keep_running(added)
    name = added.free_name(method_naming(added.analysis, "call").name(added.name))
    if added.is_rclpy:
        summary = f"Call {added.label} once it is there, and log its answer."
        return _call_rclpy(added, name, summary, requests)
    summary = f"Call {added.label} within 10 s, and log its answer."
    errors = [
        added.rospy(error, in_callback=not added.is_nested)
        for error in ("ROSException", "ServiceException")
    ]
    body = ["try:", f"\t{added.variable}.wait_for_service(timeout=10.0)"]
    for request in requests:
        body.append(f"\tresponse = {added.variable}({request})")
        body.append("\t" + added.log("info", "response", in_callback=not added.is_nested))
    body.append(f"except ({', '.join(errors)}) as error:")
    body.append("\t" + added.log("error", "error", in_callback=not added.is_nested))
    callback, lines = _function(added, name, summary, body)
    added.writer.endpoints.append((EndpointKind.TIMER, _timer_name(added, "0.1"), "None", name))
    return [*lines, f"{_timer_call(added, '0.1', callback)}, oneshot=True)"]


def _call_rclpy(added: Addition, name: str, summary: str, requests: list[str]) -> list[str]:
    """Call once from a timer, so that the node goes on while the service answers."""
    timer = _timer_variable(added)
    info = _info(added)
    quote = added.writer.conventions.quote
    # A call that waits would hold up all else that the node does.
    body = [
        f"if not {added.variable}.service_is_ready():",
        f"\t{info}("
        f"{quote}{added.label}: waiting for the service{quote}, throttle_duration_sec=10.0)",
        "\treturn",
        f"{timer}.cancel()",
    ]
    logged = f"f{quote}{added.label}: {{done.result()}}{quote}"
    for request in requests:
        body.append(f"future = {added.variable}.call_async({request})")
        logs = f"{info}({logged})"
        body.append(f"future.add_done_callback(lambda done: {logs})")
    callback, lines = _function(added, name, summary, body)
    added.writer.endpoints.append((EndpointKind.TIMER, _timer_name(added, "0.1"), "None", name))
    return [*lines, f"{timer} = {_timer_call(added, '0.1', callback)})"]


def _info(added: Addition) -> str:
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
