"""What completion offers for robots: their parts, and what those are given."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.expectations import Expectation
from plastron_tui.ros.robots.colors import NAMES
from plastron_tui.ros.robots.description import Description, JointType, Link
from plastron_tui.ros.robots.tree import holders

from ..robot_words import AXES, JOINT_TYPES, SHAPES
from .candidate import Candidate, Offer
from .vocabulary import Vocabulary

_FIRST_NAMES = ("base_link", "base_footprint")
_UNITS = {"deg": "degrees: 90 is a right angle", "rad": "radians"}


def _robot(expected: Expectation, vocabulary: Vocabulary) -> Description:
    return vocabulary.robot(expected.filled.get("robot", ""))


def _type(expected: Expectation) -> object:
    return None if expected.declaration is None else expected.declaration.type


def _quoted(name: str, detail: str = "", after: str = "") -> Candidate:
    return Candidate(f"'{name}'", detail, after)


def _links(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer links: to a joint those that it can hold, or be on; else those that can be meant."""
    robot = _robot(expected, vocabulary)
    held = holders(robot)
    slot = expected.slot.name if expected.slot is not None else ""
    if _type(expected) is st.HasLink:
        made = vocabulary.made_parts(expected.filled.get("robot", ""))
        found = [name for name in robot.links if name not in made]
        yield from (_quoted(name, "change it") for name in found)
        if not robot.links:
            yield from map(_quoted, _FIRST_NAMES)
    elif slot == "child":
        parent = expected.filled.get("parent", "").strip("'")
        others = [name for name in robot.links if name != parent]
        for name in sorted(others, key=lambda name: name in held):
            joint = held.get(name)
            yield _quoted(
                name, "nothing holds it yet" if joint is None else f"held by {joint.name}"
            )
    else:
        after = " to " if slot == "parent" else ""
        yield from (_quoted(name, _about(link), after) for name, link in robot.links.items())


def _about(link: Link) -> str:
    return "" if link.visuals else "a place"


def _joints(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer joints: those that move to what limits or follows one, else those that can be meant."""
    joints = _robot(expected, vocabulary).joints
    slot = expected.slot.name if expected.slot is not None else ""
    if _type(expected) is st.HasJoint and slot == "joint":
        made = vocabulary.made_parts(expected.filled.get("robot", ""))
        yield from (_quoted(name, "change it") for name in joints if name not in made)
        yield from _named_after_link(expected, vocabulary)
        return
    is_moving = _type(expected) is not st.NoLongerHasJoint
    found = [each for each in joints.values() if each.type.has_axis or not is_moving]
    # What has to be limited, and is not yet, comes first.
    for joint in sorted(found, key=lambda each: each.limit is not None or not each.type.is_limited):
        yield _quoted(joint.name, joint.type.value)


def _followed(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the joints that another one may follow; none where it follows one."""
    joints = _robot(expected, vocabulary).joints
    own = expected.filled.get("joint", "").strip("'")
    there = joints.get(own)
    if there is not None and there.mimic is not None:
        yield Candidate("none", f"it no longer follows {there.mimic.joint}")
    moving = (each for each in joints.values() if each.type.has_axis and each.name != own)
    yield from (_quoted(each.name, each.type.value) for each in moving)


def _named_after_link(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer a joint for each link that none holds yet, but for the first one."""
    robot = _robot(expected, vocabulary)
    held = holders(robot)
    for link in list(robot.links)[1:]:
        if link not in held and f"{link}_joint" not in robot.joints:
            yield _quoted(f"{link}_joint", f"to hold {link}", " of joint_type ")


def _sizes(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the values of a shape where they begin."""
    if not expected.written:
        shape = SHAPES.get(expected.filled.get("shape", ""))
        if shape is not None:
            yield Candidate(shape.values, shape.names)


def _colors(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    robot = _robot(expected, vocabulary)
    there = robot.links.get(expected.filled.get("link", "").strip("'"))
    yield from (Candidate(name, "of this robot") for name in robot.materials if name not in NAMES)
    yield from (Candidate(name, code, swatch=code) for name, code in NAMES.items())
    if there is not None and any(each.material is not None for each in there.visuals):
        yield Candidate("none", "no colour of its own")


def _axes(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    if not expected.written:
        yield from (Candidate(axis, about) for axis, about in AXES.items())


def _limit_units(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer the units that a joint's ends can be in."""
    joint = _robot(expected, vocabulary).joints.get(expected.filled.get("joint", "").strip("'"))
    if joint is None or joint.type is not JointType.PRISMATIC:
        yield from (Candidate(*unit) for unit in _UNITS.items())
    if joint is None or not joint.type.turns:
        yield Candidate("m", "metres")


OFFERS: Mapping[SlotKind, Offer] = {
    SlotKind.ROBOT: lambda _, vocabulary: (Candidate(*each) for each in vocabulary.robots.items()),
    SlotKind.LINK: _links,
    SlotKind.JOINT: _joints,
    SlotKind.FOLLOWED: _followed,
    SlotKind.SHAPE: lambda *_: (
        Candidate(name, each.about, f" {each.values}") for name, each in SHAPES.items()
    ),
    SlotKind.SIZE: _sizes,
    SlotKind.COLOR: _colors,
    SlotKind.ANGLE_UNIT: lambda *_: (Candidate(*unit) for unit in _UNITS.items()),
    SlotKind.JOINT_TYPE: lambda *_: (
        Candidate(name, about, " from ") for name, about in JOINT_TYPES.items()
    ),
    SlotKind.AXIS: _axes,
    SlotKind.LIMIT_UNIT: _limit_units,
}
"""What may fill each kind of slot."""
