"""Where the cursor of the live panel stops, and which row what is done there is about."""

from __future__ import annotations

import pytest

from plastron_tui.studio.panels.live_row_places import branch_at, stop_near, target_at
from plastron_tui.studio.panels.live_rows import Kind, LiveRow

ROWS = [
    LiveRow("topics", Kind.HEADING, "topics"),
    LiveRow("speed", Kind.TOPIC, "/speed", is_branch=True, is_open=True),
    LiveRow("speed.data", Kind.FIELD, "data", depth=1),
    LiveRow("services", Kind.HEADING, "services"),
    LiveRow("add", Kind.SERVICE, "/add"),
    LiveRow("answer", Kind.ANSWER, "→", depth=1),
    LiveRow("nodes", Kind.HEADING, "nodes"),
    LiveRow("talker", Kind.NODE, "/talker", is_branch=True),
]


@pytest.mark.parametrize(
    ("at", "branch", "targets"),
    [
        (0, None, {}),
        (1, 1, {Kind.TOPIC: 1}),
        (2, 1, {Kind.TOPIC: 1, Kind.FIELD: 2}),
        (4, None, {Kind.SERVICE: 4}),
        # A service that has answered is called again from its answer.
        (5, None, {Kind.SERVICE: 4, Kind.ANSWER: 5}),
        (7, 7, {Kind.NODE: 7}),
        (8, None, {}),
        (-1, None, {}),
    ],
)
def test_what_is_done_is_about_the_row_or_what_it_is_a_part_of(
    at: int, branch: int | None, targets: dict[Kind, int]
) -> None:
    assert branch_at(ROWS, at) == branch
    for kind in (Kind.TOPIC, Kind.FIELD, Kind.SERVICE, Kind.ANSWER, Kind.NODE, Kind.PARAMETER):
        wanted = targets.get(kind)
        assert target_at(ROWS, at, kind) == (None if wanted is None else ROWS[wanted])


@pytest.mark.parametrize(
    ("to", "before", "stop"),
    [(0, 1, 1), (0, 0, 1), (1, 0, 1), (3, 2, 4), (3, 4, 2), (6, 5, 7), (6, 7, 5), (9, 7, 7)],
)
def test_the_cursor_goes_past_headings(to: int, before: int, stop: int) -> None:
    assert stop_near(ROWS, to, before) == stop


def test_where_nothing_but_headings_is_the_cursor_may_stand_on_one() -> None:
    assert stop_near(ROWS[:1], 0, 0) == 0
    assert stop_near([], 0, 0) == 0
