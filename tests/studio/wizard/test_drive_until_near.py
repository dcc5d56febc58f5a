"""Driving until something is near: in one go, and in the order that comes to mind first."""

from __future__ import annotations

import pytest
from wizard_courses import MAKE, MORE, SEND, applied, choose, course, form_after, to_menu_or_review

from plastron_tui.session import Session
from plastron_tui.studio.wizard import strings
from plastron_tui.studio.wizard.pages import Heard

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
    said = f"Line {line} drives whatever arrives: with both, the robot would not stop."
    assert (said in strings.review(look)) == bool(line)
    assert "It does not notice when the laser falls silent." in strings.review(look)


def test_a_line_that_drives_on_stays_for_who_wants_that() -> None:
    before = NODE + DRIVING + HEARING + END
    it = course(before)
    choose(it, MORE, DRIVE)
    look = to_menu_or_review(it)
    box = it.options(look)[0]
    assert box.is_wanted and box.words == (
        "take the place of line 3: driver publish ahead to 'cmd_vel' of message_type Twist at 10 hz"
    )
    it.want(box.key, False)
    look = it.look()
    # It is told what comes of it, and may be written all the same.
    assert it.blocking(look) == () and look.outcome is not None
    assert strings.review(look).endswith("Line 3 drives whatever arrives: the robot will not stop.")
    text = applied(before.encode(), look.outcome.edits).decode()
    assert DRIVING in text and text.count("for_each 'scan'") == 2
    assert not it.options(look)[0].is_wanted


def test_the_proposal_after_the_laser_takes_the_place_of_what_drove() -> None:
    it = course(NODE + DRIVING + HEARING + END)
    it.answer(Heard("driver", "scan"))
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    assert look.outcome.replaced == (3,)
    assert b" hz" not in look.outcome.session.document.text


def test_to_drive_at_a_rate_beside_what_stops_is_refused() -> None:
    it = course(NODE + HEARING + END)
    choose(it, MORE, DRIVE)
    outcome = to_menu_or_review(it).outcome
    assert outcome is not None
    it = course(outcome.session.document.text.decode())
    form = form_after(it, MORE, SEND)
    form.enter("topic", "cmd_vel")
    form.enter("message", "cmd_vel_message")
    (problem,) = it.blocking(it.look())
    assert problem.message.endswith("whatever `scan` says: the robot does not stop")


def test_a_command_with_a_stamp_gives_way_as_well() -> None:
    before = (NODE + DRIVING + HEARING + END).replace("Twist", "TwistStamped")
    it = course(before.replace("linear.x", "twist.linear.x"))
    it.answer(Heard("driver", "scan"))
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    assert look.outcome.replaced == (3,)


FAR = "all received.ranges > "


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("any received.ranges < 1", FAR + "1"),
        ("ranges<=.5", FAR + ".5"),
        ("< 1", FAR + "1"),
        ("", FAR + "0.5"),
        ("12", FAR + "12"),
        ("> 0.8 m", FAR + "0.8"),
        ("any received.ranges > 2", FAR + "2"),
        ("received.ranges[0] < 1", "received.ranges[0] > 1"),
    ],
)
def test_when_it_stops_is_taken_for_when_it_drives(text: str, condition: str) -> None:
    it = course("")
    form = form_after(it, MAKE, DRIVE)
    form.enter("condition", text)
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    assert look.filled[-1].cells["condition"].text == condition
    written = "\n".join(look.outcome.lines)
    stops = condition.replace("all ", "any ").replace(">", "<")
    assert f"when {condition}\n" in written and f"when {stops}" in written
    assert "input linear.x=0.2" in written and "linear.x=0.0" in written
    assert "never drives" not in strings.review(look)


def test_only_distances_are_driven_by() -> None:
    hearing = "subscribe driver to 'battery_state' of message_type sensor_msgs/BatteryState\n"
    it = course(NODE + hearing + HEARING)
    form = form_after(it, MORE, DRIVE)

    def choices(slot: str, query: str = "") -> list[str]:
        filled = it.look().of(form)
        assert filled is not None
        return [each.text for each in it.choices(filled, slot, None, query)]

    assert choices("condition") == [FAR + each for each in ("0.5", "0.3", "1", "2")]
    assert choices("condition", "< 0.8")[:2] == [FAR + "0.8", FAR + "0.5"]
    assert "battery_state" not in choices("trigger") and choices("trigger")[0] == "scan"
    for slot, text, words in [
        ("condition", "received.angle_min < 0.5", f"such as `{FAR}0.5`"),
        ("trigger", "battery_state", "does not say how far away things are"),
    ]:
        kept = form.entered.copy()
        form.enter(slot, text)
        assert words in it.blocking(it.look())[0].words
        form.entered = kept


def test_only_a_type_with_distances_is_taken_for_what_is_heard() -> None:
    it = course("")
    form = form_after(it, MAKE, DRIVE)
    it.look()
    form.makers["trigger"].enter("type", "Image")
    words = [each.message for each in it.look().problems]
    assert "`Image` does not say how far away things are: take LaserScan or Range" in words


def test_the_fields_of_driving_say_what_they_mean_there() -> None:
    it = course(NODE + HEARING)
    form = form_after(it, MORE, DRIVE)
    filled = it.look().of(form)
    assert filled is not None
    helps = it.helps(filled)
    assert helps["condition", None].startswith("it drives as long as this holds")
    assert helps["rate", None].endswith("as it is sent for each message of `scan`")
    assert helps["message", None].endswith("; a later page asks what a new one says")


def test_a_robot_that_would_never_drive_is_told() -> None:
    it = course("")
    form = form_after(it, MAKE, DRIVE)
    it.look()
    message = form.makers["message"]
    message.values[("linear", "x")] = "0"
    look = to_menu_or_review(it)
    assert strings.review(look).count("With this it never drives") == 1
