"""Functions that a file's node calls at a rate.

Source: `rclpy.node.Node.create_timer` of Jazzy, `rospy.Timer` of Noetic.
"""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Client, Endpoint, Publisher, Rate, Timer
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import parameter_name

from . import literals
from .addition import Addition
from .analysis import Analysis, Site
from .conventions import variable_naming
from .lifecycle import is_transition
from .loggers import own_logger
from .messages import CannotAddError
from .place import beside
from .rates import timer_pace
from .replacing import NotInPlaceError, Replacement
from .signatures import parameter_names, signatures_of
from .surroundings import holds_handles

# What takes more characters is written as one by the rate.
_MOST_DIGITS = 6


def period_of(added: Addition, rate: Rate) -> str:
    """Write the seconds between two calls; Python 2 divides integers to integers."""
    if rate.parameter is not None:
        bare = rate.parameter.removeprefix("~/")
        message = f"the rate of `{added.name}` is what `{bare}` is as the node starts"
        help_ = f"let the timer follow `{bare}` by hand, if that changes while the node runs"
        note = Diagnostic(codes.READ_ONCE, message, added.endpoint.span, help=help_)
        added.writer.notes.append(note)
        return f"1.0 / {added.read_parameter(rate.parameter)[0]}"
    seconds = literals.number(1 / rate.hertz)
    return seconds if len(seconds) <= _MOST_DIGITS else f"1.0 / {literals.number(rate.hertz)}"


def place_behind_rates(added: Addition, node: Analysis) -> None:
    """Let what has the rate of a parameter come behind the line that declares it.

    Raises:
        CannotAddError: rclpy does not surely know the parameter there.
    """
    for name in _rates(added.endpoint) if added.is_rclpy else ():
        found = [each for each in node.sites if _declares(each, name) and added.is_beside(each)]
        place = beside(node, found[0]) if found else None
        if place is None:
            bare = name.removeprefix("~/")
            message = f"the file does not declare `{bare}` where `{added.name}` would get its rate"
            remedy = f"write the rate as a number, or let a timer follow `{bare}` by hand"
            raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span, remedy)
        if place.offset > added.place.offset:
            added.place = place
            added.stand(is_nested=True)


def _rates(endpoint: Endpoint) -> list[str]:
    """Return the parameters that are rates of an endpoint."""
    rate = endpoint.rate if isinstance(endpoint, Timer) else None
    sent = endpoint.publications if isinstance(endpoint, Publisher) else ()
    asked = endpoint.requests if isinstance(endpoint, Client) else ()
    given = [each.rate.parameter for each in asked if each.rate is not None]
    given += [rate.parameter if rate is not None else None, *(each.parameter for each in sent)]
    return [each for each in given if each is not None]


def _declares(site: Site, name: str) -> bool:
    is_declaring = not {"declare_parameter", "declare_parameters"}.isdisjoint(site.shape.callees)
    return is_declaring and site.endpoint.name == parameter_name(name.removeprefix("~/"), 2)


def timer_call(added: Addition, period: str, callback: str, method: str, end: str = "") -> str:
    """Return the call that makes a timer, which a reader finds then.

    Args:
        added: what the timer is for.
        period: the seconds between two calls.
        callback: the source of the function that it calls.
        method: the function's name.
        end: the arguments behind these.
    """
    name = period
    if added.is_rclpy:
        group = added.callback_group(EndpointKind.TIMER)
        end = f", callback_group={group}" if group else ""
        call = f"{added.place.receiver}.create_timer({period}, {callback}{end})"
    else:
        name = f"{added.rospy('Duration')}({period})"
        call = f"{added.rospy('Timer')}({name}, {callback}{end})"
    added.writer.endpoints.append((EndpointKind.TIMER, name, "None", method))
    return call


def holds_timers(added: Addition) -> bool:
    """Whether something holds the timers that are made at a place."""
    is_ended = is_transition(added.analysis, added.place)
    return is_ended or holds_handles(added.analysis, added.place, EndpointKind.TIMER)


def repeat(added: Addition, timer: Timer, callback: str) -> list[str]:
    """Return the statement that has a function called at a rate."""
    assert timer.rate is not None, "statements say the rate"
    call = timer_call(added, period_of(added, timer.rate), callback, timer.name)
    if holds_timers(added):
        wanted = added.free_name(
            variable_naming(added.analysis, EndpointKind.TIMER).name(timer.name)
        )
        return [f"{added.place.self_name}.{wanted} = {call}"]
    return [call]


def tick_stub(added: Addition, name: str) -> list[str]:
    """Return the lines of a function that logs that it was called."""
    manner = signatures_of(added.analysis, EndpointKind.TIMER)
    taken = [] if added.is_rclpy else parameter_names(added.analysis, EndpointKind.TIMER, ["event"])
    own = [(added.place.self_name, "")] if added.place.owner is not None else []
    lines = [manner.head(name, [*own, *((each, "") for each in taken)], "None")]
    if manner.is_documented:
        lines.append('\t"""Do what is to be done again and again; called at its rate."""')
    lines.append(f"\t{_log(added, name)}")
    return lines


def _log(added: Addition, name: str) -> str:
    """Return a statement that logs a name, once a second at most."""
    text = added.writer.conventions.string(name)
    if not added.is_rclpy:
        return f"{added.rospy('loginfo_throttle', in_callback=True)}(1, {text})"
    receiver = added.receiver_in_callback()
    if receiver:
        return f"{receiver}.get_logger().info({text}, throttle_duration_sec=1.0)"
    logger = own_logger(added.analysis, added.place, "info") or "print"
    return f"{logger}({text})"


def set_rate(update: Replacement, timer: Timer) -> None:
    """Change how often a timer calls its function.

    Raises:
        NotInPlaceError: the file does not say the rate literally.
    """
    assert timer.rate is not None, "statements say the rate"
    pace = timer_pace(update.analysis, update.site)
    is_number = pace is not None and timer.rate.parameter is None
    splice = pace.set_to(update.analysis, timer.rate.hertz) if pace and is_number else None
    if splice is None:
        raise NotInPlaceError
    update.splices.append(splice)
