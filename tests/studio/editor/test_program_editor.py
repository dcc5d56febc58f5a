from __future__ import annotations

import base64

import pytest
from editor_host import PROGRAM, editing
from textual.events import Key, Paste
from textual.geometry import Offset

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.session import Session


@pytest.mark.parametrize(
    ("keys", "after"),
    [
        (["right", "right", "shift+right"], "ab[c]\n  def\n"),
        (["down", "end"], "abc\n  def[]\n"),
        (["down", "end", "home"], "abc\n  []def\n"),
        (["down", "end", "home", "home"], "abc\n[]  def\n"),
        (["end", "down", "up"], "abc[]\n  def\n"),
        (["ctrl+end"], "abc\n  def\n[]"),
        (["ctrl+end", "ctrl+home"], "[]abc\n  def\n"),
        (["ctrl+right", "shift+end"], "abc[]\n  def\n"),
        (["shift+down", "shift+down"], "[abc\n  def\n]"),
        (["ctrl+a"], "[abc\n  def\n]"),
        (["ctrl+a", "left"], "[]abc\n  def\n"),
        (["ctrl+a", "escape"], "abc\n  def\n[]"),
        (["ctrl+shift+right", "x"], "x[]\n  def\n"),
        (["enter"], "\n[]abc\n  def\n"),
        (["delete", "delete"], "[]c\n  def\n"),
        (["end", "delete"], "abc[]  def\n"),
        (["down", "backspace"], "abc[]  def\n"),
        (["end", "ctrl+w"], "[]\n  def\n"),
        (["ctrl+delete"], "[]\n  def\n"),
        (["ctrl+k"], "[]  def\n"),
        (["ctrl+d"], "abc\n[]abc\n  def\n"),
        (["alt+down"], "  def\n[]abc\n"),
        (["down", "alt+up"], "[]  def\nabc\n"),
        (["ctrl+underscore"], "// []abc\n  def\n"),
        (["ctrl+underscore", "ctrl+underscore"], "[]abc\n  def\n"),
        (["x", "y", "ctrl+z"], "[]abc\n  def\n"),
        (["x", "y", "ctrl+z", "ctrl+y"], "xy[]abc\n  def\n"),
        (["shift+right", "ctrl+c", "end", "ctrl+v"], "abca[]\n  def\n"),
        (["shift+right", "ctrl+x", "end", "ctrl+v"], "bca[]\n  def\n"),
        (["ctrl+x", "down", "ctrl+v"], "  def\nabc\n[]"),
    ],
)
async def test_keys(keys: list[str], after: str) -> None:
    async with editing("abc\n  def\n") as at:
        await at.press(*keys)
        assert at.marked == after


async def test_page_keys_go_by_what_is_seen() -> None:
    async with editing("\n" * 100, size=(40, 11)) as at:
        await at.press("pagedown")
        assert at.editor.cursor_offset == 10
        await at.press("pagedown", "pageup", "shift+pagedown")
        assert at.editor.selection == (10, 20)
        await at.press("pageup", "pageup", "pageup")
        assert at.editor.cursor_offset == 0


async def test_copy_reaches_the_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    async with editing("日本\n") as at:
        written: list[str] = []
        monkeypatch.setattr(at.app._driver, "write", written.append)
        await at.press("shift+end", "ctrl+c")
        assert at.app.clipboard == "日本"
        encoded = base64.b64encode("日本".encode()).decode()
        assert f"\x1b]52;c;{encoded}\a" in written


async def test_messages_are_posted_for_edits_and_moves_only() -> None:
    async with editing("abc\n") as at:
        at.app.places.clear()
        await at.press("x")
        assert (at.app.changes, at.app.places) == (1, [1])
        await at.press("right")
        assert (at.app.changes, at.app.places) == (1, [1, 2])
        await at.press("ctrl+home", "up")
        assert at.app.places == [1, 2, 0]


async def test_line_endings_and_a_missing_last_newline_are_kept() -> None:
    async with editing("a\r\nb") as at:
        await at.press("enter", "ctrl+end", "x", "ctrl+d")
        assert at.editor.text == b"\r\na\r\nbx\r\nbx"


async def test_a_paste_is_one_step_to_undo() -> None:
    async with editing("a\r\nb\r\n", cursor=1) as at:
        at.editor.view.post_message(Paste("x\ny"))
        await at.pilot.pause()
        assert at.editor.text == b"ax\r\ny\r\nb\r\n"
        await at.press("ctrl+z")
        assert at.editor.text == b"a\r\nb\r\n"


async def test_a_megabyte_is_pasted_and_undone() -> None:
    lines = "create_node 'talker' as talker\n" * 35_000
    async with editing("// here\n") as at:
        at.editor.view.post_message(Paste(lines))
        await at.pilot.pause()
        assert at.editor.text.decode() == lines + "// here\n"
        assert at.editor.state.row == 35_000
        assert at.lines[-3].startswith(" 35000 create_node")
        await at.press("ctrl+z")
        assert at.editor.text == b"// here\n"


async def test_a_line_of_many_kilobytes_is_pasted_and_edited() -> None:
    async with editing("// here\n") as at:
        at.editor.view.post_message(Paste("日本 " * 20_000))
        await at.pilot.pause()
        await at.press("left", "left", "backspace", "x", "home", "end", "alt+z", "up", "down")
        assert at.editor.text.decode() == "日本 " * 19_999 + "x本 // here\n"


async def test_what_terminals_do_not_agree_on_is_shown_apart() -> None:
    family = "👩\u200d👩\u200d👧"
    async with editing(f"{family}x\n❤\ufe0fx\n") as at:
        assert at.lines[:2] == ["   1 👩👩👧x", "   2 ❤x"]
        await at.press("right", "y")
        assert at.editor.text.decode().startswith(f"{family}yx\n")


async def test_wide_characters_and_tabs_line_up() -> None:
    async with editing("日本\tx\né\n") as at:
        assert at.lines[0] == "   1 日本→   x"
        await at.press("end", "down")
        assert at.marked == "日本\tx\né[]\n"
        await at.press("home", "up", "right")
        assert at.editor.cursor_offset == 3


async def test_methods_of_the_app() -> None:
    async with editing("abc\ndef\n") as at:
        editor = at.editor
        editor.select_range(4, 7)
        assert at.marked == "abc\n[def]\n"
        editor.replace(Span(0, 3), "x")
        assert at.marked == "x\ndef[]\n"
        editor.apply([Edit(Span(0, 1), "one"), Edit(Span(2, 5), "two")])
        assert editor.text == b"one\ntwo\n"
        editor.undo()
        assert editor.text == b"x\ndef\n"
        editor.redo()
        editor.insert_statement("load a as b")
        assert at.marked == "one\ntwo\nload a as b[]\n"
        editor.replace_all(b"one\n2\nload a as b\n")
        assert editor.text == b"one\n2\nload a as b\n"
        editor.undo()
        assert editor.text == b"one\ntwo\nload a as b\n"
        editor.set_session(Session(b"new", environ={}))
        editor.undo()
        assert at.marked == "[]new"


async def test_what_is_typed_into_another_session_goes_there() -> None:
    async with editing("abc") as at:
        before = at.editor.session
        at.editor.set_session(Session(b"", environ={}))
        await at.press("x")
        assert (before.document.text, at.editor.text) == (b"abc", b"x")


async def test_the_mouse_selects() -> None:
    async with editing(PROGRAM) as at:
        view = at.editor.view
        await at.pilot.click(view, offset=Offset(5 + 12, 0))
        assert at.editor.cursor_offset == 12
        await at.pilot.click(view, offset=Offset(5 + 14, 0), times=2)
        assert at.editor.state.selected == b"talker"
        await at.pilot.click(view, offset=Offset(5 + 14, 1), times=3)
        assert at.editor.state.selected == PROGRAM.splitlines(keepends=True)[1].encode()
        await at.pilot.mouse_down(view, offset=Offset(5, 0))
        await at.pilot.hover(view, offset=Offset(5 + 6, 0))
        await at.pilot.mouse_up(view, offset=Offset(5 + 6, 0))
        assert at.editor.state.selected == b"create"
        await at.pilot.click(view, offset=Offset(60, 20))
        assert at.editor.cursor_offset == len(PROGRAM)


async def test_mistakes_are_marked_with_their_message() -> None:
    async with editing("generate_node node1\n", size=(80, 8)) as at:
        await at.understand()
        assert at.lines[0].startswith("●  1 generate_node node1   ● no node")
        assert at.editor.view.marks.between(0, 100)[0].start == 14


async def test_a_message_without_room_is_below_its_line() -> None:
    async with editing("generate_node node1\nload a as b\n", size=(36, 8)) as at:
        await at.understand()
        assert at.lines[0] == "●  1 generate_node node1"
        assert at.lines[1].startswith("       └ no node")
        assert at.lines[2].startswith("●  2 load a as b")
        await at.press("down")
        assert at.editor.cursor_offset == 20


async def test_problems_are_gone_through() -> None:
    async with editing("generate_node a\n\ngenerate_node b\n") as at:
        await at.understand()
        seen = []
        for key in ("f8", "f8", "f8", "shift+f8"):
            await at.press(key)
            seen.append(at.editor.cursor_offset)
        assert seen == [14, 31, 14, 31]


async def test_the_help_line_follows_the_cursor() -> None:
    async with editing(PROGRAM) as at:
        await at.press("ctrl+right")
        assert "create_node ‹'NODE_NAME'› as VARIABLE" in at.editor.statement_help
        await at.press("down", "end")
        assert "‹VALUES | none›" in at.editor.statement_help


async def test_long_lines_scroll_or_wrap() -> None:
    text = "// " + " ".join(str(number) for number in range(40)) + "\nload a as b\n"
    async with editing(text, size=(40, 10)) as at:
        await at.press("end")
        assert at.lines[0].endswith("39")
        await at.press("alt+z")
        assert at.lines[0].startswith("   1 // 0 1 2")
        assert at.lines[1].startswith("   ↪ ")
        end = at.editor.cursor_offset
        await at.press("down")
        assert at.editor.cursor_offset > end
        await at.press("up", "up")
        assert 0 < at.editor.cursor_offset < end


async def test_keys_that_come_all_at_once_keep_their_order() -> None:
    async with editing("") as at:
        for key, character in (("a", "a"), ("enter", "\r"), ("b", "b"), ("home", None), ("c", "c")):
            at.app.post_message(Key(key, character))
        await at.pilot.pause()
        await at.pilot.pause()
        assert at.marked == "a\nc[]b"


async def test_what_is_typed_right_after_a_key_is_for_the_bar_that_it_opens() -> None:
    async with editing("load a as b\n") as at:
        for key, character in (("ctrl+f", None), ("a", "a"), ("s", "s"), ("enter", "\r")):
            at.app.post_message(Key(key, character))
        await at.until(lambda: at.marked == "load a [as] b\n")


async def test_a_smaller_window_keeps_the_cursor_in_sight_but_does_not_go_to_it() -> None:
    text = "".join(f"// {number}\n" for number in range(100))
    async with editing(text, cursor=text.index("// 20"), size=(80, 30)) as at:
        for height in (12, 6, 20):
            await at.pilot.resize_terminal(60, height)
            await at.until(lambda: any("// 20" in line for line in at.lines))
        at.editor.view.scroll_to(0, 60, animate=False, immediate=True)
        await at.pilot.resize_terminal(60, 10)
        await at.pilot.pause()
        assert not any("// 20" in line for line in at.lines)
