"""Each worker has some of the longest tests, and begins with them."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from suite_order import longest_first, minutes, shares
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


LENGTHS = st.lists(st.sampled_from([0, 0, 0, 0, 0, 0.5, 1, 5]), max_size=60)


@given(LENGTHS, st.integers(1, 6))
def test_each_worker_begins_with_its_longest(lengths: list[float], workers: int) -> None:
    tests = list(enumerate(lengths))
    ordered = longest_first(tests, workers, lambda each: each[1])
    assert sorted(ordered) == tests
    others = [each for each in ordered if not each[1]]
    assert others == sorted(others)
    if all(shares(len(tests), workers)) and len(tests) - len(others) <= len(tests) // workers:
        begun = 0
        for size in shares(len(tests), workers):
            own = [each[1] for each in ordered[begun : begun + size]]
            assert own == sorted(own, reverse=True)
            begun += size


def test_the_longest_are_dealt_out() -> None:
    tests = ["a", "b5", "c", "d2", "e1", "f", "g", "h4", "i", "j", "k", "l"]
    ordered = longest_first(tests, 3, lambda each: float(each[1:] or 0))
    assert ordered == ["b5", "e1", "a", "c", "h4", "f", "g", "i", "d2", "j", "k", "l"]


@pytest.mark.long(0.1)
def test_a_mark_says_minutes(request: pytest.FixtureRequest) -> None:
    assert minutes(request.node) == 0.1
