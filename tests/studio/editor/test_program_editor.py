from __future__ import annotations

import base64
import tempfile
from contextlib import nullcontext
from pathlib import Path

import pytest
from editor_host import editing
from textual.color import Color
from textual.events import Key, Paste
from textual.geometry import Offset
from textual.widgets import Label

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.session import Session
from plastron_tui.studio.editor.palette import contrast

PROGRAM = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String
"""


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
        editor.select(Span(4, 7))
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
        assert at.lines[1].startswith("     ")
        end = at.editor.cursor_offset
        await at.press("down")
        assert at.editor.cursor_offset > end
        await at.press("up", "up")
        assert 0 < at.editor.cursor_offset < end


class TestFinding:
    async def test_find_selects_and_goes_around(self) -> None:
        async with editing(PROGRAM) as at:
            await at.press("ctrl+f")
            await at.type("string")
            assert at.editor.state.selected == b"String"
            first = at.editor.selection.start
            await at.press("enter")
            assert at.editor.selection.start > first
            await at.press("enter")
            assert at.editor.selection.start == first
            await at.press("escape", "x")
            assert at.editor.text.startswith(PROGRAM[:first].encode() + b"x")

    async def test_case_can_matter(self) -> None:
        async with editing("a A a\n") as at:
            await at.press("ctrl+f", "A", "alt+c")
            assert at.editor.search.spans == [(2, 3)]

    async def test_replace_one_and_all_with_groups(self) -> None:
        async with editing("ab ab ab\n") as at:
            await at.press("ctrl+r")
            await at.type("(a)(b)")
            await at.press("alt+r", "tab", *("backslash", "2", "backslash", "1"), "enter")
            assert at.editor.text == b"ba ab ab\n"
            await at.press("alt+a")
            assert at.editor.text == b"ba ba ba\n"
            at.editor.undo()
            assert at.editor.text == b"ba ab ab\n"

    async def test_lines_are_commented_by_an_expression(self) -> None:
        async with editing("a\r\nb\r\n") as at:
            await at.press("ctrl+r", "circumflex_accent", "alt+r", "tab", "x", "enter")
            assert at.editor.text == b"xa\r\nb\r\n"
            await at.press("enter")
            assert at.editor.text == b"xa\r\nxb\r\n"

    async def test_a_group_that_is_not_there_is_said(self) -> None:
        async with editing("ab\n") as at:
            await at.press("ctrl+r", "a", "alt+r", "tab", "backslash", "7", "alt+a")
            label = at.editor.find_bar.query_one("#find-count", Label)
            assert "invalid group reference" in str(label.content)
            assert at.editor.text == b"ab\n"

    async def test_keys_of_the_editor_leave_the_text_alone_while_something_is_asked(self) -> None:
        async with editing("ab\nab\n") as at:
            for key in ("ctrl+f", "ctrl+r", "ctrl+g"):
                await at.press(key, "tab", "ctrl+d", "alt+down", "ctrl+l", "ctrl+underscore")
                await at.press("ctrl+a", "ctrl+k", "backspace", "escape")
                assert at.editor.text == b"ab\nab\n"
                assert at.editor.view.has_focus

    async def test_the_buttons_leave_the_focus_where_one_types(self) -> None:
        async with editing("ab a.\n") as at:
            await at.press("ctrl+r", "a", "full_stop")
            await at.pilot.click("#find-regex")
            await at.press("tab", "x")
            await at.pilot.click("#find-all")
            await at.pilot.pause()
            assert at.editor.text == b"x x\n"
            await at.press("y", "escape")
            assert at.editor.find_bar.replacement == "xy"

    async def test_a_wrong_expression_is_said(self) -> None:
        async with editing("ab\n") as at:
            await at.press("ctrl+f", "alt+r", "left_parenthesis")
            assert at.editor.search.problem
            await at.press("enter", "escape")
            assert at.editor.text == b"ab\n"

    @pytest.mark.parametrize(
        ("answer", "offset"), [("2", 4), ("2:3", 6), ("99", 8), ("2:99", 7), ("0", 0)]
    )
    async def test_go_to_line(self, answer: str, offset: int) -> None:
        async with editing("abc\ndef\n") as at:
            await at.press("ctrl+g", *answer.replace(":", "!").replace("!", ":"), "enter")
            assert at.editor.cursor_offset == offset
            assert at.editor.view.has_focus

    async def test_what_is_no_line_is_said(self) -> None:
        async with editing("abc\n") as at:
            await at.press("ctrl+g", "x", "enter")
            assert at.app.said == ["no line number: x"]


class TestCoding:
    async def test_definition(self) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("hello to")) as at:
            await at.press("f12")
            assert at.editor.cursor_offset == PROGRAM.index("hello of")
            await at.press("home", "f12")
            assert at.app.said == ["no variable is under the cursor"]

    async def test_rename_everywhere_is_one_step(self) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("talker publish")) as at:
            await at.press("f2", "m", "e", "enter")
            assert at.editor.text.decode() == PROGRAM.replace("as talker", "as me").replace(
                "talker publish", "me publish"
            )
            await at.press("ctrl+z")
            assert at.editor.text.decode() == PROGRAM

    @pytest.mark.parametrize(
        ("name", "reason"),
        [
            ("hello", "`hello` is a variable already"),
            ("to", "`to` is a keyword and cannot be a variable"),
            ("1a", "`1a` is no variable: it has letters, digits and `_`, a letter first"),
        ],
    )
    async def test_a_name_that_cannot_be_is_refused(self, name: str, reason: str) -> None:
        async with editing(PROGRAM, cursor=PROGRAM.index("talker publish")) as at:
            at.editor.rename(name)
            assert (at.app.said, at.editor.text.decode()) == ([reason], PROGRAM)

    async def test_format(self) -> None:
        async with editing("load   a  as b\n\n\n\ngenerate_node   b", cursor=24) as at:
            await at.press("ctrl+l")
            assert at.editor.text == b"load a as b\n\ngenerate_node b\n"
            await at.press("ctrl+z")
            assert at.editor.text == b"load   a  as b\n\n\n\ngenerate_node   b"

    @pytest.mark.parametrize(
        ("script", "text", "said"),
        [
            ("sed -i \"s/'talker/'me/\" $1", PROGRAM.replace("'talker", "'me"), ""),
            ("printf 'a\\r\\nb' > $1", "a\r\nb", ""),
            ("true", PROGRAM, ""),
            ("echo oops > $1; exit 3", PROGRAM, "ended with status 3; the text is as it was"),
            ("rm $1", PROGRAM, "`program.plastron` is gone; the text is as it was"),
            ("kill -9 $$", PROGRAM, "ended with status -9; the text is as it was"),
            (
                "printf 'caf\\351' > $1",
                PROGRAM,
                "the file is not UTF-8 (line 1); what you wrote is",
            ),
        ],
    )
    async def test_an_editor_of_the_users(
        self,
        script: str,
        text: str,
        said: str,
        tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        editor, left = tmp_path / "an editor", tmp_path / "left"
        left.mkdir()
        editor.write_text(f"#!/bin/sh\n{script}\n")
        editor.chmod(0o755)
        monkeypatch.setenv("VISUAL", f"'{editor}'")
        monkeypatch.setattr(tempfile, "tempdir", str(left))
        async with editing(PROGRAM) as at:
            monkeypatch.setattr(at.app, "suspend", nullcontext)
            await at.press("ctrl+e")
            assert at.editor.text.decode() == text
            assert said in "".join(at.app.said)
            assert bool(said) == bool(at.app.said)
            await at.press("ctrl+z")
            assert at.editor.text.decode() == PROGRAM
        kept = list(left.glob("*/*"))
        assert [file.read_bytes() for file in kept] == ([b"caf\xe9"] if "UTF-8" in said else [])

    async def test_an_editor_that_is_not_there_is_said(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("EDITOR", "/nowhere/editor -x")
        async with editing("abc") as at:
            monkeypatch.setattr(at.app, "suspend", nullcontext)
            await at.press("ctrl+e")
            assert at.app.said == ["`/nowhere/editor` cannot be started: no such file or directory"]

    async def test_without_an_editor_it_says_so(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.delenv("VISUAL", raising=False)
        monkeypatch.delenv("EDITOR", raising=False)
        async with editing("abc") as at:
            await at.press("ctrl+e")
            assert at.app.said == ["neither $VISUAL nor $EDITOR names an editor"]


async def test_the_editor_follows_the_theme() -> None:
    async with editing(PROGRAM) as at:
        looks = set()
        for theme in ("textual-dark", "textual-light", "nord", "gruvbox"):
            at.app.theme = theme
            await at.pilot.pause()
            style = at.editor.view.palette.captures["keyword"]
            looks.add((str(style.color), str(at.editor.view.palette.text.bgcolor)))
        assert len(looks) == 4


async def test_all_can_be_read_in_every_theme() -> None:
    async with editing(PROGRAM) as at:
        for theme in at.app.available_themes.values():
            if theme.ansi:
                continue
            at.app.theme = theme.name
            await at.pilot.pause()
            palette = at.editor.view.palette
            looks = dict(palette.captures)
            looks |= {name: getattr(palette, name) for name in ("text", "error", "warning")}
            looks |= {name: getattr(palette, name) for name in ("selection", "popup_quiet")}
            looks |= {name: getattr(palette, name) for name in ("popup", "popup_here", "cursor")}
            for name, look in looks.items():
                whole = palette.text + look
                assert whole.color is not None
                assert whole.bgcolor is not None
                found = contrast(*map(Color.from_rich_color, (whole.color, whole.bgcolor)))
                assert found >= 4.4, (theme.name, name)


async def test_sixteen_colours_are_the_terminals_own() -> None:
    async with editing(PROGRAM) as at:
        at.app.ansi_color = True
        at.editor.view.recolor()
        await at.pilot.pause()
        color = at.editor.view.palette.captures["keyword"].color
        assert color is not None
        assert color.name == "blue"


async def test_without_colours_all_is_told_apart_by_how_it_is_written(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    async with editing("generate_node a\n") as at:
        await at.understand()
        palette = at.editor.view.palette
        looks = {"text": palette.text, "selection": palette.selection, "match": palette.match}
        looks |= {"error": palette.error_line, "bracket": palette.bracket}
        written = {name: (look.bold, look.underline, look.reverse) for name, look in looks.items()}
        assert written["selection"] != written["match"] != written["text"] != written["error"]
        assert all(look.color is None for look in palette.captures.values())


async def test_keys_that_come_all_at_once_keep_their_order() -> None:
    async with editing("") as at:
        for key, character in (("a", "a"), ("enter", "\r"), ("b", "b"), ("home", None), ("c", "c")):
            at.app.post_message(Key(key, character))
        await at.pilot.pause()
        await at.pilot.pause()
        assert at.marked == "a\nc[]b"


async def test_what_is_typed_right_after_a_key_is_for_the_bar_that_it_opens() -> None:
    async with editing("load a as b\n") as at:
        for _ in range(20):
            await at.pilot.pause()
        assert at.editor._has_bars
        for key, character in (("ctrl+f", None), ("a", "a"), ("s", "s"), ("enter", "\r")):
            at.app.post_message(Key(key, character))
        for _ in range(20):
            await at.pilot.pause()
        assert at.marked == "load a [as] b\n"
