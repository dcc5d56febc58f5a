"""What is wrong with a robot as a whole, each once."""

from __future__ import annotations

import pytest

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Mesh,
    Mimic,
    Pose,
    Sphere,
    Tensor,
)
from plastron_tui.ros.robots.faults import Fault, FaultKind, faults, meant_root

FIXED, TURNING, LIMITED = JointType.FIXED, JointType.CONTINUOUS, JointType.REVOLUTE
FINE = Tensor(1.0, 0.0, 0.0, 1.0, 0.0, 1.0)
NONE = Tensor(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def held(name: str, parent: str, child: str, type_: JointType = FIXED, **more: object) -> Joint:
    return Joint(name, type_, parent, child, **more)  # type: ignore[arg-type]


def robot(links: str, *joints: Joint, **parts: Link) -> Description:
    names = {name: Link(name) for name in links}
    return Description("r", names | parts, {each.name: each for each in joints})


def follower(name: str, child: str, followed: str, type_: JointType = TURNING) -> Joint:
    return held(name, "a", child, type_, mimic=Mimic(followed))


def seen(shape: Box | Cylinder | Sphere | Mesh, pose: Pose | None = None) -> Description:
    return robot("", b=Link("b", (Body(shape, pose or Pose()),)))


def heavy(mass: float, tensor: Tensor = FINE) -> Description:
    weighing = Link("b", inertial=Inertial(mass, tensor))
    return robot("a", held("j", "a", "b"), b=weighing)


CASES: list[tuple[Description, list[Fault]]] = [
    (robot("a"), []),
    (robot("abc", held("j", "a", "b"), held("k", "b", "c")), []),
    (robot(""), [Fault(FaultKind.NO_LINKS, "r")]),
    # The root is what most hangs on, or what comes first.
    (robot("ab"), [Fault(FaultKind.LOOSE, "b", ("a",))]),
    (robot("abc", held("j", "b", "c")), [Fault(FaultKind.LOOSE, "a", ("b",))]),
    (
        robot("a", held("j", "b", "c"), b=Link("b", inertial=Inertial(1.0, FINE)), c=Link("c")),
        [Fault(FaultKind.LOOSE, "b", ("a",))],
    ),
    (
        robot("abcd", held("j", "a", "b")),
        [Fault(FaultKind.LOOSE, "c", ("a",)), Fault(FaultKind.LOOSE, "d", ("a",))],
    ),
    (
        robot("ab", held("j", "a", "b"), held("k", "a", "b")),
        [Fault(FaultKind.HELD_TWICE, "k", ("b", "j"))],
    ),
    (robot("a", held("j", "a", "a")), [Fault(FaultKind.CIRCLE, "j", ("j",))]),
    (
        robot("ab", held("j", "a", "b"), held("k", "b", "a")),
        [Fault(FaultKind.CIRCLE, "k", ("j", "k"))],
    ),
    # Each holds the parent of the next; what hangs on a circle is not told besides.
    (
        robot(
            "xabcde",
            held("l", "c", "a"),
            held("j", "a", "b"),
            held("k", "b", "c"),
            held("m", "c", "d"),
            held("n", "d", "e"),
        ),
        [Fault(FaultKind.CIRCLE, "k", ("l", "j", "k"))],
    ),
    (
        robot(
            "abcd",
            held("j", "a", "b"),
            held("k", "b", "a"),
            held("l", "c", "d"),
            held("m", "d", "c"),
        ),
        [Fault(FaultKind.CIRCLE, "k", ("j", "k")), Fault(FaultKind.CIRCLE, "m", ("l", "m"))],
    ),
    (robot("a", held("j", "a", "z")), [Fault(FaultKind.NO_CHILD, "j", ("z",))]),
    (robot("ab", held("j", "z", "b")), [Fault(FaultKind.NO_PARENT, "j", ("z",))]),
    (robot("ab", held("j", "a", "b", LIMITED)), [Fault(FaultKind.NO_LIMITS, "j")]),
    (
        robot("ab", held("j", "a", "b", JointType.PRISMATIC, limit=Limit(effort=1.0))),
        [Fault(FaultKind.NO_RANGE, "j")],
    ),
    (
        robot("ab", held("j", "a", "b", LIMITED, limit=Limit(2.0, 1.0))),
        [Fault(FaultKind.NO_RANGE, "j")],
    ),
    (robot("ab", held("j", "a", "b", LIMITED, limit=Limit(-1.0, 1.0, 0.0, 1.0))), []),
    (
        robot("ab", held("j", "a", "b", LIMITED, limit=Limit(-1.0, 1.0, 1.0, 0.0))),
        [Fault(FaultKind.NO_VELOCITY, "j")],
    ),
    (robot("ab", held("j", "a", "b", TURNING, limit=Limit())), []),
    (robot("ab", follower("j", "b", "z")), [Fault(FaultKind.MIMICS_NOTHING, "j", ("z",))]),
    (
        robot("abc", held("j", "a", "b"), follower("k", "c", "j")),
        [Fault(FaultKind.MIMICS_FIXED, "k", ("j",))],
    ),
    (robot("ab", follower("j", "b", "j")), [Fault(FaultKind.MIMIC_CIRCLE, "j", ("j",))]),
    # One follows another in a row, and a row may be a circle.
    (
        robot(
            "abcd", held("j", "a", "b", TURNING), follower("k", "c", "j"), follower("l", "d", "k")
        ),
        [],
    ),
    (
        robot("abcd", follower("j", "b", "k"), follower("k", "c", "j"), follower("l", "d", "k")),
        [Fault(FaultKind.MIMIC_CIRCLE, "k", ("j", "k"))],
    ),
    (heavy(1.0), []),
    (heavy(0.0), [Fault(FaultKind.MASS, "b")]),
    # What has no mass has no inertia either: one fault, and a mere place where zeros say both.
    (heavy(0.0, NONE), []),
    (heavy(-1.0, NONE), [Fault(FaultKind.MASS, "b")]),
    (heavy(1.0, NONE), [Fault(FaultKind.INERTIA, "b")]),
    (heavy(1.0, FINE._replace(ixx=3.0)), [Fault(FaultKind.INERTIA, "b")]),
    (heavy(5_000.0), []),
    (heavy(500_000.0), [Fault(FaultKind.HEAVY, "b")]),
    (heavy(float("nan")), [Fault(FaultKind.MASS, "b")]),
    (robot("", a=Link("a", inertial=Inertial(1.0, FINE))), [Fault(FaultKind.ROOT_INERTIA, "a")]),
    (seen(Box((1.0, 0.0, 1.0))), [Fault(FaultKind.SIZE, "b")]),
    (seen(Sphere(0.0)), []),
    (seen(Sphere(-1.0)), [Fault(FaultKind.SIZE, "b")]),
    (seen(Sphere(float("nan"))), [Fault(FaultKind.SIZE, "b")]),
    (seen(Cylinder(1.0, 0.0)), [Fault(FaultKind.SIZE, "b")]),
    (seen(Mesh("a.stl", (0.0, 1.0, 1.0))), []),
    (seen(Box((1.0, 1.0, 400.0))), [Fault(FaultKind.LONG, "b")]),
    (seen(Sphere(1.0), Pose((0.0, -400.0, 0.0))), [Fault(FaultKind.LONG, "b")]),
    (
        robot("ab", held("j", "a", "b", pose=Pose((400.0, 0.0, 0.0)))),
        [Fault(FaultKind.LONG, "j")],
    ),
    (Description("r", {"/a": Link("/a")}), [Fault(FaultKind.NAME, "/a")]),
    (Description("r", {" ": Link(" ")}), [Fault(FaultKind.NAME, " ")]),
    (robot("ab", held("b", "a", "b")), [Fault(FaultKind.SHARED_NAME, "b")]),
]


@pytest.mark.parametrize(("described", "wrong"), CASES)
def test_what_is_wrong(described: Description, wrong: list[Fault]) -> None:
    assert list(faults(described)) == wrong


@pytest.mark.parametrize(
    ("root", "loose"),
    [
        (None, [("a", ("b",))]),
        ("a", [("b", ("a",))]),
        # A link that is held, and one that is not there, is no root.
        ("c", [("a", ("b",))]),
        ("z", [("a", ("b",))]),
    ],
)
def test_a_root_that_is_meant_counts(
    root: str | None, loose: list[tuple[str, tuple[str, ...]]]
) -> None:
    described = robot("abc", held("j", "b", "c"))
    found = list(faults(described, root))
    assert found == [Fault(FaultKind.LOOSE, *each) for each in loose]
    assert meant_root(described) == "b"
    assert meant_root(robot("")) is None


def test_a_chain_of_any_length_is_looked_at() -> None:
    count = 2_000
    links = {f"l{at}": Link(f"l{at}") for at in range(count)}
    joints = {
        f"j{at}": held(f"j{at}", f"l{at - 1}", f"l{at}", TURNING, mimic=Mimic(f"j{at - 1}"))
        for at in range(2, count)
    }
    joints["j1"] = held("j1", "l0", "l1", TURNING)
    chain = Description("r", links, joints)
    assert list(faults(chain)) == []
    closed = {**joints, "j0": held("j0", f"l{count - 1}", "l0")}
    (found,) = faults(Description("r", links, closed))
    assert (found.kind, found.part, len(found.others)) == (FaultKind.CIRCLE, "j0", count)
