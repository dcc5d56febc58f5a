"""Driving until something is near: in one go, and in the order that comes to mind first."""

from __future__ import annotations

import pytest
from wizard_courses import MAKE, MORE, applied, choose, course, to_menu_or_review

from plastron_tui.session import Session
from plastron_tui.studio.wizard import strings

DRIVE = "drive until something is near"
NODE = "create_node 'driver' as driver\n"
DRIVING = """\
create_message ahead of message_type Twist and input linear.x=0.2
driver publish ahead to 'cmd_vel' of message_type Twist at 10 hz
"""
HEARING = "subscribe driver to 'scan' of message_type sensor_msgs/LaserScan\n"
OTHER = """\
create_node 'speaker' as speaker
create_message hello of message_type String and input "hello"
speaker publish hello to 'chatter' of message_type String
generate_node speaker
"""
END = "generate_node driver\n"


@pytest.mark.parametrize(
    ("before", "line"),
    [
        ("", 0),
        (NODE + DRIVING + END, 3),
        (NODE + DRIVING + HEARING + END, 3),
        (NODE + HEARING + DRIVING, 4),
        (OTHER + NODE + DRIVING + END, 7),
    ],
)
def test_a_robot_stops_whatever_it_was_told_before(before: str, line: int) -> None:
    it = course(before)
    choose(it, *([MORE] if before else [MAKE]), DRIVE)
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    text = applied(before.encode(), look.outcome.edits)
    after = Session(text, environ={})
    assert after.diagnostics == ()
    assert look.outcome.session.document.text == text
    lines = text.decode().splitlines()
    assert [each for each in look.outcome.lines if each not in lines] == []
    assert [each for each in lines if " hz" in each] == []
    assert sum("LaserScan" in each for each in lines) == 1
    assert ["> 0.5" in each or "< 0.5" in each for each in lines if "'cmd_vel'" in each] == [
        True
    ] * 2
    said = f"That takes the place of line {line}, which drives whatever arrives"
    assert (said in strings.review(look)) == bool(line)
