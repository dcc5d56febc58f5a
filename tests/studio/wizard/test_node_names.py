"""A new node is called after what it is to do."""

from __future__ import annotations

import pytest
from wizard_courses import ANSWER, ASK, DO, HAVE, MAKE, REACT, REPEAT, SEND, course, form_after

TALKING = "create_node 'talker' as talker\ncreate_node 'asker' as ears\n"


@pytest.mark.parametrize(
    ("purpose", "entered", "name"),
    [
        (SEND, {}, "talker"),
        (SEND, {"topic": "cmd_vel"}, "driver"),
        (SEND, {"type": "geometry_msgs/Twist"}, "driver"),
        (REACT, {}, "listener"),
        (REACT, {"topic": "front/scan"}, "watcher"),
        (REACT, {"type": "sensor_msgs/Range"}, "watcher"),
        (ASK, {}, "asker"),
        (ANSWER, {}, "answerer"),
        (DO, {}, "worker"),
        (REPEAT, {}, "ticker"),
        (HAVE, {}, "talker"),
    ],
)
def test_a_node_is_called_after_its_purpose(
    purpose: str, entered: dict[str, str], name: str
) -> None:
    it = course("")
    form = form_after(it, MAKE, purpose)
    form.entered.update(entered)
    look = it.look()
    assert look.node == name
    assert look.outcome is not None
    assert look.outcome.lines[0] == f"create_node '{name}' as {name}"


def test_a_name_that_is_taken_gets_a_number() -> None:
    for purpose, name in ((SEND, "talker_2"), (ASK, "asker_2"), (HAVE, "listener")):
        it = course(TALKING)
        form_after(it, MAKE, purpose)
        assert it.look().node == name


def test_a_name_that_somebody_wrote_stays() -> None:
    it = course("")
    form_after(it, MAKE, ANSWER)
    assert it.head_form is not None
    it.head_form.enter("name", "lamp")
    assert it.look().node == "lamp"
