"""Finding and replacing in the editor."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable

import pytest
from editor_host import PROGRAM, editing
from textual.widgets import Input, Label

from plastron_tui.session import Session
from plastron_tui.studio.editor.search import Found, Search
from plastron_tui.studio.editor.search_thread import SearchThread


def held_searches(monkeypatch: pytest.MonkeyPatch) -> threading.Event:
    """Let searches for an expression wait until the event is set."""
    goes_on = threading.Event()
    find = Search.find

    def held(self: Search, text: bytes, *is_stale: Callable[[], bool]) -> Found:
        assert not self.is_regex or goes_on.wait(60)
        return find(self, text, *is_stale)

    monkeypatch.setattr(Search, "find", held)
    return goes_on


class _Scripted(Search):
    """A search that does what a test wants."""

    def __init__(self, does: Callable[[], Found]) -> None:
        super().__init__()
        self._does = does

    def find(self, text: bytes, is_stale: Callable[[], bool] = lambda: False) -> Found:
        return self._does()


class TestSearchThread:
    def test_an_error_is_said_and_the_next_search_runs(self) -> None:
        posted = queue.SimpleQueue[Callable[[], object]]()
        thread = SearchThread(posted.put)
        said: list[str] = []

        def fail() -> Found:
            raise RuntimeError("no room")

        for does in (fail, lambda: Found(problem="next")):
            before = len(said)
            thread.run(_Scripted(does), b"", lambda found: said.append(found.problem))
            while len(said) == before:
                posted.get(timeout=60)()
        assert said == ["that cannot be searched for: no room", "next"]

    def test_a_search_gives_way_to_a_newer_one(self) -> None:
        posted = queue.SimpleQueue[Callable[[], object]]()
        thread = SearchThread(posted.put)
        given_way = threading.Event()
        told: list[str] = []

        class Endless(Search):
            def find(self, text: bytes, is_stale: Callable[[], bool] = lambda: False) -> Found:
                while not is_stale():
                    assert not given_way.wait(0.001), "nobody told that another one waits"
                given_way.set()
                return Found()

        thread.run(Endless(), b"", lambda _: told.append("first"))
        thread.run(_Scripted(Found), b"", lambda _: told.append("second"))
        try:
            while "second" not in told:
                posted.get(timeout=20)()
        finally:
            given_way.set()

    def test_of_a_search_that_another_one_followed_nothing_is_told(self) -> None:
        posted = queue.SimpleQueue[Callable[[], object]]()
        thread = SearchThread(posted.put)
        goes_on = threading.Event()
        told: list[str] = []

        def wait() -> Found:
            assert goes_on.wait(60)
            return Found()

        thread.run(_Scripted(wait), b"", lambda _: told.append("first"))
        thread.run(_Scripted(wait), b"", lambda _: told.append("second"))
        goes_on.set()
        while "second" not in told:
            posted.get(timeout=60)()
        assert told == ["second"]


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
            assert at.editor.finder.search.spans == [(2, 3)]

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
            assert "no such group" in str(label.content)
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
            buttons = {
                name: at.editor.find_bar.query_one(f"#find-{name}") for name in ("regex", "all")
            }
            assert str(buttons["regex"].render()) == ".* Alt-R"
            assert str(buttons["all"].render()) == "all Alt-A"
            off = buttons["regex"].rich_style
            await at.pilot.click("#find-regex")
            assert buttons["regex"].rich_style.bgcolor != off.bgcolor
            await at.press("tab", "x")
            await at.pilot.click("#find-all")
            await at.pilot.pause()
            assert at.editor.text == b"x x\n"
            await at.press("y", "escape")
            assert at.editor.find_bar.replacement == "xy"

    async def test_a_wrong_expression_is_said(self) -> None:
        async with editing("ab\n") as at:
            await at.press("ctrl+f", "alt+r", "left_parenthesis")
            assert at.editor.finder.search.problem
            await at.press("enter", "escape")
            assert at.editor.text == b"ab\n"

    async def test_keys_do_not_wait_for_a_slow_expression(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        goes_on = held_searches(monkeypatch)
        async with editing("ab b\n") as at:
            await at.press("ctrl+r", "tab", "z", "tab", "alt+r")
            goes_on.set()
            await at.until(lambda: not at.editor.finder.is_searching)
            goes_on.clear()
            label = at.editor.find_bar.query_one("#find-count", Label)
            await at.type("a")
            assert str(label.content) == "searching …"
            # What is asked for meanwhile is done once it is known where.
            await at.press("backspace", "b", "alt+a")
            assert at.editor.text == b"ab b\n"
            goes_on.set()
            await at.until(lambda: at.editor.text == b"az z\n")
            await at.until(lambda: str(label.content) == "2 replaced")
            goes_on.clear()
            await at.press("backspace", "z", "escape", "x")
            assert b"x" in at.editor.text
            goes_on.set()

    async def test_what_was_edited_meanwhile_is_searched_again(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        goes_on = held_searches(monkeypatch)
        async with editing("ab b\n") as at:
            await at.press("ctrl+r", "b", "tab", "z", "alt+r", "alt+a")
            assert at.editor.finder.is_searching
            at.editor.state.apply([(0, 0, b"1234567")])
            goes_on.set()
            await at.until(lambda: at.editor.text == b"1234567az z\n")

    async def test_what_was_asked_of_one_text_is_not_done_to_another(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        goes_on, ended = threading.Event(), threading.Event()
        find = Search.find

        def slow(self: Search, text: bytes, *is_stale: Callable[[], bool]) -> Found:
            if self.is_regex and text.startswith(b"ab"):
                assert goes_on.wait(60)
                ended.set()
            return find(self, text, *is_stale)

        monkeypatch.setattr(Search, "find", slow)
        async with editing("ab b\n") as at:
            await at.press("ctrl+r", "b", "tab", "z", "alt+r", "alt+a")
            assert at.editor.finder.is_searching
            at.editor.set_session(Session(b"xx b\n", environ={}))
            goes_on.set()
            assert ended.wait(60)
            await at.pilot.pause()
            assert (at.editor.text, at.editor.cursor_offset) == (b"xx b\n", 0)
            assert not at.editor.finder.is_searching
            await at.press("alt+a")
            await at.until(lambda: at.editor.text == b"xx z\n")

    @pytest.mark.parametrize("wraps", [False, True])
    async def test_of_a_long_line_only_the_matches_in_sight_are_drawn(self, wraps: bool) -> None:
        async with editing("ab é " * 20_000) as at:
            view = at.editor.view
            view.soft_wrap = wraps
            await at.press("ctrl+f", "a")
            assert at.editor.finder.count.endswith("of 20000")
            find, asked = at.editor.finder.search.within, list[tuple[int, int]]()

            def within(start: int, end: int) -> list[tuple[int, int]]:
                asked.append((start, end))
                return find(start, end)

            view.painter.matches = within
            strips = [view.render_line(y) for y in range(view.size.height)]
            assert max(end - start for start, end in asked) < 3 * view.size.width
            match = view.palette.match.bgcolor
            shown = [
                segment.text
                for strip in strips
                for segment in strip
                if segment.style is not None and segment.style.bgcolor == match
            ]
            assert len(shown) >= view.size.width // 5 - 5
            assert set("".join(shown)) == {"a"}

    async def test_an_expression_that_takes_too_long_is_said(self) -> None:
        async with editing("a" * 60 + "b\n") as at:
            await at.press("ctrl+f", "alt+r")
            at.editor.find_bar.query_one("#find-what", Input).value = r"^(a|aa)+\1?$"
            label = at.editor.find_bar.query_one("#find-count", Label)
            await at.until(lambda: str(label.content) == "that expression takes too long")

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
