"""Timers that an edit creates, and the functions that they call."""

from __future__ import annotations

import re
from collections.abc import Iterator

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Rate
from plastron_tui.model.source import EndpointKind

from .. import literals
from ..receivers import HANDLE
from .adding import Addition
from .functions import write_function
from .handles import handle_for
from .hearing import bound
from .lambdas import NewLambda, model_lambda, with_body
from .manner import method_naming, variable_naming
from .members import hold, is_local, type_of
from .parameters import read_parameter

K = EndpointKind

_LITERAL = re.compile(rb"\b\d+(?:ns|us|ms|s|min)\b")


def period_of(added: Addition, rate: Rate | float) -> str:
    """Write the time between two turns, as the client library takes it."""
    if isinstance(rate, Rate) and rate.parameter is not None:
        bare = rate.parameter.removeprefix("~/")
        message = f"the rate of `{added.endpoint.name}` is what `{bare}` is as the node starts"
        help_ = f"let the timer follow `{bare}` by hand, if that changes while the node runs"
        added.plan.notes.append(Diagnostic(codes.READ_ONCE, message, added.span, help=help_))
        text = f"1.0 / {read_parameter(added, rate.parameter).text}"
        if added.is_ros2:
            return f"std::chrono::duration<double>({text})"
        return f"ros::Duration({text})"
    hertz = rate.hertz if isinstance(rate, Rate) else rate
    milliseconds = round(1000 / hertz)
    is_whole = milliseconds > 0 and 1000 / milliseconds == hertz
    if added.is_ros2:
        if is_whole and _has_literals(added):
            return f"{milliseconds}ms" if milliseconds % 1000 else f"{milliseconds // 1000}s"
        if is_whole:
            return f"std::chrono::milliseconds({milliseconds})"
        return f"std::chrono::duration<double>(1.0 / {literals.real(float(hertz))})"
    if is_whole:
        return f"ros::Duration({literals.real(milliseconds / 1000)})"
    return f"ros::Duration(1.0 / {literals.real(float(hertz))})"


def _has_literals(added: Addition) -> bool:
    """Tell whether the file writes times as literals: `500ms`."""
    is_seen = any("literals" in using for each in added.place.scope.chain for using in each.usings)
    return is_seen and _LITERAL.search(added.place.file.syntax.code) is not None


def event_parameter(added: Addition) -> str:
    """Write what the function of a timer takes: in ROS 1 the event, which it does not need."""
    if added.is_ros2:
        return ""
    return f"const ros::TimerEvent{added.style(added.place.file).reference.rstrip()}"


def timer_name(added: Addition, words: str, *, last: bool = False) -> str:
    """Declare what holds a timer, and return its name.

    Args:
        added: the endpoint.
        words: what the name is made of.
        last: whether it goes first of all that was declared, being in a thread of its own. Where
            the function keeps that thread, its timer is declared as it is created.
    """
    if last and added.owner is None:
        named = variable_naming(added.analysis, K.TIMER, added.sites, is_member=False)
        return added.free(named.name(words), named.end)
    variable, file = hold(added, K.TIMER, type_of(added, K.TIMER, ""), words, last=last)
    del file
    return variable


def create_timer(
    added: Addition, timer: str, period: str, called: str, *, handle: str = "", once: bool = False
) -> None:
    """Create a timer that calls a function of the files."""
    handed = bound(added, called, 0 if added.is_ros2 else 1)
    arguments = ", ".join([period, *handed, *(["true"] if once else [])])
    added.lines.append(f"{_declared(added, handle)}{timer} = {_head(added, handle)}{arguments});")
    added.expect(K.TIMER, period, None, called)
    _include_chrono(added)


def run_at(
    added: Addition,
    words: str,
    verb: str,
    period: str,
    body: list[str],
    *,
    timer: str = "",
    captures: tuple[str, ...] = (),
    handle: str = "",
    once: bool = False,
) -> None:
    """Let a timer of its own do something: a method of the class, or a lambda in a function.

    Args:
        added: the endpoint.
        words: what the names are made of.
        verb: what is done, as the name of a method begins.
        period: how often, see `period_of`.
        body: what is done.
        timer: what holds the timer, where that is declared already.
        captures: the local variables that the body uses.
        handle: the handle of ROS 1 that it is created on, "" for the usual one.
        once: whether it ticks once, in ROS 1.
    """
    timer = timer or timer_name(added, words)
    tail = ", true);" if once else ");"
    head = f"{_declared(added, handle)}{timer} = {_head(added, handle)}"
    if added.owner is not None:
        like = model_lambda(added, K.TIMER)
        if like is not None and not like.handed_to and like.variable is None:
            event = [each for each in (event_parameter(added),) if each]
            added.lines += NewLambda(like, event, body).lines(added, head, [period], tail)
            added.expect(K.TIMER, period, None, "")
            _include_chrono(added)
            return
        name = added.free(method_naming(added.analysis, verb).name(words))
        said = f"{verb.capitalize()}es" if verb.endswith("sh") else f"{verb.capitalize()}s"
        event = [each for each in (event_parameter(added),) if each]
        write_function(added, name, event, body, f"{said} {added.prose}.")
        create_timer(added, timer, period, name, handle=handle, once=once)
        return
    node = added.place.node
    uses_node = bool(node) and any(node in line for line in body)
    # What the file has is seen without a word.
    captures = captures if is_local(added) else node_captures(added) if uses_node else ()
    captures = (*_not_global(added, captures), *_handles_in(added, body))
    taken = f"[{', '.join(dict.fromkeys(captures))}]"
    opening = f"{taken}({event_parameter(added)})", False
    style = added.style(added.place.file)
    added.lines += with_body(head, [period], opening, body, tail, style, added.columns)
    added.expect(K.TIMER, period, None, "")
    _include_chrono(added)


def capture(added: Addition, variable: str, *, is_pointer: bool) -> str:
    """Write how a lambda takes a local variable: what points by value, all else by reference."""
    del added
    return variable if is_pointer else f"&{variable}"


def _not_global(added: Addition, captures: tuple[str, ...]) -> Iterator[str]:
    """Yield the captures but those of variables of the file, which a lambda sees without."""
    unit, place = added.analysis.unit, added.place
    for each in captures:
        found = unit.lookup(each.lstrip("&"), place.scope, place.offset)
        if found is None or found.kind != "global":
            yield each


def _handles_in(added: Addition, body: list[str]) -> Iterator[str]:
    """Yield the local node handles of ROS 1 that a lambda uses; each is taken as a copy."""
    if added.is_ros2:
        return
    words = set(re.findall(r"\b[A-Za-z_]\w*(?=\.|->)", "\n".join(body)))
    for word in sorted(words):
        found = added.analysis.unit.lookup(word, added.place.scope, added.place.offset)
        is_local = found is not None and found.kind in ("local", "parameter")
        if found and is_local and added.analysis.receivers.type_of_variable(found) == HANDLE:
            yield word


def node_captures(added: Addition) -> tuple[str, ...]:
    """Return how a lambda of `main` takes the node of ROS 2."""
    node = added.place.node
    bare = node.removesuffix("->").removesuffix(".")
    found = added.analysis.unit.lookup(bare, added.place.scope, added.place.offset)
    if not node or (found is not None and found.kind == "global"):
        return ()
    return (f"&{node[:-1]}",) if node.endswith(".") else (node.removesuffix("->"),)


def duration_of(added: Addition) -> str:
    """Write how long a variable of the function lives: what `main` has not created stays."""
    return "" if added.place.function.name == "main" else "static "


def _declared(added: Addition, handle: str) -> str:
    if handle and added.owner is None:
        return f"{duration_of(added)}ros::Timer "
    if not is_local(added):
        return ""
    # Not `auto`: what the timer calls may name it.
    return "rclcpp::TimerBase::SharedPtr " if added.is_ros2 else "ros::Timer "


def _head(added: Addition, handle: str) -> str:
    if added.is_ros2:
        return f"{added.place.node}create_wall_timer("
    # The namespace of the handle is of no use to a timer.
    return f"{handle or handle_for(added.analysis, added.place, '/timer')[0]}createTimer("


def _include_chrono(added: Addition) -> None:
    if added.is_ros2:
        added.include(added.place.file, "chrono")
