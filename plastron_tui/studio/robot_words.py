"""What shapes, joint types and axes are for, in words that need no ROS."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Shape(NamedTuple):
    """A shape.

    Attributes:
        about: what it is for.
        names: the names of its values.
        values: an example of them, in metres.
    """

    about: str
    names: str
    values: str


SHAPES: Mapping[str, Shape] = {
    "box": Shape("as a body, a shelf or a battery", "x, y, z in metres", "0.4, 0.3, 0.1"),
    "cylinder": Shape("as a wheel or a mast, along z", "radius, length in metres", "0.1, 0.05"),
    "sphere": Shape("as a caster", "radius in metres", "0.05"),
    "mesh": Shape("the file of a drawing program", "its URI", '"package://my_robot/meshes/a.stl"'),
}

JOINT_TYPES: Mapping[str, str] = {
    "fixed": "does not move: what is screwed on, as a sensor",
    "revolute": "turns between two angles, as an elbow; wants limits",
    "continuous": "turns without end, as a wheel",
    "prismatic": "slides between two ends, as a drawer; wants limits",
    "planar": "slides on a plane, as a puck; few tools take it",
    "floating": "moves freely, as a boat; few tools take it",
}
"""Those that most robots have come first."""

AXES: Mapping[str, str] = {
    "0, 0, 1": "up: turns as a turntable does",
    "0, 1, 0": "to the left: turns as a wheel does",
    "1, 0, 0": "forward: rolls, or slides ahead",
    "0, 0, -1": "down",
    "0, -1, 0": "to the right",
    "-1, 0, 0": "backward",
}
"""The axes that most joints have, and where they point."""
