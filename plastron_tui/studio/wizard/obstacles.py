"""Driving as long as nothing is near: what a sensor of distances is used for first."""

from __future__ import annotations

import re

from plastron_tui.language import SlotKind
from plastron_tui.model.kinds import Publication, Publisher
from plastron_tui.model.unconditional_motion import moves
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.motion import is_distance, is_velocity
from plastron_tui.ros.names import spelled

from .ask import Ask

_NEAR = 0.5
"""Metres within which something is near."""

_LARGE = {"sensor_msgs/LaserScan": "all received.ranges", "sensor_msgs/Range": "received.range"}
"""What of the messages with distances has to be large."""

_FREE = re.compile(
    r"(?P<quantifier>all )?(?P<path>received\.\w+(\[\d+\])?) > (?P<value>.+)", re.ASCII
)


def measures_distance(type_: InterfaceName | None) -> bool:
    """Tell whether a message says how far away things are."""
    return type_ is not None and is_distance(str(type_))


def way_is_free(ask: Ask) -> str:
    """Return the condition that nothing is near, "" where a form does not drive by distances."""
    drives = is_velocity(ask.text(SlotKind.MESSAGE_TYPE))
    far = distances_of_trigger(ask)
    return f"{far} > {_NEAR}" if drives and far else ""


def distances_of_trigger(ask: Ask) -> str:
    """Return what has to be large of what a form waits for, "" where that has no distances."""
    heard = ask.scene.heard(ask.node).get(ask.text(SlotKind.TRIGGER))
    return _LARGE[str(heard)] if measures_distance(heard) else ""


def is_standing(node: Node | None, topic: str) -> bool:
    """Tell whether a node sends commands to a topic, and none by which a robot moves."""
    publisher = None if node is None else node.of(Publisher).get(spelled(topic))
    if publisher is None or not is_velocity(str(publisher.type)):
        return False
    return not any(moves(each.message.value) for each in publisher.publications)


def is_to_drive(ask: Ask) -> bool:
    """Tell whether something is sent for each reading of distances: most drive a robot then."""
    if ask.form.drives:
        return True
    slot = ask.form.slot_of(SlotKind.TRIGGER)
    trigger = "" if slot is None else ask.form.entered.get(slot.name, "")
    return measures_distance(ask.scene.heard(ask.node).get(trigger))


def distances_heard(ask: Ask) -> list[str]:
    """Return the topics with distances that a node listens to."""
    heard = ask.scene.heard(ask.node).items()
    return [name for name, type_ in heard if measures_distance(type_)]


def is_laser_wanted(ask: Ask) -> bool:
    """Tell whether a form makes a node listen to what another form drives a robot by."""
    if ask.form.parent is None:
        return False
    other, name = ask.form.parent
    trigger = other.slot_of(SlotKind.TRIGGER)
    return trigger is not None and trigger.name == name


def driven(node: Node | None, topic: str) -> list[Publication]:
    """Return what drives a robot whatever its sensors say, of what a node sends to a topic."""
    publisher = None if node is None else node.of(Publisher).get(spelled(topic))
    if publisher is None or not is_velocity(str(publisher.type)):
        return []
    return [
        each
        for each in publisher.publications
        if each.span is not None and each.reaction is None and not each.is_once
        if moves(each.message.value)
    ]


def is_near(type_: str, condition: str) -> tuple[str, str] | None:
    """Return when to stop what drives as long as the way is free, None for other conditions.

    Args:
        type_: the type of what is sent.
        condition: when it is sent.

    Returns:
        The condition that something is near, and within how many metres.
    """
    free = _FREE.fullmatch(condition)
    if free is None or not is_velocity(type_):
        return None
    quantifier = "any " if free["quantifier"] else ""
    return f"{quantifier}{free['path']} < {free['value']}", free["value"]
