"""What a node sends for each message that it hears, and answers to each request."""

from __future__ import annotations

from typing import Any

import pytest
from graph import Graph
from played_nodes import HEADER, scan, vector
from prototypes import prototype
from traffic import call, plain, record, send

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
    send("/joy", joy([0.5, 1.0], 0), "/cmd_vel"),
    send("/joy", joy([0.5], 0)),
    send("/joy", joy([-1.0, 0.25, 9.0]), "/cmd_vel"),
    send("/joy", joy([0.0, 0.0], 1), "/cmd_vel", "/half"),
    *(send("/level", {"data": value}) for value in (NAN, float("inf"), 25.56, -0.06)),
    send("/level", {"data": 0.34}, "/gear"),
    call("/switch", {"data": True}),
    call("/switch", {"data": False}),
]


def test_what_follows_from_a_message_is_sent_and_nothing_else(graph: Graph) -> None:
    """A field that is not there, and a value that the message cannot hold, end no node."""
    traffic = record(graph, prototype(graph, "reflex"), STEPS, {})
    assert plain(dict(traffic.heard)) == {
        "/stop": [twist(0.0, 0.0)] * 2,
        "/clear": [twist(1.0, 0.0)],
        "/cmd_vel": [twist(0.5, 0.25), twist(0.125, -0.5), twist(0.0, 0.0)],
        "/half": [{"header": {"stamp": "now", "frame_id": "base"}, "point": vector(0.0)}],
        "/gear": [{"data": 3}],
    }
    assert traffic.answers == [
        {"success": True, "message": "switched"},
        {"success": False, "message": "switched"},
    ]
    warned = " ".join(text for level, text in traffic.logs if level.startswith("WARN"))
    assert all(f"{name}: " in warned for name in ("cmd_vel", "half", "gear"))
