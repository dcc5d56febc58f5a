"""Publishing messages and calling services from a file, in its own loop or timer if it has one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Publication, Publisher, Rate
from plastron_tui.model.source import EndpointKind

from . import naming
from .addition import Addition
from .conventions import leading_space, method_naming
from .own_loop import is_sleep, own_block, statements_of, woken_loop
from .repeating import timer_call
from .sending_once import PERIOD, when_heard
from .signatures import signatures_of
from .splices import line_end, line_start
from .timer_functions import start_timer, timer_variable, write_function


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
    timer = timer_variable(added)
    bare = timer.rpartition(".")[2].removesuffix("_timer").removesuffix("_")
    heard = f"{holder}{dot}{added.free_name(f'{bare}_is_heard')}"
    name = added.free_name(method_naming(added.analysis, "publish").name(added.name))
    summary = f"Publish to {added.label}, once: when somebody listens."
    body = when_heard(added, heard, timer, lines)
    callback, above = write_function(added, name, summary, body)
    call = timer_call(added, PERIOD, callback, name)
    return [f"{heard} = False", *above, f"{timer} = {call}"]


def _again(added: Addition, sent: Sequence[Publication]) -> list[str]:
    """Publish some messages again and again; return the lines that follow the creation."""
    if not sent:
        return []
    block = own_block(added)
    fitting: list[Publication] = []
    by_rate: dict[Rate, list[Publication]] = defaultdict(list)
    for publication in sent:
        is_fitting = block is not None and publication.fits(block.rate)
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
    callback, lines = write_function(added, method, summary, body)
    return [*lines, *start_timer(added, rate, callback, method)]
