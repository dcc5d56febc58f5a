"""The names of the panels can be read, however many there are beside each other."""

from __future__ import annotations

import pytest

from plastron_tui.studio.panels.dock import TabStrip
from plastron_tui.studio.panels.registry import PANELS

COUNTS = {"nodes": 2, "topics": 1, "services": 0, "messages": 1, "packages": 0, "robots": 0}
FULL = dict.fromkeys(COUNTS, 3)


@pytest.mark.parametrize(
    ("width", "active", "counts", "text"),
    [
        (120, "nodes", COUNTS,
         " Nodes 2  Topics 1  Services  Messages 1  Preview  Graph  Packages  Robot  Live  Problems"
         "  Output "),
        (80, "nodes", COUNTS,
         " Nodes Topics Services Messages Preview Graph Pkg Robot Live Problems Output"),
        (80, "nodes", {**FULL, "problems": 12},
         " Nodes Topics Services Messages Preview Graph Pkg Robot Live Problems 12 Output"),
        (62, "graph", COUNTS, " Nodes Topics Messages Preview Graph Live Problems Output"),
        (60, "robots", COUNTS, " Nodes Topics Messages Code Graph Robot Live Problems Output"),
        (50, "nodes", COUNTS, " Nodes Topics Msg Code Graph Live Problems Output"),
        (60, "nodes", {}, " Nodes Topics Srv Msg Code Graph Pkg Robot Live Problems Output"),
    ],
)  # fmt: skip
def test_every_name_can_be_read(width: int, active: str, counts: dict[str, int], text: str) -> None:
    strip = TabStrip()
    strip.tabs, strip.active, strip.counts = PANELS, active, counts
    assert "".join(name + count for _, name, count in strip._fitting(width)) == text
