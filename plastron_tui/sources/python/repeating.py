"""Functions that a file's node calls at a rate.

Source: `rclpy.node.Node.create_timer` of Jazzy, `rospy.Timer` of Noetic.
"""

from __future__ import annotations

from plastron_tui.model.kinds import Timer
from plastron_tui.model.source import EndpointKind

from . import literals
from .addition import Addition
from .conventions import variable_naming
from .lifecycle import is_transition
from .loggers import own_logger
from .rates import timer_pace
from .replacing import NotInPlaceError, Replacement
from .signatures import parameter_names, signatures_of
from .surroundings import holds_handles

# What takes more characters is written as one by the rate.
_MOST_DIGITS = 6


def period_text(rate: float) -> str:
    """Write the seconds between two calls; Python 2 divides integers to integers."""
    seconds = literals.number(1 / rate)
    return seconds if len(seconds) <= _MOST_DIGITS else f"1.0 / {literals.number(rate)}"


def repeat(added: Addition, timer: Timer, callback: str) -> list[str]:
    """Return the statement that has a function called at a rate."""
    assert timer.rate is not None, "statements say the rate"
    period = period_text(timer.rate.hertz)
    name = period
    if added.is_rclpy:
        group = added.callback_group(EndpointKind.TIMER)
        end = f", callback_group={group}" if group else ""
        call = f"{added.place.receiver}.create_timer({period}, {callback}{end})"
    else:
        name = f"{added.rospy('Duration')}({period})"
        call = f"{added.rospy('Timer')}({name}, {callback})"
    added.writer.endpoints.append((EndpointKind.TIMER, name, "None", timer.name))
    is_kept = is_transition(added.analysis, added.place)
    if is_kept or holds_handles(added.analysis, added.place, EndpointKind.TIMER):
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
    splice = None if pace is None else pace.set_to(update.analysis, timer.rate.hertz)
    if splice is None:
        raise NotInPlaceError
    update.splices.append(splice)
