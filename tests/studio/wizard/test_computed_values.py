"""Values that a node computes: what a field of a message offers, and what is told at it."""

from __future__ import annotations

import pytest
from wizard_courses import (
    ANSWER,
    ASK,
    MESSAGE,
    MORE,
    SEND,
    course,
    form_after,
)

from plastron_tui.studio.wizard.filling import Filled
from plastron_tui.studio.wizard.flow import Course
from plastron_tui.studio.wizard.form import NEW, Form

DRIVER = """\
create_node 'driver' as driver using rclpy
driver has_parameter 'speed' of parameter_type float with default 0.5
driver has_parameter 'frame' of parameter_type string with default "map"
subscribe driver to 'joy' of message_type Joy
subscribe driver to 'fix' of message_type NavSatFix
"""
SPEED = "parameter 'speed'"
OFFERED = [
    ("Twist", ("linear", "x"), "", [SPEED]),
    ("Twist", ("linear", "x"), "joy", [SPEED, "received.axes[0]", "received.buttons[0]"]),
    ("TwistStamped", ("header", "frame_id"), "joy", ["parameter 'frame'",
                                                     "received.header.frame_id"]),
    ("Bool", ("data",), "joy", []),
    ("Float64", ("data",), "fix", [SPEED, "received.latitude"]),
    ("Float32MultiArray", ("data",), "joy", ["received.axes"]),
    ("Time", ("sec",), "joy", ["received.buttons[0]", "received.header.stamp.sec"]),
]  # fmt: skip


def values_of(it: Course, form: Form) -> Filled:
    """What is in the form of the values: its own, or that of the message it needs."""
    (filled,) = it.look().filled
    return filled.makers[0] if filled.makers else filled


def driving(type_: str, trigger: str) -> tuple[Course, Filled]:
    """The form of a new message that the driver sends."""
    it = course(DRIVER)
    form = form_after(it, MORE, SEND)
    for slot, text in (("message", NEW), ("topic", "out"), ("type", type_), ("trigger", trigger)):
        form.enter(slot, text)
    return it, values_of(it, form)


@pytest.mark.parametrize(("type_", "path", "trigger", "expected"), OFFERED)
def test_fields_offer_what_they_can_be_computed_of(
    type_: str, path: tuple[str, ...], trigger: str, expected: list[str]
) -> None:
    it, filled = driving(type_, trigger)
    offered = [each.text for each in it.choices(filled, "input", path, "")]
    assert offered[: len(expected)] == expected
    assert bool(offered) == bool(expected)
    for text in offered:
        filled.form.values[path] = text
        assert it.blocking(it.look()) == (), text


def test_an_answer_offers_what_is_asked() -> None:
    it = course(DRIVER)
    form = form_after(it, MORE, ANSWER)
    form.enter("type", "AddTwoInts")
    filled = values_of(it, form)
    offered = [each.text for each in it.choices(filled, "answer", ("sum",), "")]
    assert offered == ["received.a + received.b", "received.a", "received.b"]
    help_ = it.helps(filled)["answer", ("sum",)]
    assert help_.endswith(", or `received.a + received.b`: both together")
    for text in offered:
        filled.form.values["sum",] = text
        assert it.blocking(it.look()) == (), text


def test_a_message_that_nobody_sends_yet_offers_what_there_is() -> None:
    it = course(DRIVER)
    form = form_after(it, MESSAGE)
    form.enter("type", "Float64")
    (filled,) = it.look().filled
    offered = [each.text for each in it.choices(filled, "input", ("data",), "")]
    assert offered[:2] == [SPEED, "received.axes[0]"]


EXAMPLE = "or `parameter 'speed'` or `received.axes[0] * 0.5`"
MEANT = [
    ("parameter speed", "write `parameter 'speed'`"),
    ('parameter "speed"', "write `parameter 'speed'`"),
    ("speed * 2", "write `parameter 'speed' * 2`"),
    ("axes[1] * 0.5", "write `received.axes[1] * 0.5`"),
    ("joy.axes[1]", "write `received.axes[1]`"),
    ("received.axes(1)", "write `received.axes[1]`"),
    ("0.5 * received.axes[1] + 1", "write `received.axes[1] * 0.5 + 1`"),
    ("-axes[1]", "write `received.axes[1] * -1`"),
    ("2 - axes[1] * 3", "write `received.axes[1] * -1 * 3 + 2`"),
    ("axes[1] * speed - 1", "write `received.axes[1] * parameter 'speed' - 1`"),
    ("joy.axes[1] + axes[0]", "write `received.axes[1] + received.axes[0]`"),
    ("received.axes[1] * received.axis[0]", "did you mean `axes`?"),
    ("received.axes[1] * parameter 'frame'", "`parameter 'frame'` is a text"),
    ("(received.axes[1] + 1) * 2", "a calculation has no brackets"),
    ("fast", f"x takes a number, such as 0.5, {EXAMPLE}"),
    ("parameter", f"x takes a number, such as 0.5, {EXAMPLE}"),
    ("(1, 2)", f"x takes a number, such as 0.5, {EXAMPLE}"),
    ("1e999", "the number is too large"),
    ("received.axis[1]", "did you mean `axes`?"),
    ("parameter 'sped'", "did you mean `speed`?"),
    ("received.axes", "`received.axes` is a list of numbers"),
]


@pytest.mark.parametrize(("text", "words"), MEANT)
def test_what_is_written_in_another_way_is_told_at_its_field(text: str, words: str) -> None:
    it, filled = driving("Twist", "joy")
    filled.form.values["linear", "z"] = "received.axes[0]"
    filled.form.values["linear", "x"] = text
    (finding,) = it.look().problems
    assert words in finding.words
    assert (finding.form, finding.path) == (filled.form, ("linear", "x"))


def test_a_value_of_a_request_is_refused_at_its_field() -> None:
    it = course(DRIVER)
    form = form_after(it, MORE, ASK)
    form.enter("type", "AddTwoInts")
    form.values.update({("a",): "5", ("b",): SPEED})
    (finding,) = it.look().problems
    assert finding.message.startswith("`parameter 'speed'` is a number") and finding.path == ("b",)
