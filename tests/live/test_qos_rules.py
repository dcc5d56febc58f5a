"""What ROS 2 itself says of two qualities of service."""

from __future__ import annotations

import json
import math
import subprocess
from itertools import product
from pathlib import Path

import pytest

from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos, mismatches

pytestmark = pytest.mark.live

VALUES: dict[str, tuple[str | float | None, ...]] = {
    "reliability": ("reliable", "best_effort", "system_default", "best_available"),
    "durability": ("volatile", "transient_local", "system_default", "best_available"),
    "liveliness": ("automatic", "manual_by_topic", "system_default", "best_available"),
    "deadline": (math.inf, 1.0, 2.0),
    "lease": (math.inf, 1.0, 2.0),
    "lifespan": (math.inf, 1.0),
    "history": ("keep_last", "keep_all"),
}
KNOWN = DEFAULT._replace(liveliness="automatic")
PAIRS = [
    (KNOWN.with_policy(policy, has), KNOWN.with_policy(policy, wants))
    for policy, values in VALUES.items()
    for has, wants in product(values, values)
] + [*product(PROFILES.values(), PROFILES.values())]

ASK = """
import json, sys
from rclpy.duration import Duration
from rclpy.qos import *

KINDS = {"reliability": ReliabilityPolicy, "durability": DurabilityPolicy,
         "history": HistoryPolicy, "liveliness": LivelinessPolicy}
NAMES = {"lease": "liveliness_lease_duration"}

def profile(known):
    given = {"depth": 1}
    for name, value in known.items():
        if name in KINDS:
            value = KINDS[name][value.upper()]
        elif name != "depth":
            value = Duration(seconds=value or 0)
        given[NAMES.get(name, name)] = value
    return QoSProfile(**given)

for offered, requested in json.load(sys.stdin):
    answer, _ = qos_check_compatible(profile(offered), profile(requested))
    print(answer.name)
"""
PROFILE = """
import json
from rclpy.qos import QoSPresetProfiles

for name, preset in QoSPresetProfiles.__members__.items():
    qos = preset.value
    print(json.dumps([name.lower(), qos.reliability.name, qos.durability.name, qos.history.name,
                      qos.depth, qos.liveliness.name, qos.lifespan.nanoseconds]))
"""


def known(qos: Qos) -> dict[str, object]:
    # JSON has no word for what has no end, which ROS 2 writes as nothing.
    return {name: 0 if value == math.inf else value for name, value in qos.known.items()}


def asked(python: Path, code: str, given: object = None) -> list[str]:
    done = subprocess.run(
        [python, "-c", code], input=json.dumps(given), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_ros_2_agrees_on_what_never_matches(ros2_python: Path) -> None:
    given = [[known(offered), known(requested)] for offered, requested in PAIRS]
    answers = asked(ros2_python, ASK, given)
    assert len(answers) == len(PAIRS)
    for (offered, requested), answer in zip(PAIRS, answers, strict=True):
        found = mismatches(offered, requested)
        assert bool(found) == (answer == "ERROR"), (offered, requested, answer, found)


def test_ros_2_has_the_same_profiles(ros2_python: Path) -> None:
    found = {}
    for line in asked(ros2_python, PROFILE):
        name, *policies, lifespan = json.loads(line)
        found[name] = (*policies, lifespan or math.inf)
    assert found.pop("unknown")
    ours = {
        name: (
            *(str(each).upper() for each in (qos.reliability, qos.durability, qos.history)),
            qos.depth,
            str(qos.liveliness).upper(),
            math.inf if qos.lifespan == math.inf else int((qos.lifespan or 0) * 1e9),
        )
        for name, qos in PROFILES.items()
    }
    # An `Enum` shows what is equal once, under the first name.
    assert {name: ours[name] for name in found} == found
    assert found.keys() == ours.keys()
