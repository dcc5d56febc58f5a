"""Each worker begins with some of the longest tests, each kind of work is spread, none is lost."""

from __future__ import annotations

from itertools import groupby, pairwise
from pathlib import Path
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from long_modules import is_left_out, overlooked
from suite_order import in_order, minutes, shares
from xdist.scheduler.worksteal import WorkStealingScheduling


class Worker:
    """What a scheduler needs of a worker, which runs nothing."""

    shutting_down = False

    def __init__(self, number: int) -> None:
        self.gateway = SimpleNamespace(id=f"gw{number}")
        self.got: list[int] = []

    def send_runtest_some(self, indices: list[int]) -> None:
        self.got += indices

    def send_steal(self, indices: list[int]) -> None:
        raise AssertionError("there is enough for all")

    def shutdown(self) -> None:
        raise AssertionError("there is enough for all")


@pytest.mark.parametrize(("number", "workers"), [(40, 4), (41, 4), (43, 4), (30, 1), (20, 3)])
def test_a_share_is_what_a_worker_is_given(
    pytestconfig: pytest.Config, number: int, workers: int
) -> None:
    config = SimpleNamespace(
        getvalue=lambda name: ["popen"] * workers, option=pytestconfig.option, hook=None
    )
    scheduler = WorkStealingScheduling(config)
    nodes = [Worker(each) for each in range(workers)]
    for node in nodes:
        scheduler.add_node(node)
        scheduler.add_node_collection(node, [str(each) for each in range(number)])
    scheduler.schedule()
    assert [len(node.got) for node in nodes] == shares(number, workers)
    assert [each for node in nodes for each in node.got] == list(range(number))


TESTS = st.lists(
    st.tuples(st.sampled_from("abcdefgh"), st.sampled_from([0, 0, 0, 0, 0.5, 1, 5])), max_size=60
)


@given(TESTS, st.integers(1, 6))
def test_each_worker_begins_with_its_longest(given: list[tuple[str, float]], workers: int) -> None:
    tests = [(file, number, length) for number, (file, length) in enumerate(given)]
    ordered = in_order(tests, workers, lambda each: each[2], lambda each: each[0])
    assert sorted(ordered) == sorted(tests)
    # Of each file those that are not long follow each other as they did.
    others = [each for each in ordered if not each[2]]
    files = [file for file, _ in groupby(others, lambda each: each[0])]
    assert len(files) == len(set(files))
    assert all(one[1] < two[1] for one, two in pairwise(others) if one[0] == two[0])
    left = ordered
    sizes = shares(len(tests), workers)
    if len(tests) - len(others) <= len(tests) // workers:
        for size in sizes:
            lengths = [each[2] for each in left[:size]]
            assert lengths == sorted(lengths, reverse=True)
            left = left[size:]


def test_the_longest_are_dealt_out() -> None:
    tests = ["a", "b5", "c", "d2", "e1", "f", "g", "h4", "i", "j", "k", "l"]
    ordered = in_order(tests, 3, lambda each: float(each[1:] or 0), lambda each: "one")
    assert ordered == ["b5", "e1", "a", "c", "h4", "f", "g", "i", "d2", "j", "k", "l"]


def test_files_are_mixed() -> None:
    tests = [f"{folder}/{name}" for folder in ("live", "sources") for name in range(20)]
    ordered = in_order(tests, 1, lambda each: 0, lambda each: each)
    halves = [
        sum(each.startswith("live") for each in half) for half in (ordered[:20], ordered[20:])
    ]
    assert min(halves) >= 5


def test_modules_without_a_long_test_are_not_read_for_the_long_ones() -> None:
    here = Path(__file__)
    assert not is_left_out(here)
    assert is_left_out(here.with_name("test_watchdog.py"))
    # Helpers of tests, and what is given to them, are read where a test is.
    assert not is_left_out(here.with_name("conftest.py"))
    assert not is_left_out(here.parent)


@pytest.mark.long(0.1)
def test_a_long_test_is_overlooked_where_its_module_does_not_say_so(
    request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert overlooked([request.node]) == []
    monkeypatch.setattr("long_modules.may_be_long", lambda module: False)
    assert overlooked([request.node]) == [request.node.nodeid]


@pytest.mark.long(0.1)
def test_a_mark_says_minutes(request: pytest.FixtureRequest) -> None:
    assert minutes(request.node) == 0.1
