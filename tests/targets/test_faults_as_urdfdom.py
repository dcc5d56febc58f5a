"""What keeps a robot from being one tree is what urdfdom's parser refuses."""

from __future__ import annotations

import random
import subprocess
import sysconfig
from pathlib import Path

import pytest
from machine import examples

from plastron_tui.ros.robots.description import Description, Joint, JointType, Limit, Link, Mimic
from plastron_tui.ros.robots.faults import FaultKind, faults
from plastron_tui.targets.robots.urdf import write_urdf

CHECKERS = (Path("/usr/bin/check_urdf"), Path(sysconfig.get_path("scripts"), "check_urdf"))
FINE = {
    FaultKind.NO_RANGE,
    FaultKind.ROOT_INERTIA,
    FaultKind.MIMICS_NOTHING,
    FaultKind.MIMICS_FIXED,
    FaultKind.MIMIC_CIRCLE,
    FaultKind.SHARED_NAME,
}
"""What urdfdom does not look at."""


@pytest.mark.long
def test_what_is_no_tree_is_none_for_urdfdom(tmp_path: Path) -> None:
    checker = next(each for each in CHECKERS if each.exists())
    choice = random.Random(15)
    path = tmp_path / "robot.urdf"
    outcomes = set()
    for _ in range(examples(25)):
        robot = odd_robot(choice)
        wrong = {each.kind for each in faults(robot)} - FINE
        path.write_bytes(write_urdf(robot))
        done = subprocess.run([checker, path], capture_output=True, text=True, check=False)
        assert (done.returncode != 0) is bool(wrong), (robot, wrong, done.stderr)
        outcomes.add(bool(wrong))
    assert outcomes == {True, False}


def odd_robot(choice: random.Random) -> Description:
    """Return a few links that are not always held as they have to be."""
    names = [f"l{at}" for at in range(choice.randint(0, 5))]
    joints: dict[str, Joint] = {}
    for at, name in enumerate(names[1:], 1):
        if choice.random() < 0.07:
            continue
        parent = names[choice.randrange(at)]
        parent = parent if choice.random() < 0.85 else choice.choice([*names, "gone"])
        child = name if choice.random() < 0.9 else choice.choice([*names, "gone"])
        type_ = choice.choice(list(JointType))
        has_limit = type_.is_limited and choice.random() < 0.9
        limit = Limit(-1, 1, 10, 1) if has_limit else None
        mimic = Mimic(f"j{choice.randint(1, 5)}") if choice.random() < 0.2 else None
        joints[f"j{at}"] = Joint(f"j{at}", type_, parent, child, limit=limit, mimic=mimic)
    return Description("r", {name: Link(name) for name in names}, joints)
