"""What the wizard refuses, and the words that it finds for it."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import (
    ANSWER,
    ASK,
    AWAY,
    CHANGE,
    DO,
    HAVE,
    MAKE,
    MESSAGE,
    MORE,
    NODE_FILE,
    REACT,
    REPEAT,
    SEND,
    TWO_NODES,
    choose,
    course,
    form_after,
)
from wizard_driver import wizard

from plastron_tui.studio.wizard.flow import Course
from plastron_tui.studio.wizard.form import NEW
from plastron_tui.studio.wizard.pages import PageKind

REFUSED = [
    ([MAKE], "name", "", "a node needs a name"),
    ([MAKE], "name", "my talker", "white space: write my_talker"),
    ([MAKE], "name", "1st", "starts with a letter: write node_1st"),
    ([MAKE], "name", "talker", "a node `talker` exists already"),
    ([MAKE], "name", "a'b", "no `'`"),
    ([MAKE], "variable", "", "needs a name"),
    ([MAKE], "variable", "1st", "a variable starts with a letter"),
    ([MAKE], "variable", "a b", "and no space"),
    ([MAKE], "variable", "publish", "a word of the language"),
    ([MAKE], "variable", "talker", "a node is called `talker` already"),
    ([MAKE], "variable", "greeting", "a message is called `greeting` already"),
    ([MAKE], "library", "ros2", "there is no client library `ros2`"),
    ([MORE, SEND], "node", "", "choose one with ↓"),
    ([MORE, SEND], "message", "Bool", "`Bool` is a type: take `a new message` here"),
    ([MORE, SEND], "message", "", "take `a new message`"),
    ([MORE, SEND], "node", "tolker", "there is no node `tolker`"),
    ([MORE, SEND], "message", "gretting", "there is no message `gretting`"),
    ([MORE, SEND], "topic", "", "a topic needs a name, such as `chatter`"),
    ([MORE, SEND], "topic", "a topic", "white space: write a_topic"),
    ([MORE, SEND], "type", "", "write what it is for"),
    ([MORE, SEND], "type", "Strnig", "did you mean `String`?"),
    ([MORE, SEND], "type", "a b", "no type is called that"),
    ([MORE, SEND], "type", "distance", "no type is called that: choose one with ↓"),
    ([MORE, SEND], "type", "Goal", "no message type `Goal` is known in ROS 1 noetic"),
    ([MORE, SEND], "rate", "often", "a number of times a second"),
    ([MORE, SEND], "rate", "0", "more than 0"),
    ([MORE, SEND], "rate", "0.0000000001", "once in thirty years"),
    ([MORE, REACT], "function", "on chatter", "and no space"),
    ([MORE, REACT], "function", "def", "keyword of Python"),
    ([MORE, REACT], "function", "publish", "a word of the language"),
    ([MORE, ASK], "service", "", "a service needs a name, such as `switch`"),
    ([MORE, ASK], "type", "String", "`String` is a message type"),
    ([MORE, ANSWER], "service", "switch", "provides `switch` already"),
    ([MORE, SEND], "rate", "parameter 'speed'", "`listener` has no parameter `speed`"),
    ([MORE, SEND], "qos", "relaible", "did you mean `reliable`?"),
    ([MORE, SEND], "qos", "depth", "`depth` lacks its number"),
    ([MORE, SEND], "qos", "depth 5, depth 6", "`depth` is there twice"),
    ([MORE, HAVE], "parameter", "", "a parameter needs a name, such as `speed`"),
    ([MORE, HAVE], "type", "double", "no such type: choose one with ↓"),
    ([MORE, HAVE], "default", "fast", "default takes a number, such as 0.5"),
    ([MORE, HAVE], "default", "", "a value is needed, such as 0.5"),
    ([MORE, REPEAT], "function", "", "a function is needed, such as `tick`"),
    ([MORE, REPEAT], "function", "a b", "and no space"),
    ([MORE, REPEAT], "rate", "", "a number of times a second"),
    ([MORE, DO], "action", "", "an action needs a name, such as `count`"),
    ([MORE, DO], "type", "String", "`String` is a message type"),
    ([MESSAGE], "variable", "talker", "a node is called `talker` already"),
    ([MESSAGE], "type", "SetBool", "`SetBool` is a service type"),
    ([CHANGE], "source", "", "write the path of one"),
    ([CHANGE], "source", "other.py", "no file `other.py` beside the program"),
    ([CHANGE], "source", "it's.py", "no single quote"),
    ([CHANGE], "source", "notes.txt", "imports neither rospy nor rclpy"),
]


@pytest.mark.parametrize(("ways", "slot", "text", "words"), REFUSED)
def test_what_cannot_be_is_refused_with_the_reason(
    tmp_path: Path, ways: list[str], slot: str, text: str, words: str
) -> None:
    (tmp_path / "sonar.py").write_text(NODE_FILE)
    (tmp_path / "notes.txt").write_text("rospy is fine")
    it = course(TWO_NODES, tmp_path)
    choose(it, *ways)
    assert it.page.form is not None and it.blocking(it.look()) == ()
    it.page.form.entered[slot] = text
    found = it.blocking(it.look())
    assert [each.slot for each in found] == [slot]
    assert words in found[0].words


TOGETHER = [
    ([MORE, HAVE], {"minimum": "0"}, "maximum", "it is needed along with `minimum`"),
    ([MORE, HAVE], {"maximum": "1"}, "minimum", "it is needed along with `maximum`"),
    ([MORE, HAVE], {"minimum": "low", "maximum": "1"}, "minimum", "minimum takes a number"),
    ([MORE, HAVE], {"minimum": "2", "maximum": "1"}, "minimum", "2 is greater than 1"),
    ([MORE, HAVE], {"minimum": "1", "maximum": "2"}, "default", "not between"),
    ([MORE, SEND], {"rate": "5", "once": "once"}, "once", "it does not go with `rate`"),
    ([MORE, SEND], {"rate": "5", "trigger": "chatter"}, "trigger", "does not go with `rate`"),
    ([MORE, SEND], {"once": "once", "trigger": "chatter"}, "trigger", "does not go with `once`"),
    ([MORE, SEND], {"trigger": "scan"}, "trigger", "does not listen to `scan`, but to chatter"),
    (
        [MORE, SEND],
        {"node": "talker", "trigger": "scan"},
        "trigger",
        "`talker` listens to no topic",
    ),
    ([MORE, SEND], {"trigger": "chatter", "condition": "data"}, "condition", "compares a field of"),
]


@pytest.mark.parametrize(("ways", "entered", "slot", "words"), TOGETHER)
def test_what_does_not_go_together_is_refused(
    ways: list[str], entered: dict[str, str], slot: str, words: str
) -> None:
    it = course(TWO_NODES)
    form = form_after(it, *ways)
    form.entered.update(entered)
    found = it.blocking(it.look())
    assert [each.slot for each in found] == [slot]
    assert words in found[0].words


VALUES = [
    ("Int32", ("data",), "many", "data takes a whole number, such as 5"),
    ("Int32", ("data",), "1.5", "not a whole number"),
    ("UInt8", ("data",), "256", "256 does not fit `uint8` (0 to 255)"),
    ("Float64", ("data",), "fast", "data takes a number, such as 0.5"),
    ("Float32", ("data",), "1e39", "does not fit `float32`"),
    ("Bool", ("data",), "maybe", "either True or False"),
    ("Twist", ("linear", "x"), "x", "x takes a number"),
    ("LaserScan", ("ranges",), "1, far", "value 2 of the list"),
    ("Odometry", ("pose", "covariance"), "1, 2", "`covariance` has 36 values, not 2"),
    ("Path", ("poses",), "(1", "a `)` is missing at the end"),
    ("Path", ("poses",), "(1))", "one `)` more"),
    ("Path", ("poses",), '[header.frame_id=")"]', "in parentheses, with commas between: (header"),
    ("Path", ("poses",), "(seq=1), 5", "parentheses, with commas between: (field=value), (…)"),
    (
        "TFMessage",
        ("transforms",),
        "5",
        "write each message in parentheses, with commas between: (5), (…)",
    ),
]


@pytest.mark.parametrize(("type_", "path", "text", "words"), VALUES)
def test_a_value_that_does_not_fit_is_refused_at_its_field(
    type_: str, path: tuple[str, ...], text: str, words: str
) -> None:
    it = course("")
    form = form_after(it, MESSAGE)
    form.entered["type"] = type_
    form.values[path] = text
    found = it.blocking(it.look())
    assert len(found) == 1
    assert words in found[0].words
    assert (found[0].slot, found[0].path) in (("input", path), ("", None))


def closed(it: Course, slot: str) -> dict[str, str]:
    form = it.page.form
    assert form is not None
    filled = it.look().of(form)
    assert filled is not None
    choices = it.choices(filled, slot, None, "")
    return {choice.text: choice.closed for choice in choices}


def test_a_choice_that_another_one_closes_says_why() -> None:
    numbers = TWO_NODES + "create_message number of message_type Int32 and input 5\n"
    it = course(numbers)
    form = form_after(it, MORE, SEND)
    form.entered["topic"] = "chatter"
    assert "`chatter` is of type `std_msgs/String` elsewhere" in closed(it, "message")["number"]
    assert closed(it, "message")["greeting"] == ""
    form.entered = {"message": "number"}
    assert "is of type `std_msgs/String` elsewhere" in closed(it, "topic")["chatter"]
    filled = it.look().of(form)
    assert filled is not None
    assert filled.cells["type"].text == "Int32"
    assert filled.cells["type"].reason == "because `number` is one"
    form.entered = {"message": NEW, "topic": "chatter"}
    filled = it.look().of(form)
    assert filled is not None
    assert filled.cells["type"].reason == "because `chatter` has it already"


def test_a_node_that_has_it_already_is_closed() -> None:
    it = course(TWO_NODES)
    form = form_after(it, MORE, REACT)
    form.entered = {"node": "listener"}
    assert closed(it, "topic")["chatter"] == "`listener` subscribes to `chatter` already"
    form.entered = {"topic": "chatter"}
    assert closed(it, "node")["listener"] == "`listener` subscribes to `chatter` already"
    # Another node is suggested then.
    filled = it.look().of(form)
    assert filled is not None and filled.cells["node"].text == "talker"


def test_a_mistake_in_another_row_closes_nothing() -> None:
    it = course(TWO_NODES)
    form = form_after(it, MORE, SEND)
    form.entered = {"message": "NavSatFix"}
    assert closed(it, "node") == {"listener": "", "talker": "", NEW: ""}
    # What is closed by the choice itself stays closed, though it is the only one.
    form.entered = {"topic": "chatter"}
    it = course("create_message number of message_type Int32 and input 5\n" + TWO_NODES)
    form = form_after(it, MORE, SEND)
    form.entered = {"topic": "chatter"}
    assert "`chatter` is of type" in closed(it, "message")["number"]


SPOILT = """\
create_node 'ears' as ears
subscribe ears to 'cmd_vel' of message_type Twist
ears provides_service 'sum' of service_type AddTwoInts
create_node 'eye' as eye
eye has_parameter 'rate' of parameter_type float with default 1
"""
WRONG = [
    (SEND, {"qos": "joy"}, "topic", "cmd_vel"),
    (SEND, {"rate": "1 hz"}, "topic", "cmd_vel"),
    (SEND, {"rate": "1 hz", "qos": "joy"}, "topic", "cmd_vel"),
    (SEND, {"message": "nothing"}, "topic", "cmd_vel"),
    (SEND, {"message": NEW, "variable": "1st"}, "topic", "cmd_vel"),
    (SEND, {"message": NEW, "linear.x": "fast"}, "topic", "cmd_vel"),
    (ASK, {"rate": "1 hz"}, "service", "sum"),
    (ASK, {"a": "many"}, "service", "sum"),
]


@pytest.mark.parametrize(("way", "wrong", "slot", "suggested"), WRONG)
def test_a_mistake_in_one_row_changes_no_suggestion_of_another(
    way: str, wrong: dict[str, str], slot: str, suggested: str
) -> None:
    it = course(SPOILT)
    form = form_after(it, MORE, way)
    slots = {each.name for each in form.declaration.slots}
    form.entered = {name: text for name, text in wrong.items() if name in slots}
    makers = it.look().filled[0].makers
    for name, text in wrong.items():
        if name == "variable":
            makers[0].form.entered[name] = text
        elif name not in slots:
            (makers[0].form if makers else form).values[tuple(name.split("."))] = text
    look = it.look()
    assert look.problems and look.filled[0].cells[slot].text == suggested


def test_what_would_leave_a_node_idle_is_closed() -> None:
    it = course(TWO_NODES.replace("talker client", "// talker client"))
    choose(it, MORE, AWAY)
    offers = {offer.title: offer.closed for offer in it.offers()}
    # Of what no node does there is nothing to be seen.
    assert "no longer ask a question" not in offers
    assert offers["no longer react to what others send"] == ""
    one = "create_node 'a' as a\nsubscribe a to 'x' of message_type String\ngenerate_node a\n"
    it = course(one)
    choose(it, MORE)
    closed = {offer.title: offer.closed for offer in it.offers()}
    assert closed[AWAY] == "there is nothing yet that can go"
    it.choose_what_goes()
    offers = {offer.title: offer.closed for offer in it.offers()}
    assert offers["no longer react to what others send"] == (
        "`x` has to stay: "
        "the node would have nothing left to do, and could not be written to its file"
    )


def test_menus_say_what_is_missing() -> None:
    offers = {offer.title: offer.closed for offer in course("").offers()}
    assert offers[MORE] == "there is no node yet: make one first"
    assert offers["write a node to its file"] == "there is no node yet: make one first"
    assert offers[MAKE] == offers[CHANGE] == offers[MESSAGE] == ""


async def test_next_is_refused_on_the_screen_and_says_why(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MAKE)
        await it.write("name", "1st")
        assert it.help == "✗ a name starts with a letter: write node_1st"
        await it.go_to("variable")
        assert "what this text calls the node" in it.help
        await it.press("enter")
        assert it.kind is PageKind.FORM and it.form.row_here is it.row("name")
        assert it.help.startswith("✗ a name starts with a letter")
        await it.click("#wizard-next")
        assert it.kind is PageKind.FORM
        await it.write("name", "first")
        assert it.rows["variable"] == "first"
        await it.press("enter")
        assert it.kind is PageKind.PURPOSE


async def test_a_value_is_refused_on_the_screen(here: Path) -> None:
    async with wizard() as it:
        await it.pick(MESSAGE)
        await it.write("type", "Int8")
        assert it.statements == ("create_message message of message_type Int8 and input 5",)
        await it.write("data", "200")
        assert it.help == "✗ 200 does not fit `int8` (-128 to 127)"
        await it.press("enter")
        assert it.kind is PageKind.FORM
        await it.write("data", "-7")
        await it.press("enter")
        assert it.statements == ("create_message message of message_type Int8 and input -7",)


async def test_a_closed_entry_cannot_be_clicked(here: Path) -> None:
    async with wizard() as it:
        await it.click_item(MORE)
        assert it.kind is PageKind.START
