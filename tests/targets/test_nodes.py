"""The hand-written nodes of tests/nodes, each with the JSON that inspecting it must give."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from file_sets import one

from plastron_tui.model.inspection import inspect_json
from plastron_tui.sources.python import read_python

NODES = Path(__file__).parent.parent / "nodes"
EXPECTED = sorted(NODES.glob("r*py/*.json"))
KINDS = (
    "publishers",
    "subscriptions",
    "services",
    "clients",
    "action_servers",
    "action_clients",
    "timers",
    "parameters",
)


def _identifier(expected: Path) -> str:
    return f"{expected.parent.name}/{expected.stem}"


def _lines(inspected: dict[str, Any]) -> list[str]:
    """Flatten to one line an entry: a difference then shows the call sites that differ."""
    lines = [f"{inspected['file']} {inspected['client_library']}"]
    for node in inspected["nodes"]:
        lines.append(f"node {node['name']!r}")
        for kind in KINDS:
            lines += [f"{kind} {json.dumps(entry, sort_keys=True)}" for entry in node[kind]]
    return lines


@pytest.mark.parametrize("expected", EXPECTED, ids=_identifier)
def test_a_node_reads_as_its_author_says(expected: Path) -> None:
    wanted = json.loads(expected.read_text(encoding="utf-8"))
    text = (expected.parent / wanted["file"]).read_bytes()
    result = read_python(Path(wanted["file"]), one(text), library=None)
    assert result.source is not None, result.diagnostics
    inspected = inspect_json(result.source)
    assert _lines(inspected) == _lines(wanted)
    assert inspected == wanted


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_every_node_has_its_json(library: str) -> None:
    folder = NODES / library
    wanted = {
        json.loads(path.read_text(encoding="utf-8"))["file"] for path in folder.glob("*.json")
    }
    files = {path.name for path in folder.iterdir() if path.suffix != ".json" and path.is_file()}
    assert files == wanted
    assert len(files) >= 40
