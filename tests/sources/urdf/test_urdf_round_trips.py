"""What is written is read as the same robot, and a change that is taken back leaves no trace."""

from __future__ import annotations

from hypothesis import given
from random_robots import robots

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
def test_a_difference_is_made_and_taken_back(one: Description, other: Description) -> None:
    text = write_urdf(one)
    one = read(text)
    changed = edited(text, one, other)
    assert changed.text is not None, changed.diagnostics
    assert same_robot(read(changed.text), other)
    back = edited(changed.text, read(changed.text), one)
    assert back.text == text
