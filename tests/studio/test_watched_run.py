"""Which nodes the live panel shows where those of several tabs run, and when it gives way."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from plastron_tui.runtime.live_graph import LiveGraph
from plastron_tui.studio.main.active_program import Tab
from plastron_tui.studio.main.live_actions import LiveActions
from plastron_tui.studio.main.tab_run import RunPanels, TabRun
from plastron_tui.studio.main.watched_run import WatchedRun
from plastron_tui.studio.panels.live_row import Kind, LiveRow
from plastron_tui.studio.panels.output_log import Record


@pytest.mark.parametrize(
    ("watched", "ended", "others_run", "left"),
    [
        (["one"], "one", False, None),
        (["one", "other"], "one", True, "other"),
        (["one", "other"], "other", True, "one"),
        # None is watched yet: those that start just now are.
        ([], "one", False, None),
        ([], "one", True, None),
    ],
)
def test_nothing_is_watched_any_more_when_those_have_ended_that_were(
    watched: list[str], ended: str, others_run: bool, left: str | None
) -> None:
    calls: list[str] = []
    live = SimpleNamespace(end=lambda: calls.append("end"))
    run = WatchedRun(cast(LiveActions, live), cast(Any, None))
    tabs = {name: cast(Tab, SimpleNamespace(name=name)) for name in ("one", "other")}
    run._watched = [tabs[each] for each in watched]
    run._newest = run._watched[0] if watched else None
    run.end(tabs[ended], others_run=others_run)
    assert bool(calls) != others_run
    assert run._newest == (None if left is None else tabs[left])


@pytest.mark.parametrize("how", ["end", "lost"])
async def test_a_form_does_not_wait_for_who_is_gone(how: str) -> None:
    panel = SimpleNamespace(show_live=lambda *_, **__: None, is_in_sight=False)
    screen = SimpleNamespace(notify=lambda *_, **__: None)
    live = LiveActions(cast(Any, screen), cast(Any, panel), cast(Any, None))
    said: list[tuple[int, bool]] = []
    for version in (1, 2):
        live._graphs[version] = LiveGraph(version)
        live._monitors[version] = cast(Any, SimpleNamespace(close=lambda: None))
        row = LiveRow("k", Kind.PARAMETER, "speed", "/a", version)
        form = SimpleNamespace(
            is_current=True,
            answered=lambda _, *, is_failure, version=version: said.append((version, is_failure)),
        )
        live._asked[version] = row, cast(Any, form)
    if how == "end":
        live.end()
        assert said == [(1, True), (2, True)] and not live._asked
    else:
        live._retried.add(2)
        live._lost(2, "it was killed")
        assert said == [(2, True)] and [*live._asked] == [1]
    live.close()


@pytest.mark.parametrize(
    ("end", "in_sight", "revealed"),
    [
        (None, "live", []),
        (Record("", "stopped", "quiet"), "live", []),
        (Record("", "ended with status 0", "success"), "live", []),
        # Why they ended is printed, and Live has nothing to say of it.
        (Record("", "ended with status 1", "error"), "live", ["output"]),
        (Record("", "ended with status 1", "error"), "graph", []),
    ],
)
def test_nodes_that_end_badly_bring_what_they_printed_in_sight(
    end: Record | None, in_sight: str, revealed: list[str]
) -> None:
    seen: list[str] = []
    layout = SimpleNamespace(is_in_sight=in_sight.__eq__, reveal=seen.append)
    panel = SimpleNamespace(add=lambda *_: None, remark=lambda *_: None)
    panels = RunPanels(*(cast(Any, each) for each in (layout, panel, panel, panel)))
    panels.add(TabRun(), ["a | x"], end)
    assert seen == revealed
