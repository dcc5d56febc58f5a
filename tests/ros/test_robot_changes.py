"""What a sentence about a link or a joint that is there changes, and what stays."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.ros.robots.changes import Changed, LinkValues, Note, changed_link, new_link
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Dynamics,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Shape,
    Sphere,
    Tensor,
    Vector,
)
from plastron_tui.ros.robots.inertia import tensor_of
from plastron_tui.ros.robots.joint_changes import NO_MIMIC, JointValues, changed_joint

HERE = Pose()
UP: Vector = (0.0, 0.0, 1.0)
QUARTER: Vector = (pi / 2, 0.0, 0.0)
BOX = Box((0.4, 0.3, 0.1))
OTHER = Box((1.0, 1.0, 1.0))
WHEEL = Cylinder(0.1, 0.05)
MESH = Mesh("package://rover/base.stl")
BLUE, RED = Material("blue", (0.0, 0.0, 1.0, 1.0)), Material("red", (1.0, 0.0, 0.0, 1.0))
ODD = Tensor(0.3, 0.01, 0.0, 0.4, 0.0, 0.5)


def bounds_of(uri: str) -> tuple[Vector, Vector] | None:
    return ((-1.0, -1.0, 0.0), (1.0, 1.0, 2.0)) if uri == MESH.uri else None


def tensor(shape: Shape, mass: float) -> Tensor:
    found = tensor_of(shape, mass, (2.0, 2.0, 2.0))
    assert found is not None
    return found


def close(one: Inertial | None, other: Inertial) -> bool:
    assert one is not None
    return one.mass == other.mass and all(
        mine == pytest.approx(theirs, abs=1e-9)
        for mine, theirs in zip(
            (*one.tensor, *one.pose.position, *one.pose.rotation),
            (*other.tensor, *other.pose.position, *other.pose.rotation),
            strict=True,
        )
    )


def link(shape: Shape | None = BOX, pose: Pose = HERE, inertial: Inertial | None = None) -> Link:
    body = Body(shape, pose)
    return Link("a", (body._replace(material=BLUE),), (body,), inertial)


WHOLE = link(BOX, Pose(UP), Inertial(5.0, tensor(BOX, 5.0), Pose(UP)))


def change(before: Link, **said: object) -> Changed:
    return changed_link(before, LinkValues(**said), bounds_of)  # type: ignore[arg-type]


def test_a_new_link_is_seen_collides_and_weighs_alike() -> None:
    found, notes = new_link("a", LinkValues(BOX, 5.0, BLUE, UP), bounds_of)
    assert (found, notes) == (WHOLE, ())


@pytest.mark.parametrize(
    ("values", "notes"),
    [
        (LinkValues(), ()),
        (LinkValues(mass=5.0), ((Note.NO_SHAPE, "mass"),)),
        (LinkValues(material=BLUE, position=UP), ((Note.NO_SHAPE, "material"),)),
        (LinkValues(MESH), ()),
        (LinkValues(MESH, 5.0), ((Note.BOX_INERTIA, "mass"),)),
        (LinkValues(Mesh("gone.stl"), 5.0), ((Note.UNKNOWN_SIZE, "mass"),)),
    ],
)
def test_what_is_told_of_a_new_link(values: LinkValues, notes: object) -> None:
    assert new_link("a", values, bounds_of).notes == notes


@pytest.mark.parametrize(
    ("before", "said", "after"),
    [
        (WHOLE, {}, WHOLE),
        (WHOLE, {"mass": 5.0}, WHOLE),
        (WHOLE, {"shape": BOX, "mass": 5.0, "material": BLUE, "position": UP}, WHOLE),
        # What is seen and what collides together, and the inertia that followed.
        (
            WHOLE,
            {"shape": OTHER},
            link(OTHER, Pose(UP), Inertial(5.0, tensor(OTHER, 5.0), Pose(UP))),
        ),
        (
            WHOLE,
            {"position": (1.0, 2.0, 3.0)},
            new_link("a", LinkValues(BOX, 5.0, BLUE, (1.0, 2.0, 3.0)), bounds_of).link,
        ),
        (
            WHOLE,
            {"rotation": QUARTER},
            new_link("a", LinkValues(BOX, 5.0, BLUE, UP, QUARTER), bounds_of).link,
        ),
        # An inertia of its own stays in proportion.
        (
            link(inertial=Inertial(2.0, ODD)),
            {"mass": 4.0},
            link(inertial=Inertial(4.0, Tensor(*(2 * each for each in ODD)))),
        ),
        # One with a mass that is said follows from the shape that is said.
        (
            link(inertial=Inertial(2.0, ODD, Pose((0.1, 0.0, 0.0)))),
            {"shape": OTHER, "mass": 4.0},
            link(OTHER, inertial=Inertial(4.0, tensor(OTHER, 4.0))),
        ),
        # What weighed nothing has no proportion.
        (
            link(inertial=Inertial(0.0, Tensor(0, 0, 0, 0, 0, 0))),
            {"mass": 4.0},
            link(inertial=Inertial(4.0, tensor(BOX, 4.0))),
        ),
        (link(), {"mass": 4.0}, link(inertial=Inertial(4.0, tensor(BOX, 4.0)))),
        # What collides is what weighs.
        (
            Link("a", (Body(BOX),), (Body(OTHER, Pose(UP)),)),
            {"mass": 4.0},
            Link(
                *("a", (Body(BOX),), (Body(OTHER, Pose(UP)),)),
                Inertial(4.0, tensor(OTHER, 4.0), Pose(UP)),
            ),
        ),
        # A link that was a place only becomes whole.
        (Link("a"), {"shape": BOX, "mass": 5.0, "material": BLUE, "position": UP}, WHOLE),
        # What is only seen is only seen.
        (
            Link("a", (Body(BOX),)),
            {"shape": OTHER, "material": RED},
            Link("a", (Body(OTHER, material=RED),)),
        ),
        (Link("a", (), (Body(BOX),)), {"shape": OTHER}, Link("a", (), (Body(OTHER),))),
        (
            Link("a", inertial=Inertial(1.0, ODD)),
            {"mass": 1.0},
            Link("a", inertial=Inertial(1.0, ODD)),
        ),
        # A name, a material and a turn that are not spoken of stay.
        (
            Link("a", (Body(BOX, Pose(UP, QUARTER), BLUE, "shell"),)),
            {"position": (2.0, 0.0, 0.0)},
            Link("a", (Body(BOX, Pose((2.0, 0.0, 0.0), QUARTER), BLUE, "shell"),)),
        ),
        # All that is seen is painted.
        (
            Link("a", (Body(BOX, material=BLUE), Body(OTHER))),
            {"material": RED},
            Link("a", (Body(BOX, material=RED), Body(OTHER, material=RED))),
        ),
    ],
)
def test_what_is_said_changes(before: Link, said: dict[str, object], after: Link) -> None:
    found, notes = change(before, **said)
    assert notes == ()
    assert found._replace(inertial=None) == after._replace(inertial=None)
    assert (found.inertial is None) is (after.inertial is None)
    assert after.inertial is None or close(found.inertial, after.inertial)


LIDAR = Link("a", (Body(BOX), Body(BOX), Body(MESH)), (Body(WHEEL),))
APART = Link(
    "a",
    (Body(MESH, Pose((0.0, 0.0, -0.1))),),
    (Body(BOX),),
    Inertial(2.0, ODD, Pose((0.0, 0.0, 0.02))),
)


@pytest.mark.parametrize(
    ("before", "said", "told"),
    [
        (Link("a"), {"mass": 1.0}, {Note.NO_SHAPE: "mass"}),
        (Link("a"), {"material": RED}, {Note.NO_SHAPE: "material"}),
        (Link("a", inertial=Inertial(1.0, ODD)), {"position": UP}, {Note.NO_SHAPE: "position"}),
        (Link("a", (Body(None),)), {"mass": 1.0}, {Note.NO_SHAPE: "mass"}),
        (Link("a", (), (Body(BOX),)), {"material": RED}, {Note.NOT_SEEN: "material"}),
        (Link("a", (Body(BOX),) * 2), {"shape": OTHER}, {Note.SEVERAL_SHAPES: "shape"}),
        (Link("a", (Body(BOX),) * 2), {"mass": 2.0}, {Note.SEVERAL_SHAPES: "mass"}),
        (
            Link("a", (), (Body(BOX),) * 2, Inertial(1.0, ODD)),
            {"rotation": QUARTER, "mass": 2.0},
            {Note.SEVERAL_SHAPES: "rotation"},
        ),
        (link(inertial=Inertial(2.0, ODD)), {"shape": OTHER}, {Note.INERTIA_STAYS: "shape"}),
        (APART, {"shape": WHEEL}, {Note.OTHER_COLLISION: "shape", Note.INERTIA_STAYS: "shape"}),
        (APART, {"shape": OTHER}, {Note.OTHERS_STAY: "shape", Note.INERTIA_STAYS: "shape"}),
        (LIDAR, {"shape": OTHER}, {Note.SEVERAL_SHAPES: "shape"}),
        (LIDAR, {"shape": WHEEL, "position": UP}, {Note.OTHERS_STAY: "shape"}),
        (APART, {"position": UP}, {Note.APART: "position"}),
        (APART, {"rotation": QUARTER}, {Note.APART: "rotation"}),
        (WHOLE, {"shape": MESH, "mass": 1.0}, {Note.BOX_INERTIA: "mass"}),
        (WHOLE, {"shape": Mesh("gone.stl")}, {Note.UNKNOWN_SIZE: "mass"}),
    ],
)
def test_what_is_told_of_a_change(
    before: Link, said: dict[str, object], told: dict[Note, str]
) -> None:
    found, notes = change(before, **said)
    assert dict(notes) == told
    if any(note.is_refusal for note in told):
        assert found == before


def test_a_shape_is_that_of_what_has_one_of_its_kind() -> None:
    wheel = Body(WHEEL, Pose(rotation=QUARTER))
    inertial = Inertial(2.0, tensor(WHEEL, 2.0), wheel.pose)
    before = Link("a", (Body(MESH),), (wheel,), inertial)
    wider = Cylinder(0.3, 0.05)
    after, _ = change(before, shape=wider)
    assert (after.visuals, after.collisions) == (before.visuals, (wheel._replace(shape=wider),))
    assert close(after.inertial, Inertial(2.0, tensor(wider, 2.0), wheel.pose))
    after, _ = change(before, shape=Mesh("other.stl"))
    assert after == before._replace(visuals=(Body(Mesh("other.stl")),))
    # Of several that collide, it weighs as the one that is meant.
    several = before._replace(collisions=(Body(OTHER), wheel))
    after, _ = change(several, shape=wider, mass=3.0)
    assert after.collisions == (Body(OTHER), wheel._replace(shape=wider))
    assert close(after.inertial, Inertial(3.0, tensor(wider, 3.0), wheel.pose))


def test_what_is_elsewhere_stays_there() -> None:
    found = change(APART, position=UP).link
    assert found.visuals[0].pose.position == UP
    assert (found.collisions, found.inertial) == (APART.collisions, APART.inertial)
    turned = change(APART, rotation=QUARTER).link
    assert turned.visuals[0].pose.rotation == QUARTER
    assert (turned.collisions, turned.inertial) == (APART.collisions, APART.inertial)


def test_an_inertia_of_nothing_follows_from_the_shape() -> None:
    none = Tensor(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    found, _ = change(link(inertial=Inertial(1.0, none)), mass=2.0)
    assert close(found.inertial, Inertial(2.0, tensor(BOX, 2.0)))


def test_an_inertia_in_other_axes_follows_in_them() -> None:
    # People turn the wheel, and write its inertia in the axes of the link.
    across = tensor(WHEEL, 2.0)
    in_link = Tensor(across.ixx, 0.0, 0.0, across.izz, 0.0, across.ixx)
    wheel = link(WHEEL, Pose(rotation=QUARTER), Inertial(2.0, in_link))
    wider = tensor(Cylinder(0.3, 0.05), 2.0)
    found, notes = change(wheel, shape=Cylinder(0.3, 0.05))
    assert notes == ()
    assert close(
        found.inertial, Inertial(2.0, Tensor(wider.ixx, 0.0, 0.0, wider.izz, 0.0, wider.ixx))
    )
    turned, notes = change(wheel, rotation=(0.0, 0.0, 0.0))
    assert notes == ()
    assert close(turned.inertial, Inertial(2.0, across))


def test_a_mesh_weighs_in_the_middle_of_the_box_around_it() -> None:
    scaled = Mesh(MESH.uri, (1.0, 2.0, -0.5))
    made, _ = new_link("a", LinkValues(scaled, 6.0, None, UP, QUARTER), bounds_of)
    box = Inertial(6.0, tensor(Box((2.0, 4.0, 1.0)), 6.0), Pose((0.0, 0.5, 1.0), QUARTER))
    assert close(made.inertial, box)
    # What followed goes along, and what did not stays.
    moved, notes = change(made, position=(0.0, 0.0, 3.0))
    assert (notes, close(moved.inertial, box._replace(pose=Pose((0.0, 0.5, 3.0), QUARTER)))) == (
        (),
        True,
    )
    turned, notes = change(made, rotation=(0.0, 0.0, 0.0))
    assert (notes, close(turned.inertial, box._replace(pose=Pose((0.0, 0.0, 0.5))))) == ((), True)
    other = made._replace(inertial=Inertial(6.0, ODD, box.pose))
    assert change(other, position=(0.0, 0.0, 3.0)).notes == ((Note.APART, "position"),)


_LENGTHS = st.sampled_from([0.05, 0.3, 1.0])
_SHAPES = st.one_of(
    st.builds(Box, st.tuples(_LENGTHS, _LENGTHS, _LENGTHS)),
    st.builds(Cylinder, _LENGTHS, _LENGTHS),
    st.builds(Sphere, _LENGTHS),
)
_VECTORS = st.tuples(_LENGTHS, _LENGTHS, _LENGTHS)
_SAID = st.builds(LinkValues, _SHAPES, _LENGTHS, st.sampled_from([BLUE, RED]), _VECTORS, _VECTORS)


@given(_SAID, _SAID)
def test_a_link_that_is_changed_wholly_is_as_if_it_were_made_so(
    one: LinkValues, other: LinkValues
) -> None:
    made = new_link("a", one, bounds_of).link
    found, notes = changed_link(made, other, bounds_of)
    wanted = new_link("a", other, bounds_of).link
    assert notes == ()
    assert found._replace(inertial=None) == wanted._replace(inertial=None)
    assert wanted.inertial is not None
    assert close(found.inertial, wanted.inertial)
    assert changed_link(made, one, bounds_of).link == made


TURNING = Joint(
    *("j", JointType.REVOLUTE, "a", "b", Pose(UP), (0.0, 1.0, 0.0), Limit(-1.0, 1.0, 5.0, 2.0)),
    *(Dynamics(0.1, 0.2), Mimic("k", 2.0, 0.5)),
)
HELD = Joint("j", JointType.FIXED, "a", "b", Pose(UP))


@pytest.mark.parametrize(
    ("before", "type_", "after"),
    [
        (TURNING, JointType.REVOLUTE, TURNING),
        (
            TURNING,
            JointType.CONTINUOUS,
            TURNING._replace(type=JointType.CONTINUOUS, limit=Limit(0.0, 0.0, 5.0, 2.0)),
        ),
        # Radians are no metres.
        (
            TURNING,
            JointType.PRISMATIC,
            TURNING._replace(type=JointType.PRISMATIC, limit=None, dynamics=None, mimic=None),
        ),
        (
            TURNING._replace(type=JointType.PRISMATIC),
            JointType.REVOLUTE,
            TURNING._replace(limit=None, dynamics=None, mimic=None),
        ),
        (TURNING, JointType.FIXED, HELD),
        (TURNING, JointType.FLOATING, HELD._replace(type=JointType.FLOATING)),
        (
            TURNING,
            JointType.PLANAR,
            TURNING._replace(type=JointType.PLANAR, limit=None, dynamics=None, mimic=None),
        ),
        # What a tool writes into what does not move says nothing of what does.
        (
            HELD._replace(axis=(0.0, 0.0, 0.0), limit=Limit()),
            JointType.REVOLUTE,
            HELD._replace(type=JointType.REVOLUTE),
        ),
        (
            TURNING._replace(type=JointType.FIXED),
            JointType.CONTINUOUS,
            TURNING._replace(type=JointType.CONTINUOUS, limit=Limit(0.0, 0.0, 5.0, 2.0)),
        ),
        (TURNING._replace(type=JointType.FIXED), JointType.REVOLUTE, TURNING),
        (
            TURNING._replace(type=JointType.FIXED),
            JointType.PRISMATIC,
            TURNING._replace(type=JointType.PRISMATIC, limit=None, dynamics=None, mimic=None),
        ),
        (HELD._replace(axis=(0.0, 0.0, 0.0)), JointType.FIXED, HELD._replace(axis=(0.0, 0.0, 0.0))),
    ],
)
def test_a_joint_of_another_type_keeps_what_still_means_something(
    before: Joint, type_: JointType, after: Joint
) -> None:
    assert changed_joint(before, JointValues(type_, ("a", "b"))) == after


def test_what_is_said_of_a_joint_changes() -> None:
    mimic = Mimic("m")
    values = JointValues(JointType.REVOLUTE, ("c", "d"), (0.0, 0.0, 0.0), QUARTER, UP, mimic)
    found = changed_joint(TURNING, values)
    assert found == TURNING._replace(
        parent="c", child="d", pose=Pose((0.0, 0.0, 0.0), QUARTER), axis=UP, mimic=mimic
    )
    assert changed_joint(found, JointValues()) == found
    assert changed_joint(found, JointValues(mimic=NO_MIMIC)) == found._replace(mimic=None)
