"""What is played to nodes that a person wrote, before and after a program changes them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from traffic import Fields, Step

NODES = Path(__file__).parents[1] / "nodes" / "live"


@dataclass(frozen=True)
class Case:
    """An edit of a node in `tests/nodes/live`, or its port, where there are no statements.

    `steps` are played to the original and to the edited node, there with `renames` and in both
    without what is `gone`; `new` only to the edited one, for what the statements add. The node
    may call what the player `serves`: type and response by name. `node` is which, where the file
    has several.
    """

    file: str
    steps: tuple[Step, ...]
    statements: str = ""
    renames: Mapping[str, str] = field(default_factory=dict)
    gone: Collection[str] = ()
    new: tuple[Step, ...] = ()
    serves: Mapping[str, tuple[str, Fields]] = field(default_factory=dict)
    node: str | None = None


def vector(x: float, y: float = 0.0, z: float = 0.0) -> Fields:
    return {"x": x, "y": y, "z": z}


def scan(*ranges: float) -> Fields:
    return {"header": HEADER, "range_min": 0.125, "range_max": 8.0, "ranges": ranges}


HEADER = {"stamp": {"sec": 12, "nanosec": 500}, "frame_id": "base"}
