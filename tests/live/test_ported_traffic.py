"""Rospy nodes that a person wrote send on ROS 2 what they send on ROS 1, for the same input."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from graph import Graph
from played_nodes import NODES, Case
from processes import edit
from rospy_edits import ROSPY_EDITS
from rospy_ports import ROSPY_PORTS
from traffic import KINDS, Traffic, differences, plain, record

pytestmark = pytest.mark.live

BY_HAND = {"rospy/light_switch.py", "rospy/wheels.py"}
"""What calls services, or publishes what may be a message, stays for somebody to port."""

CASES = [*ROSPY_PORTS, *(case for case in ROSPY_EDITS if case.file not in BY_HAND)]


@pytest.mark.long
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.file)
def test_a_port_sends_what_the_original_sends(
    case: Case, ros1: Graph, ros2: Graph, tmp_path: Path
) -> None:
    ported = edit(NODES / case.file, "", tmp_path, using="rclpy")
    before = record(ros1, NODES / case.file, case.steps, case.serves)
    after = record(ros2, ported, case.steps, case.serves)

    assert _endpoints(after) == _endpoints(before)
    assert not differences(before.heard, after.heard, case.steps)
    assert plain(before.answers) == plain(after.answers)
    assert set(before.logs) == set(after.logs)


def _endpoints(traffic: Traffic) -> dict[str, dict[str, Any]]:
    """Return what both versions of ROS say of endpoints."""
    return {
        kind: {
            name: (each["type"], each.get("latch"))
            for name, each in traffic.endpoints[kind].items()
        }
        for kind in KINDS
    }
