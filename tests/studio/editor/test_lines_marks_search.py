"""Whole lines, marks and searches, without a screen."""

from __future__ import annotations

import pytest
from states import state_of

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes
from plastron_tui.studio.editor import line_commands
from plastron_tui.studio.editor.geometry import Geometry
from plastron_tui.studio.editor.marks import Marks
from plastron_tui.studio.editor.search import Search
from plastron_tui.studio.editor.state import Edited, TextState
from plastron_tui.studio.editor.wrap_map import WrapMap


@pytest.mark.parametrize(
    ("text", "pattern", "spans"),
    [
        (b"a\r\nba\r\n", "a$", [(0, 1), (4, 5)]),
        (b"a\r\nb\n", "a\\nb", [(0, 4)]),
        (b"\r\n\r\nx", "\\n", [(0, 2), (2, 4)]),
        ("é\r\néa".encode(), "^é", [(0, 2), (4, 6)]),
        (b"a\nb\n", "^(?=.)", [(0, 0), (2, 2)]),
        (b"(", "(", []),
    ],
)
def test_found_by_an_expression(text: bytes, pattern: str, spans: list[tuple[int, int]]) -> None:
    search = Search.make(pattern, is_regex=True, is_case_sensitive=True)
    search.run(text)
    assert search.spans == spans


def test_rows_that_are_edited_together_are_placed_at_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    indexed = []
    index = WrapMap._index
    monkeypatch.setattr(WrapMap, "_index", lambda self: (indexed.append(1), index(self)))
    geometry = Geometry(state_of("word " * 20 + "\n" + ("word " * 20 + "\n") * 200, 0))
    geometry.is_wrapped, geometry.width = True, 30
    assert geometry.place_edited([Edited(0, 1, 1, 0, 1, 201)])
    assert len(geometry.lines.extra) == 201
    assert len(indexed) == 1
    assert not geometry.place_edited([Edited(0, 1, 1, 0, 1, 201)])


class TestLineCommands:
    def done(self, text: str, command: str, anchor: int, head: int | None = None) -> str:
        state = state_of(text, anchor, head)
        buffer, selection = state.buffer, state.selection
        plan = {
            "comment": lambda: line_commands.toggle_comment(buffer, selection),
            "duplicate": lambda: line_commands.duplicate(buffer, selection),
            "up": lambda: line_commands.move(buffer, selection, -1),
            "down": lambda: line_commands.move(buffer, selection, 1),
            "delete": lambda: line_commands.delete(buffer, selection),
            "insert": lambda: line_commands.insert_statement(buffer, state.cursor, b"new"),
        }[command]()
        if plan is not None:
            state.apply(*plan)
        start, end = state.selection.start, state.selection.end
        marked = state.buffer.text
        marked = marked[:start] + b"[" + marked[start:end] + b"]" + marked[end:]
        return marked.decode()

    @pytest.mark.parametrize(
        ("command", "text", "anchor", "head", "after"),
        [
            ("comment", "a\nb", 1, None, "// a[]\nb"),
            ("comment", "  a\n\nb\n", 2, 6, "  // [a\n\n// b]\n"),
            ("comment", "// a\n//b\nc", 0, 8, "[a\nb]\nc"),
            ("comment", "// a\nb\nc", 0, 6, "// [// a\n// b]\nc"),
            ("duplicate", "a\nb", 0, None, "a\n[]a\nb"),
            ("duplicate", "a\r\nb\r\n", 0, None, "a\r\n[]a\r\nb\r\n"),
            ("up", "a\nbc", 3, None, "b[]c\na"),
            ("up", "a\nb", 0, None, "[]a\nb"),
            ("down", "a\nb\nc", 0, 3, "c\n[a\nb]"),
            ("down", "a\r\nb", 0, None, "b\r\n[]a"),
            ("delete", "a\nb\nc", 2, None, "a\n[]c"),
            ("delete", "a\nb", 2, None, "a[]"),
            ("delete", "a", 0, None, "[]"),
            ("insert", "a\nb", 0, None, "a\nnew[]\nb"),
            ("insert", "a\n", 2, None, "a\nnew[]\n"),
            ("insert", "", 0, None, "new[]\n"),
            ("insert", "a\r\n", 0, None, "a\r\nnew[]\r\n"),
            ("insert", "a", 1, None, "a\nnew[]"),
        ],
    )
    def test_command(
        self, command: str, text: str, anchor: int, head: int | None, after: str
    ) -> None:
        assert self.done(text, command, anchor, head) == after


class TestMarks:
    def marks(self, state: TextState, *spans: tuple[int, int]) -> Marks:
        marks = Marks(Diagnostic(codes.SYNTAX_ERROR, "wrong", Span(*span)) for span in spans)
        state.listeners.append(marks.edited)
        return marks

    def spans(self, marks: Marks) -> list[tuple[int, int]]:
        return [(mark.start, mark.end) for mark in marks.between(0, 1000)]

    def test_they_move_with_the_text_before_them(self) -> None:
        state = state_of("ab cd ef")
        marks = self.marks(state, (3, 5), (6, 8))
        state.apply([(0, 1, b"xxx")])
        assert self.spans(marks) == [(5, 7), (8, 10)]

    def test_they_grow_and_shrink_with_their_own_text(self) -> None:
        state = state_of("ab cd ef")
        marks = self.marks(state, (3, 5))
        state.apply([(4, 4, b"x")])
        assert self.spans(marks) == [(3, 6)]
        state.apply([(4, 6, b"")])
        assert self.spans(marks) == [(3, 4)]

    def test_the_next_one_is_around_the_end(self) -> None:
        marks = self.marks(state_of("ab cd ef"), (0, 2), (6, 8))
        found = [marks.next_after(0), marks.next_after(6), marks.previous_before(0)]
        assert [mark.start for mark in found if mark is not None] == [6, 0, 6]

    def test_what_has_no_place_is_left_out(self) -> None:
        assert len(Marks([Diagnostic(codes.NO_ROS, "none", severity=Severity.WARNING)])) == 0


class TestSearch:
    def found(self, what: str, text: str, **how: bool) -> list[str]:
        options = {"is_regex": False, "is_case_sensitive": False, **how}
        search = Search.make(what, **options)
        search.run(text.encode())
        return [text.encode()[start:end].decode() for start, end in search.spans]

    def test_plain_text_is_taken_as_it_is(self) -> None:
        assert self.found("a.b", "A.b axb é a.b") == ["A.b", "a.b"]
        assert self.found("a.b", "A.b a.b", is_case_sensitive=True) == ["a.b"]

    def test_a_regular_expression(self) -> None:
        assert self.found(r"\w+$", "é ab\ncd", is_regex=True) == ["ab", "cd"]
        assert self.found("x*", "aa", is_regex=True) == ["", "", ""]

    def test_a_wrong_one_is_a_message(self) -> None:
        search = Search.make("(", is_regex=True, is_case_sensitive=False)
        assert search.problem
        search.run(b"(")
        assert search.spans == []

    def test_one_that_takes_for_ever_is_a_message(self) -> None:
        search = Search.make(r"^(a|aa)+\1?$", is_regex=True, is_case_sensitive=False)
        text = b"a\n" + b"a" * 60 + b"b\n"
        for _ in range(2):
            search.run(text)
            assert search.problem == "that expression takes too long"
            assert search.spans == []

    def test_a_template_with_a_group_that_is_not_there(self) -> None:
        search = Search.make("(a)", is_regex=True, is_case_sensitive=False)
        search.run(b"a")
        for template in (r"\2", r"\g<b>", "\\"):
            with pytest.raises(ValueError, match=r"."):
                search.replaced((0, 1), template)

    def test_groups_are_filled_in(self) -> None:
        search = Search.make(r"(\w)(\w)", is_regex=True, is_case_sensitive=False)
        search.run(b"ab cd")
        assert search.replaced((3, 5), r"\2\1") == "dc"

    def test_steps_go_around(self) -> None:
        search = Search.make("a", is_regex=False, is_case_sensitive=False)
        search.run(b"a.a")
        assert [search.step(1, 1), search.step(3, 1), search.step(0, -1)] == [
            (2, 3),
            (0, 1),
            (2, 3),
        ]
