"""What a node sends for each message that it hears, and answers to each request."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from graph import Graph
from played_nodes import HEADER, scan, vector
from processes import generate_one
from traffic import Traffic, call, plain, record, send

pytestmark = pytest.mark.live

NAN = float("nan")


def twist(x: float, z: float) -> dict[str, Any]:
    return {"linear": vector(x), "angular": vector(0.0, 0.0, z)}


def joy(axes: list[float], *buttons: int) -> dict[str, Any]:
    return {"header": HEADER, "axes": axes, "buttons": buttons}


STEPS = [
    send("/scan", scan(1.0, 0.25), "/stop"),
    send("/scan", scan(1.0, NAN)),
    send("/scan", scan(NAN, 0.25), "/stop"),
    send("/scan", scan(2.5, NAN)),
    send("/scan", scan(2.5, 3.0), "/clear"),
    send("/joy", joy([0.5, 1.0], 0), "/cmd_vel", "/ratio"),
    send("/joy", joy([0.5], 0)),
    send("/joy", joy([-1.0, 0.25, 9.0]), "/cmd_vel", "/ratio"),
    send("/joy", joy([0.0, 0.0], 1), "/cmd_vel", "/half"),
    *(send("/level", {"data": value}, "/real") for value in (27, 0, -(2**31))),
    send("/level", {"data": 1}, "/gear", "/real"),
    send("/numbers", {"data": [1, 128]}),
    send("/numbers", {"data": [127, -128]}, "/bytes", "/both"),
    send("/numbers", {"data": [127, 0]}, "/bytes", "/both"),
    *(send("/far", {"data": value}, "/near") for value in (NAN, 1e39, 0.5)),
    send("/imu", {"orientation_covariance": [0.25] * 9}, "/sure"),
    send("/is_on", {"data": True}),
    send("/is_on", {"data": False}, "/off"),
    *(send("/octet", {"data": value}, *to) for value, to in ((5, ()), (4, ("/low",)))),
    *(send("/exact", {"data": value}, *to) for value, to in ((0.2, ()), (0.1, ("/tenth",)))),
    call("/switch", {"data": True}),
    call("/switch", {"data": False}),
]


_UNSURE = ("cmd_vel", "half", "gear", "bytes", "ratio", "both")
"""The topics that a step has something for that cannot be sent."""


@pytest.mark.long
def test_what_follows_from_a_message_is_sent_and_nothing_else(graph: Graph, tmp_path: Path) -> None:
    """A field that is not there, and a value that the message cannot hold, end no node."""
    assert_reflexes(record(graph, generate_one("reflex", tmp_path, graph.target), STEPS, {}))


def assert_reflexes(traffic: Traffic) -> None:
    """A node has sent what follows from the steps, and nothing else."""
    heard = plain(dict(traffic.heard))
    assert [each["data"] for each in heard.pop("/bytes")] == [[127, -128], [127, 0]]
    assert [repr(each["data"]) for each in heard.pop("/near")] == ["nan", "inf", "0.5"]
    assert heard == {
        "/stop": [twist(0.0, 0.0)] * 2,
        "/clear": [twist(1.0, 0.0)],
        "/cmd_vel": [twist(0.5, 0.25), twist(0.125, -0.5), twist(0.0, 0.0)],
        "/half": [{"header": {"stamp": "now", "frame_id": "base"}, "point": vector(0.0)}],
        "/gear": [{"data": 4}],
        "/ratio": [{"data": 2.5}, {"data": -2.0}],
        "/both": [{"data": -1}, {"data": 127}],
        "/real": [{"data": float(value)} for value in (27, 0, -(2**31), 1)],
        "/sure": [{"data": 0.25}],
        "/off": [{"data": True}],
        "/low": [{"data": True}],
        "/tenth": [{"data": True}],
    }
    assert traffic.answers == [
        {"success": True, "message": "switched"},
        {"success": False, "message": "switched"},
    ]
    warned = " ".join(text for level, text in traffic.logs if level.startswith("WARN"))
    assert all(f"{name}, of received." in warned for name in _UNSURE)
