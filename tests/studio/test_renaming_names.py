"""A name in the text can be another one: of what nodes meet at, of a parameter, of a function."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio

from plastron_tui.language import Document
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.session import Session
from plastron_tui.studio.analysis import Analysis, analyse
from plastron_tui.studio.named_entry import named_entry
from plastron_tui.studio.panels.entry import Entry
from plastron_tui.studio.renaming import fixed_name, renamed, wrong_name

FILE = """\
import rospy
from std_msgs.msg import String

def heard(message):
    pass

rospy.init_node('old')
rospy.Subscriber('pace', String, heard)
rospy.Subscriber('far', String, heard)
top = rospy.get_param('~top', 1)
rospy.spin()
"""
TEXT = """\
create_node 'one' as one
one has_parameter 'speed' of parameter_type float with default 1
create_message go of message_type String and input "hello"
create_message fast of message_type std_msgs/Float64 and input parameter 'speed'
one publish fast to 'rate' of message_type std_msgs/Float64
one publish go to 'pace' of message_type String
subscribe one to '/pace' of message_type String calling drive
one repeats tick at 5 hz
load 'old.py' as old  // it is old
old renames topic 'far' to 'near'
subscribe one to 'near' of message_type String calling listen
create_node 'two' as two
subscribe two to '~/pace' of message_type String calling drive
subscribe one to '~/pace' of message_type String calling more
generate_node one
"""
CASES = {
    "publish go to 'pace'": (
        "'walk'",
        ["go to 'walk'", "one to 'walk'", "old\nold renames topic 'pace' to 'walk'"],
        ["two to '~/pace'", "one to '~/pace'"],
    ),
    "two to '~/pace'": ("'~/walk'", ["two to '~/walk'"], ["one to '~/pace'", "go to 'pace'"]),
    "one to 'near'": ("'close'", ["'far' to 'close'", "one to 'close'"], ["renames topic 'far'"]),
    "'far' to 'near'": ("'close'", ["'far' to 'close'", "one to 'close'"], []),
    "one has_parameter 'speed'": ("'v'", ["has_parameter 'v'", "input parameter 'v'"], []),
    "input parameter 'speed'": ("'v'", ["has_parameter 'v'", "input parameter 'v'"], []),
    "String calling drive": ("go_on", ["'/pace' of message_type String calling go_on"], ["drive"]),
    "repeats tick": ("tock", ["one repeats tock at 5 hz"], []),
}


@pytest.fixture
def analysis(tmp_path: Path) -> Analysis:
    (tmp_path / "old.py").write_text(FILE)
    return analysed(TEXT, tmp_path)


def analysed(text: str, folder: Path) -> Analysis:
    session = Session(text.encode(), folder / "x.plastron", environ={})
    made = analyse(session, lambda: None)
    assert made.diagnostics == ()
    return made


def entry_at(analysis: Analysis, place: str) -> Entry | str | None:
    offset = TEXT.index(place) + len(place) - 2
    return named_entry(Document(TEXT.encode()), analysis.program, offset)


@pytest.mark.parametrize("place", CASES)
def test_a_name_is_another_one_wherever_it_is_meant(
    analysis: Analysis, tmp_path: Path, place: str
) -> None:
    new, changed, kept = CASES[place]
    new = new.strip("'")
    entry = entry_at(analysis, place)
    assert isinstance(entry, Entry)
    assert fixed_name(analysis, entry) is None and wrong_name(analysis, entry, new) is None
    text = TEXT
    edits = renamed(analysis, entry, new).edits
    for edit in sorted(edits, key=lambda each: each.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    analysed(text.replace("old  // it is old\n", "old\n"), tmp_path)
    text = text.replace("  // it is old", "")
    assert [each for each in (*changed, *kept) if each not in text] == []


@pytest.mark.parametrize(
    ("place", "why"),
    [
        ("topic 'far'", "`far` is the name in the file of `old`"),
        ("create_node 'one'", None),
        ("// it is old", None),
    ],
)
def test_what_the_program_does_not_name_is_told(
    analysis: Analysis, place: str, why: str | None
) -> None:
    assert entry_at(analysis, place) == why


def test_a_function_of_a_file_or_of_another_name_is_told(tmp_path: Path) -> None:
    (tmp_path / "old.py").write_text(FILE)
    text = "load 'old.py' as old\nsubscribe old to 'x' of message_type String calling heard\n"
    made = analysed(text, tmp_path)
    entry = named_entry(Document(text.encode()), made.program, text.index("heard") + 1)
    assert isinstance(entry, Entry)
    assert fixed_name(made, entry) == "`heard` is a function of old.py: rename it there"
    assert wrong_name(made, entry, "a b") is not None
    assert wrong_name(made, entry, "heard") == "`old` has a function `heard` already"


def test_a_private_name_in_a_file_is_that_of_its_node(tmp_path: Path) -> None:
    (tmp_path / "old.py").write_text(FILE.replace("'pace'", "'~pace'"))
    text = "load 'old.py' as mine\n"
    made = analysed(text, tmp_path)
    entry = Entry("", "~/pace", subject=EndpointKind.SUBSCRIPTION, node="mine", name="~/pace")
    (edit,) = renamed(made, entry, "~/walk").edits
    assert edit.text == "\nmine renames topic '~/pace' to '~/walk'"


async def test_the_box_says_how_many_places_have_the_name(program: Path) -> None:
    async with studio(program) as driver:
        driver.main.editor.go_to(PROGRAM.index("chatter"))
        await driver.pilot.press("f2")
        dialog = await driver.dialog("Prompt")
        assert str(dialog.query_one("#dialog-text").content) == "in 2 places of the program"
        await driver.pilot.press(*"news", "enter")
        await driver.back()
        assert driver.text == PROGRAM.replace("chatter", "news")
        # All lines with the name, in which the cursor's is the one at hand.
        await driver.pilot.press("alt+h")
        dialog = await driver.dialog("LineList")
        rows = dialog.query_one("#dialog-places")
        assert [str(each.prompt).split()[0] for each in rows.options] == ["3", "7"]
        await driver.pilot.press("down", "enter")
        await driver.back()
        place = driver.text.index("'news' of message_type String\ngenerate_node listener")
        assert driver.main.editor.cursor_offset == place
