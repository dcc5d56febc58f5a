from __future__ import annotations

from pathlib import Path

import pytest
from hostile import OBEYED, PAYLOAD
from hypothesis import given, settings
from hypothesis import strategies as st
from rich.cells import cell_len
from studio_driver import studio
from textual.geometry import Offset, Size

from plastron_tui.diagnostics import Span
from plastron_tui.session import Session
from plastron_tui.studio.cards import Known, card_at
from plastron_tui.studio.editor.card import Card, CardRow, lines_of
from plastron_tui.studio.editor.card_box import place_card

PROGRAM = """\
create_node 'driver' as d using rclpy
create_message go of message_type Twist and input linear.x=0.2
d publish go to 'cmd_vel' of message_type Twist at 5 hz
d has_parameter 'speed' of parameter_type float with default 0.5
d provides_service 'add' of service_type AddTwoInts
create_node 'ear' as ear using rclpy
subscribe ear to 'cmd_vel' of message_type geometry_msgs/Twist with qos best_effort
subscribe ear to 'scan' of message_type LaserScan
create_node 'idle' as idle
create_package 'kit' as kit
kit contains d
create_launch 'all' as all
all starts d
create_robot 'rover' as rover
rover has_link 'base' shaped box 0.4, 0.3, 0.1 weighing 5
rover has_link 'wheel' shaped cylinder 0.1, 0.05
rover has_joint 'axle' of joint_type continuous from 'base' to 'wheel'
"""


def card_of(marked: str) -> Card | None:
    """The card at the `|` of a line that follows the program, or stands in it."""
    line = marked.replace("|", "", 1)
    text = PROGRAM if f"{line}\n" in PROGRAM else f"{PROGRAM}{line}\n"
    offset = text.index(f"{line}\n") + marked.index("|")
    known = Session(PROGRAM.encode(), environ={})
    session = Session(text.encode(), environ={})
    return card_at(Known(session, known.program, known.workspace), offset)


def said(card: Card | None) -> str:
    assert card is not None
    return "\n".join("".join(run.text for run in line) for line in lines_of(card, 70))


@pytest.mark.parametrize(
    ("marked", "title", "words"),
    [
        ("|create_node 'idle' as idle", "create_node  statement", "example  create_node 'talker'"),
        ("create_node 'id|le' as idle", "idle  node", "it does nothing yet"),
        ("create_node 'idle' as idle|", "idle  node", "library  rospy"),
        ("create_node 'driver' as d using rcl|py", "rclpy  client library", "language  Python"),
        ("create_message |go of message_type Twist and input linear.x=0.2", "go  message",
         "linear.x  0.2\nsent by   driver to cmd_vel"),
        ("create_message go of message_type Twi|st and input linear.x=0.2",
         "geometry_msgs/Twist  message type",
         "linear.x   float64 m/s, forward, below 0 backward"),
        ("create_message go of message_type Twist and input lin|ear.x=0.2",
         "geometry_msgs/Twist  message type", "driver publishes to cmd_vel"),
        ("|d publish go to 'cmd_vel' of message_type Twist at 5 hz", "driver  node",
         "publishes       cmd_vel geometry_msgs/Twist 5 times a second"),
        ("d pub|lish go to 'cmd_vel' of message_type Twist at 5 hz", "publish  statement",
         "Let a node send"),
        ("d publish go to 'cmd|_vel' of message_type Twist at 5 hz", "/cmd_vel  topic",
         "listens    ear best_effort"),
        ("subscribe ear to 'sc|an' of message_type LaserScan", "/scan  topic", "nobody publishes"),
        ("d provides_service 'a|dd' of service_type AddTwoInts", "/add  service", "nobody calls"),
        ("d provides_service 'add' of service_type Add|TwoInts",
         "example_interfaces/AddTwoInts  service type", "response:\nsum      int64"),
        ("d has_parameter 'sp|eed' of parameter_type float with default 0.5", "speed  parameter",
         "value  float · 0.5"),
        ("k|it contains d", "kit  package", "contains  d"),
        ("al|l starts d", "all  launch file", "starts  driver"),
        ("ro|ver has_link 'base' shaped box 0.4, 0.3, 0.1 weighing 5", "rover  robot",
         "root   base"),
        ("rover has_link 'b|ase' shaped box 0.4, 0.3, 0.1 weighing 5", "base  link of rover",
         "mass         5 kg"),
        ("rover has_joint 'ax|le' of joint_type continuous from 'base' to 'wheel'",
         "axle  joint of rover", "from   base\nto     wheel"),
        # Half-written lines: what is there already is known.
        ("subscribe ear to 'cmd_|", "/cmd_  topic", "nobody publishes"),
        ("subscribe |ea to", "subscribe  statement", "written"),
        ("d publish go to 'new|'", "/new  topic", "nobody listens"),
    ],
)  # fmt: skip
def test_what_a_card_says(marked: str, title: str, words: str) -> None:
    text = said(card_of(marked))
    assert text.splitlines()[0] == title
    assert words in text


@pytest.mark.parametrize("marked", ["// talk|er", "  |  ", "oops oops d|", "x" * 9000 + "|"])
def test_where_there_is_nothing_to_say(marked: str) -> None:
    assert card_of(marked) is None


def test_what_is_wrong_with_a_word_comes_first() -> None:
    text = f"{PROGRAM}subscribe ear to 'scan' of message_type LaserScn\n"
    session = Session(text.encode(), environ={})
    known = Known(session, session.program, session.workspace, session.diagnostics)
    card = card_at(known, text.index("LaserScn"))
    _, message, remedy, *_ = said(card).splitlines()
    assert message.startswith("no message type `LaserScn` is known")
    assert remedy == "did you mean `LaserScan`?"


def test_a_card_does_not_say_again_how_the_statement_is_written() -> None:
    text = f"{PROGRAM}subscribe ear 'scan' of message_type LaserScan\n"
    session = Session(text.encode(), environ={})
    known = Known(session, session.program, session.workspace, session.diagnostics)
    [wrong] = [each for each in session.diagnostics if "expected `to`" in each.message]
    assert wrong.help is not None and "the sentence is" in wrong.help
    words = said(card_at(known, text.rindex("'scan'") + 1))
    assert wrong.message in words
    assert "the sentence is" not in words


def test_a_card_is_about_the_word_at_the_place() -> None:
    session = Session(PROGRAM.encode(), environ={})
    known = Known(session, session.program, session.workspace)
    for offset, character in enumerate(PROGRAM):
        card = card_at(known, offset)
        if card is not None:
            assert card.span.start <= offset <= card.span.end
        # Every letter is of a word about which something can be said.
        assert card is not None or not character.isalpha()


TEXTS = st.text(st.sampled_from("ab c名\x1b\u202e"), max_size=30)


@settings(max_examples=50)
@given(
    st.lists(st.builds(CardRow, TEXTS, TEXTS, TEXTS, st.booleans()), max_size=5),
    TEXTS,
    st.integers(8, 60),
)
def test_a_card_fits_its_width(rows: list[CardRow], title: str, width: int) -> None:
    lines = lines_of(Card(Span(0, 1), title + PAYLOAD, "kind", tuple(rows)), width)
    for line in lines:
        text = "".join(run.text for run in line)
        assert cell_len(text) <= width
        assert not OBEYED.search(text)


@settings(max_examples=50)
@given(
    st.builds(Size, st.integers(10, 90), st.integers(1, 40)),
    st.tuples(st.integers(0, 89), st.integers(0, 39)),
    st.integers(-5, 45),
    st.builds(Size, st.integers(3, 72), st.integers(1, 60)),
)
def test_a_card_lies_beside_its_word_and_over_no_cursor(
    view: Size, word: tuple[int, int], cursor: int, wanted: Size
) -> None:
    at = Offset(min(word[0], view.width - 1), min(word[1], view.height - 1))
    wanted = Size(min(wanted.width, view.width), wanted.height)
    region = place_card(at, cursor, wanted, view)
    if region is None:
        return
    assert view.region.contains_region(region)
    assert region.y - 1 == at.y or region.bottom == at.y
    assert cursor not in region.line_range
    assert region.height == wanted.height or region.height >= 2


async def test_a_card_comes_when_asked_and_goes_with_a_key(tmp_path: Path) -> None:
    file = tmp_path / "a.plastron"
    file.write_text(PROGRAM)
    async with studio(file, (80, 24)) as driver:
        editor = driver.main.editor
        view, box = editor.view, editor.view.card
        editor.go_to(PROGRAM.index("Twist"))
        await driver.press("f1")
        assert box.card is not None
        shown = [view.render_line(y).text for y in range(view.size.height)]
        assert any("How fast to move and turn" in line for line in shown)
        assert shown[1].startswith("   2 create_message go of message_type Twist and input")
        # One that is longer than the window scrolls, and the cursor stays.
        await driver.press("down", "pagedown")
        assert box.card is not None
        assert editor.cursor_offset == PROGRAM.index("Twist")
        assert "again: help" in view.render_line(box.region.bottom - 1).text
        await driver.press("left")
        assert not box.is_open
        await driver.press("f1", "escape")
        assert not box.is_open
        await driver.press("f1", "ctrl+f")
        await driver.until(lambda: not box.is_open)


async def test_a_card_comes_where_the_mouse_rests(tmp_path: Path) -> None:
    file = tmp_path / "a.plastron"
    file.write_text(PROGRAM)
    async with studio(file, (80, 24)) as driver:
        view, box = driver.main.editor.view, driver.main.editor.view.card
        gutter = view.gutter_width
        await driver.pilot.hover("#editor-view", Offset(gutter + 14, 5))
        await driver.until(lambda: box.is_open)
        assert box.card is not None
        assert box.card.title == "ear"
        assert 0 not in box.region.line_range
        await driver.pilot.hover("#editor-view", Offset(gutter + 15, 5))
        assert box.is_open
        await driver.pilot.hover("#editor-view", Offset(gutter + 60, 5))
        await driver.until(lambda: not box.is_open)
        await driver.pilot.hover("#editor-view", Offset(gutter + 14, 5))
        await driver.until(lambda: box.is_open)
        await driver.press("right")
        assert not box.is_open
        await driver.pilot.hover("#editor-view", Offset(gutter + 14, 5))
        await driver.until(lambda: box.is_open)
        await driver.pilot.hover("#nodes")
        await driver.until(lambda: not box.is_open)
