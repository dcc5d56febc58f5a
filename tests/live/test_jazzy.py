"""What generated nodes do on the newest ROS 2 that has wheels, they do on Jazzy."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
import test_both
import test_described
import test_goals
import test_managed_work
import test_parameters
import test_reactions
import test_transitions
from graph import Graph
from processes import generate

pytestmark = [pytest.mark.live, pytest.mark.long]

CHECKS: list[Callable[[Graph, Path], None]] = [
    test_both.test_a_node_does_all_four_things,
    test_both.test_the_server_answers_every_call_of_the_client,
    test_described.test_actions_and_parameters_are_described,
    test_goals.test_a_goal_is_canceled,
    test_goals.test_a_goal_of_five_seconds,
    test_managed_work.test_a_goal_is_sent_each_time,
    test_parameters.test_a_timer_follows_the_parameter_that_is_its_rate,
    test_reactions.test_what_follows_from_a_message_is_sent_and_nothing_else,
]


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__.removeprefix("test_"))
def test_jazzy_is_no_different(
    check: Callable[[Graph, Path], None], jazzy: Graph, tmp_path: Path
) -> None:
    check(jazzy, tmp_path)


# It installs what the others wait for.
@pytest.mark.long(2)
def test_a_managed_node_passes_every_transition(jazzy: Graph, tmp_path: Path) -> None:
    name = test_transitions.NAME
    keeper = generate(name, tmp_path / "output", jazzy.target)[f"{name}_node.py"]
    test_transitions.test_every_transition_twice_leaves_nothing_behind(jazzy, keeper)
