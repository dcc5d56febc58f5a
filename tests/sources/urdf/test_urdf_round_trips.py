"""What is written is read as the same robot, and a change that is taken back leaves no trace."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from random_robots import robots, variations

from plastron_tui.ros.robots.description import Description
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.equality import same_robot
from plastron_tui.sources.urdf.reader import read_urdf
from plastron_tui.targets.robots.urdf import write_urdf


def read(text: bytes) -> Description:
    result = read_urdf(text)
    assert result.description is not None, result.diagnostics
    errors = [each.message for each in result.diagnostics if each.severity.value == "error"]
    assert not errors, text.decode()
    return result.description


@given(robots())
def test_a_robot_is_read_as_it_was_written(robot: Description) -> None:
    text = write_urdf(robot)
    assert same_robot(read(text), robot)
    assert write_urdf(read(text)) == text


@given(robots(), robots())
def test_a_difference_is_made(one: Description, other: Description) -> None:
    text = write_urdf(one)
    changed = edited(text, one, other)
    assert changed.text is not None, changed.diagnostics
    assert same_robot(read(changed.text), other)


@given(robots(), st.data())
def test_a_difference_that_is_taken_back_leaves_no_trace(
    one: Description, data: st.DataObject
) -> None:
    text = write_urdf(one)
    one = read(text)
    other = data.draw(variations(one))
    changed = edited(text, one, other)
    assert changed.text is not None, changed.diagnostics
    back = edited(changed.text, other, one)
    assert back.text == text
