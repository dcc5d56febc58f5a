"""Lines about robots made by chance, and a robot that they may load."""

from __future__ import annotations

from hypothesis import strategies as st

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Description,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Tensor,
)

_TENSOR = Tensor(1.0, 0.0, 0.0, 1.0, 0.0, 1.0)
_BODY = Body(Box((1.0, 1.0, 1.0)), material=Material("blue"))

ROBOT = Description(
    "loaded",
    {
        "a": Link("a", (_BODY,), (_BODY,), Inertial(0.0, Tensor(0, 0, 0, 0, 0, 0))),
        "b": Link("b", (_BODY, _BODY), (Body(Mesh("a.stl")),), Inertial(6.0, _TENSOR)),
        "c": Link("c", (Body(None),), (_BODY._replace(pose=Pose((1.0, 0.0, 0.0))),)),
        "e": Link("e"),
    },
    {
        "a": Joint("a", JointType.REVOLUTE, "a", "b", limit=Limit(1.0, 0.0), mimic=Mimic("b")),
        "b": Joint("b", JointType.PRISMATIC, "b", "a", mimic=Mimic("a")),
        "c": Joint("c", JointType.FIXED, "gone", "c", mimic=Mimic("gone")),
    },
    {"blue": Material("blue", (0.0, 0.0, 1.0, 1.0))},
)
"""One that has about every fault."""

_ROBOTS = st.sampled_from(["v", "w", "u", "n"])
_NAMES = st.sampled_from(["'a'", "'b'", "'c'", "'e'", "'d'", "'a b'", "''"])
_NUMBERS = st.sampled_from(
    ["0", "1", "-1", "0.5", "1.57", "90", "400", "1e999", "1e-320", "9" * 400]
)
_VECTORS = st.lists(_NUMBERS, min_size=3, max_size=3).map(", ".join)
_VALUES = st.lists(
    st.builds(
        "{}{}".format,
        st.sampled_from(["", "", "x=", "radius=", "uri=", "scale="]),
        _NUMBERS | st.sampled_from(['"a.stl"', "(1, 2, 3)", "(1, x=2)", "[1]", "True"]),
    ),
    min_size=1,
    max_size=4,
).map(", ".join)
_UNITS = st.sampled_from(["deg", "rad", "m", "mm"])


def _maybe(text: str, *parts: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.just("") | st.builds(text.format, *parts)


def _mostly(text: str, *parts: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    said = st.builds(text.format, *parts)
    return said | said | said | st.just("")


_PLACES = (_maybe(" at {}", _VECTORS), _maybe(" turned {} {}", _VECTORS, _UNITS))

ROBOT_LINES = (
    st.builds("create_robot {} as {}".format, _NAMES, _ROBOTS),
    st.builds("load_robot 'a.urdf' as {}".format, _ROBOTS),
    st.builds(
        "{} has_link {}{}{}{}{}{}".format,
        *(_ROBOTS, _NAMES),
        _maybe(" shaped {} {}", st.sampled_from(["box", "sphere", "mesh", "cube"]), _VALUES),
        *(
            _maybe(" weighing {}", _NUMBERS),
            _maybe(" painted {}", st.sampled_from(["blue", "x", "none"])),
        ),
        *_PLACES,
    ),
    st.builds("{} no_longer_has_link {}".format, _ROBOTS, _NAMES),
    st.builds(
        "{} has_joint {}{}{}{}{}{}{}".format,
        *(_ROBOTS, _NAMES),
        _mostly(
            " of joint_type {}", st.sampled_from([*(each.value for each in JointType), "hinge"])
        ),
        _mostly(" from {} to {}", _NAMES, _NAMES),
        *(*_PLACES, _maybe(" with axis {}", _VECTORS)),
        _maybe(" mimicking {}{}", _NAMES, _maybe(" times {}", _NUMBERS))
        | st.just(" mimicking none"),
    ),
    st.builds("{} no_longer_has_joint {}".format, _ROBOTS, _NAMES),
    st.builds(
        "{} limits_joint {}{}{}{}".format,
        *(_ROBOTS, _NAMES, _maybe(" between {} and {} {}", _NUMBERS, _NUMBERS, _UNITS)),
        _maybe(" with effort {} and velocity {}", _NUMBERS, _NUMBERS),
        _maybe(" with damping {} and friction {}", _NUMBERS, _NUMBERS),
    ),
    st.builds("generate_robot {}".format, _ROBOTS),
)
