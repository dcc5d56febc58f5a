"""The forms of what else a node does: what is entered, and the statement that comes of it."""

from __future__ import annotations

import pytest
from wizard_courses import (
    ANSWER,
    ASK,
    DO,
    HAVE,
    MAKE,
    MORE,
    REACT,
    REPEAT,
    SEND,
    choose,
    course,
    form_after,
    to_menu_or_review,
)

from plastron_tui.studio.wizard.flow import Course
from plastron_tui.studio.wizard.form import NEW, Form
from plastron_tui.studio.wizard.pages import Heard

ROBOT = """\
create_node 'robot' as robot using rclpy
robot has_parameter 'speed' of parameter_type float with default 0.5
robot has_parameter 'frame' of parameter_type string with default "map"
subscribe robot to 'scan' of message_type LaserScan
subscribe robot to 'go' of message_type Bool
create_message hello of message_type String and input "hello"
"""
GOAL = "have a task done, and hear how it goes"
GO = "publish hello to 'scan_2' of message_type String"


def written(it: Course) -> str:
    """The last statement that a form comes to, which is right."""
    look = it.look()
    assert look.problems == () and look.outcome is not None
    return look.filled[-1].text


def choices(it: Course, form: Form, slot: str, query: str = "") -> list[str]:
    filled = it.look().of(form)
    assert filled is not None
    return [each.text for each in it.choices(filled, slot, None, query)]


ENTERED = [
    (HAVE, {"type": "string", "default": "map"}, 'parameter_type string with default "map"'),
    (HAVE, {"type": "string", "default": 'a "b"'}, 'default "a \\"b\\""'),
    (HAVE, {"type": "bool", "default": "no"}, "parameter_type bool with default False"),
    (HAVE, {"type": "int_list", "default": "1, 2"}, "int_list with default [1, 2]"),
    (HAVE, {"type": "string_list", "default": "a, b"}, 'with default ["a", "b"]'),
    (HAVE, {"minimum": "0", "maximum": "2"}, "with default 0.5 between 0 and 2"),
    (HAVE, {"description": "how fast"}, 'with default 0.5 described_as "how fast"'),
    (SEND, {"message": "hello", "rate": "5"}, " at 5 hz"),
    (SEND, {"message": "hello", "rate": "parameter 'speed'"}, " at parameter 'speed' hz"),
    (SEND, {"message": "hello", "once": "once"}, "of message_type String once"),
    (SEND, {"message": "hello", "trigger": "go"}, "of message_type String for_each 'go'"),
    (
        SEND,
        {"message": "hello", "trigger": "go", "condition": "received.data = True"},
        "for_each 'go' when received.data = True",
    ),
    (
        SEND,
        {"message": "hello", "trigger": "scan", "condition": "any received.ranges < 0.5"},
        "for_each 'scan' when any received.ranges < 0.5",
    ),
    (SEND, {"message": "hello", "qos": "reliable, depth 5"}, " with qos reliable, depth 5"),
    (SEND, {"message": "hello", "qos": " "}, " at 10 hz"),
    (SEND, {"message": "hello", "qos": "reliable, "}, " with qos reliable"),
    (SEND, {"message": "hello", "once": "once", "qos": "latched"}, " once with qos latched"),
    (REACT, {"topic": "laser", "type": "LaserScan"}, "LaserScan with qos sensor_data"),
    (REACT, {"topic": "laser", "type": "String"}, "of message_type String"),
    (REACT, {"topic": "laser", "type": "LaserScan", "qos": ""}, "of message_type LaserScan"),
    (REPEAT, {"function": "blink", "rate": "2"}, "robot repeats blink at 2 hz"),
    (ASK, {}, "with input True"),
    (ASK, {"rate": "1"}, "with input True at 1 hz"),
    (DO, {}, "robot provides_action 'count' of action_type Fibonacci"),
    (GOAL, {}, "robot sends_goal to 'count' of action_type Fibonacci with input 5"),
    (
        ANSWER,
        {},
        "robot provides_service 'switch' of service_type SetBool answering True, \"done\"",
    ),
]


@pytest.mark.parametrize(("way", "entered", "end"), ENTERED)
def test_what_is_entered_is_written(way: str, entered: dict[str, str], end: str) -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, way)
    for slot, text in entered.items():
        form.enter(slot, text)
    assert written(it).endswith(end)


ANSWERS = [
    ({("sum",): ""}, "of service_type AddTwoInts"),
    ({}, "of service_type AddTwoInts answering received.a + received.b"),
    ({("sum",): "5"}, "of service_type AddTwoInts answering 5"),
    ({("sum",): "received.a + 1"}, "of service_type AddTwoInts answering received.a + 1"),
]


@pytest.mark.parametrize(("values", "end"), ANSWERS)
def test_an_answer_is_left_out_until_a_value_is_entered(
    values: dict[tuple[str, ...], str], end: str
) -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, ANSWER)
    form.enter("type", "AddTwoInts")
    form.values.update(values)
    assert written(it).endswith(end)


def test_values_may_come_of_parameters() -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, SEND)
    form.enter("message", NEW)
    form.enter("type", "Float64")
    (maker,) = it.look().filled[0].makers
    maker.form.values["data",] = "parameter 'speed' * 2"
    look = it.look()
    assert look.problems == ()
    assert look.filled[0].makers[0].text.endswith("and input parameter 'speed' * 2")


@pytest.mark.parametrize("last", ["rate", "once", "trigger"])
def test_of_clauses_that_exclude_each_other_the_last_one_that_is_entered_stays(last: str) -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, SEND)
    entered = {"rate": "5", "once": "once", "trigger": "go"}
    for slot in (*(each for each in entered if each != last), last):
        form.enter(slot, entered[slot])
    look = it.look()
    assert look.problems == ()
    filled = look.filled[0].cells
    assert [slot for slot in entered if filled[slot].text] == [last]


def test_a_node_that_reacts_goes_on_to_send_for_each_message() -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, REACT)
    form.enter("topic", "joy")
    form.enter("type", "Joy")
    look = it.look()
    heard = it.heard(look)
    assert heard == ("robot", "joy") and look.outcome is not None
    after = Course(look.outcome.session, it.surroundings)
    after.answer(heard)
    assert after.page.form is after.main_form is not None
    assert written(after).endswith(" for_each 'joy'")


def test_a_node_that_measures_distances_drives_until_something_is_near() -> None:
    scanning = "create_node 'eye' as eye\nsubscribe eye to 'scan' of message_type LaserScan\n"
    it = course(scanning + "generate_node eye\n")
    it.answer(Heard("eye", "scan"))
    look = to_menu_or_review(it)
    assert look.outcome is not None and look.problems == ()
    messages = look.outcome.session.workspace.messages
    assert list(messages) == ["cmd_vel_message", "halt"]
    sent = [line for line in look.outcome.lines if " publish " in line]
    to = "to 'cmd_vel' of message_type Twist for_each 'scan' when"
    assert sent == [
        f"eye publish cmd_vel_message {to} all received.ranges > 0.5",
        f"eye publish halt {to} any received.ranges < 0.5",
    ]
    assert "linear.x=0.2, angular.z=0.0" in look.outcome.lines[0]
    assert "linear.x=0.0, angular.z=0.0" in look.outcome.lines[2]
    assert [option.key for option in it.options(look)] == ["stop"]
    it.want("stop", False)
    alone = it.look().outcome
    assert alone is not None and len(alone.lines) == 2


def test_what_is_sent_when_something_is_near_stops() -> None:
    it = course("create_node 'eye' as eye\nsubscribe eye to 'scan' of message_type LaserScan\n")
    it.answer(Heard("eye", "scan"))
    assert it.main_form is not None
    it.main_form.enter("condition", "any received.ranges < 0.5")
    look = to_menu_or_review(it)
    assert look.outcome is not None and "halt" not in look.outcome.session.workspace.messages
    assert "input linear.x=0.0, angular.z=0.0" in look.outcome.lines[0]


def test_what_does_not_listen_leads_to_no_answer() -> None:
    it = course(ROBOT)
    form_after(it, MORE, SEND)
    assert it.heard(it.look()) is None


def test_a_clause_that_is_given_up_lets_the_suggestion_come_back() -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, SEND)
    form.enter("once", "once")
    assert it.look().filled[0].cells["rate"].text == ""
    form.enter("once", "")
    assert it.look().filled[0].cells["rate"].text == "10"


CHOICES = [
    (HAVE, {}, "type", "", ["bool", "int", "float", "string"]),
    (HAVE, {"type": "bool"}, "default", "", ["True", "False"]),
    (SEND, {}, "rate", "parameter", ["parameter 'speed'"]),
    (SEND, {}, "trigger", "", ["scan", "go"]),
    (SEND, {"trigger": "go"}, "condition", "", ["received.data = True"]),
    (SEND, {"trigger": "scan"}, "condition", "ranges", ["any received.ranges < 0.5"]),
    (
        SEND,
        {"trigger": "scan"},
        "condition",
        "",
        ["any received.ranges < 0.5", "all received.ranges > 0.5", "received.angle_min < 0.5"],
    ),
    (
        SEND,
        {"trigger": "scan"},
        "condition",
        "received.range",
        ["any received.ranges < 0.5", "received.range_min < 0.5", "received.range_max < 0.5"],
    ),
    (SEND, {"trigger": "scan"}, "condition", "ranges <= 0.3", ["any received.ranges < 0.3"]),
    (SEND, {"trigger": "scan"}, "condition", "all ranges>2", ["all received.ranges > 2"]),
    (SEND, {"trigger": "scan"}, "condition", "ranges[0] =", ["received.ranges[0] = 0.5"]),
    (SEND, {"trigger": "scan"}, "condition", "near", ["any received.ranges < 0.5"]),
    (SEND, {"type": "String"}, "qos", "", ["", "system_default", "latched", "reliable"]),
    (SEND, {"type": "Imu"}, "qos", "", ["", "sensor_data", "system_default"]),
    (SEND, {"type": "Imu"}, "qos", "reliable", ["reliable, sensor_data", "reliable, volatile"]),
    (SEND, {}, "qos", "reliable, dep", ["reliable, depth 5"]),
    (DO, {}, "type", "", ["Fibonacci"]),
]


@pytest.mark.parametrize(("way", "entered", "slot", "query", "expected"), CHOICES)
def test_choices_that_work(
    way: str, entered: dict[str, str], slot: str, query: str, expected: list[str]
) -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, way)
    form.enter("message", NEW)
    for name, text in entered.items():
        form.enter(name, text)
    found = choices(it, form, slot, query)
    places = [found.index(text) for text in expected]
    assert places == sorted(places) and places[0] == 0
    for text in found:
        form.enter(slot, text)
        assert it.blocking(it.look()) == (), text


CONDITIONS = [
    ("scan", "ranges < 0.3", "write `any received.ranges < 0.3`"),
    ("scan", "near", "such as `any received.ranges < 0.5`"),
    ("go", "data", "such as `received.data = True`"),
    ("go", "", None),
]


@pytest.mark.parametrize(("trigger", "text", "words"), CONDITIONS)
def test_a_condition_is_explained_with_a_field_of_what_arrives(
    trigger: str, text: str, words: str | None
) -> None:
    it = course(ROBOT)
    form = form_after(it, MORE, SEND)
    form.enter("trigger", trigger)
    form.enter("condition", text)
    found = [each.words for each in it.look().problems]
    assert (words is None and not found) or (words is not None and found[0].endswith(words))


def test_what_two_nodes_send_is_called_after_them() -> None:
    taken = "create_message go_message of message_type String and input none"
    it = course(f"create_node 'left' as left\n{taken}\n")
    form = form_after(it, MORE, SEND)
    for topic, message in (("away", "away_message"), ("go", "left_go_message")):
        form.entered = {"message": NEW, "topic": topic}
        assert it.look().filled[0].cells["message"].text == message


TYPES = [
    (SEND, "topic", "goal_pose", "PoseStamped"),
    (REACT, "topic", "robot/initialpose", "PoseWithCovarianceStamped"),
    (REACT, "topic", "something", "String"),
    (ANSWER, "service", "add", "AddTwoInts"),
    (ASK, "service", "math/add_two_ints", "AddTwoInts"),
]


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
@pytest.mark.parametrize(("way", "slot", "name", "type_"), TYPES)
def test_a_usual_name_brings_its_type(
    way: str, slot: str, name: str, type_: str, library: str
) -> None:
    it = course(f"create_node 'robot' as robot using {library}\n")
    form = form_after(it, MORE, way)
    form.enter(slot, name)
    look = it.look()
    assert look.problems == () and look.filled[0].cells["type"].text == type_


FIXED = [
    (ROBOT, [MORE, HAVE], {"type": "string"}, "minimum", "only a number has a range"),
    (ROBOT, [MORE, SEND], {}, "condition", "only with a trigger"),
    ("", [MAKE, SEND], {}, "trigger", "it listens to nothing yet"),
]


@pytest.mark.parametrize(("program", "ways", "entered", "slot", "reason"), FIXED)
def test_what_cannot_be_entered_says_why(
    program: str, ways: list[str], entered: dict[str, str], slot: str, reason: str
) -> None:
    it = course(program)
    choose(it, *ways)
    form = it.main_form
    assert form is not None
    form.entered.update(entered)
    filled = it.look().of(form)
    assert filled is not None and filled.cells[slot].reason == reason


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
def test_a_parameter_is_renamed_by_the_name_that_a_program_writes(library: str) -> None:
    it = course(ROBOT.replace("rclpy", library))
    form = form_after(it, MORE, "use another topic, or rename something")
    form.enter("what", "parameter")
    assert written(it) == "robot renames parameter 'speed' to 'speed_2'"
