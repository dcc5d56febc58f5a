"""What is offered while somebody types: it opens, is taken, scrolled and closed."""

from __future__ import annotations

import pytest
from editor_host import editing
from test_completion import PROGRAM
from textual.geometry import Offset


async def test_tab_takes_the_first() -> None:
    async with editing("") as at:
        await at.type("create_n")
        assert at.editor.popup.is_open
        await at.press("tab")
        assert at.marked == "create_node []"
        assert not at.editor.popup.is_open


async def test_the_blank_behind_a_word_is_there_once() -> None:
    async with editing(PROGRAM, cursor=len(PROGRAM)) as at:
        await at.understand()
        await at.type("ta")
        await at.press("tab", "tab")
        # What may follow is offered, as behind a blank that was typed.
        assert at.editor.text.endswith(b"talker publish ")
        await at.type(" hello to 'chatter' of message_type Str")
        await at.press("tab")
        assert at.editor.text.endswith(b"talker publish hello to 'chatter' of message_type String")
        await at.press("enter")
        await at.type("ta")
        await at.press("tab", "escape", "up")
        assert at.editor.text.endswith(b" String\ntalker")
        await at.press("ctrl+z")
        assert at.editor.text.endswith(b" String\nta")
        await at.press("tab", "enter")
        assert at.editor.text.endswith(b" String\ntalker\n")


async def test_enter_breaks_the_line_unless_an_entry_was_chosen() -> None:
    async with editing("") as at:
        await at.type("crea")
        await at.press("enter")
        assert at.editor.text == b"crea\n"
        await at.type("crea")
        await at.press("down", "enter")
        assert at.editor.text == b"crea\ncreate_message "


async def test_no_mistake_is_told_beside_an_open_list() -> None:
    text = "create_node 'a' az\n"
    async with editing(text, cursor=text.index(" az") + 2) as at:
        await at.understand()

        def line() -> str:
            return at.editor.view.render_line(0).text

        assert "● " in line()[4:]
        await at.press("ctrl+@")
        assert at.editor.popup.is_open and "● " not in line()[4:]
        await at.press("escape")
        assert "● " in line()[4:]


async def test_escape_closes_it_and_up_chooses_the_last() -> None:
    async with editing("") as at:
        await at.type("s")
        await at.press("escape")
        assert not at.editor.popup.is_open
        await at.press("ctrl+@", "up")
        current = at.editor.popup.current
        assert current is not None
        assert current == at.editor.popup.candidates[-1]


async def test_a_topic_brings_its_type() -> None:
    async with editing(PROGRAM, cursor=len(PROGRAM)) as at:
        await at.understand()
        await at.type("subscribe talker to 'ch")
        await at.press("tab")
        last = at.editor.text.decode().splitlines()[-1]
        assert last == "subscribe talker to 'chatter' of message_type String"


async def test_a_type_is_found_by_what_it_is_for_when_somebody_asks() -> None:
    async with editing("") as at:
        await at.type("create_message m of message_type child_frame")
        assert not at.editor.popup.is_open
        await at.press("f4")
        assert at.editor.popup.candidates[0].text == "TransformStamped"
        await at.press("tab")
        assert at.editor.text.decode().endswith("message_type TransformStamped ")


async def test_a_half_typed_type_is_no_type_of_the_topic() -> None:
    line = "subscribe talker to 'chatter' of message_type Str\n"
    for text in (line + PROGRAM, PROGRAM + line, line.replace("chatter", "new")):
        async with editing(text, cursor=text.index("Str\n") + 3) as at:
            await at.understand()
            await at.press("f4", "tab")
            assert "message_type String\n" in at.editor.text.decode()
            assert "message_type Str\n" not in at.editor.text.decode()


@pytest.mark.parametrize("quote", ["'", ""], ids=["closed", "open"])
async def test_within_quotes_only_the_name_is_replaced(quote: str) -> None:
    text = PROGRAM + f"subscribe talker to 'cha{quote} of message_type Point\n"
    async with editing(text, cursor=text.rindex("'cha") + 4) as at:
        await at.understand()
        await at.press("ctrl+@", "tab")
        last = at.editor.text.decode().splitlines()[-1]
        assert last == "subscribe talker to 'chatter' of message_type Point"


async def test_it_narrows_and_widens_with_the_word() -> None:
    async with editing("") as at:
        await at.type("stop")
        assert not at.editor.popup.is_open
        await at.press(*["backspace"] * 4)
        await at.type("c")
        wide = len(at.editor.popup.candidates)
        await at.type("reate_m")
        assert len(at.editor.popup.candidates) < wide
        await at.press(*["backspace"] * 7)
        assert len(at.editor.popup.candidates) == wide


async def test_it_is_drawn_by_the_word_within_the_view() -> None:
    async with editing("\n" * 30, size=(40, 10)) as at:
        await at.type("create_")
        assert at.lines[1].lstrip().startswith("create_node")
        await at.press("escape", "ctrl+end")
        await at.type("create_")
        row = next(y for y, line in enumerate(at.lines) if line.endswith("create_"))
        assert at.lines[row - 1].lstrip().startswith("create_")


async def test_a_click_takes_an_entry() -> None:
    async with editing("") as at:
        await at.type("create_")
        region = at.editor.popup.region
        await at.pilot.click(at.editor.view, offset=Offset(region.x + 2, region.y + 1))
        await at.pilot.pause()
        assert at.editor.text == b"create_message "


async def test_it_does_not_come_on_an_empty_line_or_by_moving() -> None:
    async with editing(PROGRAM) as at:
        await at.press("end", "enter")
        assert not at.editor.popup.is_open
        await at.press("down", "right")
        assert not at.editor.popup.is_open


async def test_taking_an_entry_is_one_step_to_undo() -> None:
    async with editing("") as at:
        await at.type("create_n")
        await at.press("tab", "ctrl+z")
        assert at.editor.text == b"create_n"


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("[]// a comment\n", "[]// a comment\n"),
        ("[]create_node 'a' as a\n", "[]create_node 'a' as a\n"),
        ("create_[]node 'a' as a\n", "create_[]node 'a' as a\n"),
        ("create_node 'a' []as a\n", "create_node 'a' []as a\n"),
        ("create_n[] 'a' as a\n", "create_node[] 'a' as a\n"),
        # A list, which writes nothing yet.
        ("create_node 'a' []", "create_node 'a' []"),
    ],
)
async def test_tab_completes_the_word_before_the_cursor_and_writes_nothing_else(
    text: str, after: str
) -> None:
    async with editing(text.replace("[]", ""), cursor=text.index("[]")) as at:
        await at.understand()
        await at.press("tab")
        assert at.marked == after
        assert at.editor.popup.is_open == text.endswith("[]")
