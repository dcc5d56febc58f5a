from __future__ import annotations

import json
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Label, LineIndex, Severity, Span
from plastron_tui.diagnostics.render import TextRenderer, as_json
from plastron_tui.diagnostics.terminal import visible

CODE = Code("code", "A mistake.")


def spot(text: str, part: str, start: int = 0) -> Span:
    at = text.encode().index(part.encode(), start)
    return Span(at, at + len(part.encode()))


def render(text: str, found: Diagnostic, *, color: bool = False) -> list[str]:
    lines = LineIndex(text.encode())
    return TextRenderer(lambda _: lines, Path("a.plastron"), color=color).render(found).split("\n")


def found(span: Span | None, *labels: Label, help: str | None = None) -> Diagnostic:  # noqa: A002
    return Diagnostic(CODE, "wrong", span, labels=labels, help=help)


@pytest.mark.parametrize(
    ("text", "part", "line", "marks"),
    [
        pytest.param("one two", "two", "1 | one two", "  |     ^^^", id="plain"),
        pytest.param("one two\r\nx", "two", "1 | one two", "  |     ^^^", id="crlf"),
        pytest.param("\ufeffone two", "one", "1 | one two", "  | ^^^", id="byte order mark"),
        pytest.param("\tone\ttwo", "two", "1 |  one two", "  |      ^^^", id="tabs"),
        pytest.param("日本 two", "two", "1 | 日本 two", "  |      ^^^", id="wide before"),
        pytest.param("a 日本 b", "日本", "1 | a 日本 b", "  |   ^^^^", id="wide marked"),
        pytest.param("e\u0301 two", "two", "1 | e\u0301 two", "  |   ^^^", id="combining"),
        pytest.param("🤖 two", "two", "1 | 🤖 two", "  |    ^^^", id="emoji"),
        pytest.param("\x1b[31m two", "two", r"1 | \x1b[31m two", "  |          ^^^", id="escape"),
        pytest.param("a\u202e two", "two", r"1 | a\u202e two", "  |         ^^^", id="bidi"),
        pytest.param("a\x9b two", "two", r"1 | a\x9b two", "  |       ^^^", id="c1"),
        pytest.param("a\rb two", "two", r"1 | a\rb two", "  |      ^^^", id="carriage return"),
        pytest.param("one\ntwo three\nfour", "two three\nfo", "2 | two three", "  | ^^^^^^^^^",
                     id="several lines"),
    ],
)  # fmt: skip
def test_line_and_marks(text: str, part: str, line: str, marks: str) -> None:
    shown = render(text, found(spot(text, part)))
    assert shown[0] == "error[code]: wrong"
    assert shown[2:] == ["  |", line, marks]


@pytest.mark.parametrize(
    ("text", "at", "where", "line", "marks"),
    [
        pytest.param("", 0, "1:1", "1 |", "  | ^", id="empty file"),
        pytest.param("ab", 2, "1:3", "1 | ab", "  |   ^", id="end of file"),
        pytest.param("ab\n", 3, "2:1", "2 |", "  | ^", id="behind the last line"),
        pytest.param("ab\r\n", 2, "1:3", "1 | ab", "  |   ^", id="before crlf"),
        pytest.param("ab", 99, "1:3", "1 | ab", "  |   ^", id="beyond the end"),
    ],
)
def test_empty_span(text: str, at: int, where: str, line: str, marks: str) -> None:
    shown = render(text, found(Span(at, at)))
    assert shown[1] == f" --> a.plastron:{where}"
    assert shown[3:] == [line, marks]


def test_labels_stand_in_the_order_of_the_file() -> None:
    text = "first here\nsecond\nthird there\n" + "\n" * 8 + "last\n"
    labels = (Label(spot(text, "last"), "after"), Label(spot(text, "here"), "before"))
    assert render(text, found(spot(text, "there"), *labels, help="write it")) == [
        "error[code]: wrong",
        "  --> a.plastron:3:7",
        "   |",
        " 1 | first here",
        "   |       ---- before",
        "...",
        " 3 | third there",
        "   |       ^^^^^",
        "...",
        "12 | last",
        "   | ---- after",
        "   = help: write it",
    ]


def test_label_on_the_same_line_shows_it_once() -> None:
    text = "one two"
    shown = render(text, found(spot(text, "two"), Label(spot(text, "one"), "this")))
    assert shown[3:] == ["1 | one two", "  | --- this", "  |     ^^^"]


@pytest.mark.parametrize("column", [0, 50, 500, 4_990])
def test_long_line_is_cut_around_the_mark(column: int) -> None:
    text = "x" * column + "MARK" + "y" * (5_000 - column)
    shown = render(text, found(spot(text, "MARK")))
    line, marks = shown[3], shown[4]
    assert len(line) <= 170
    at = line.index("MARK")
    assert marks == "  | " + " " * (at - 4) + "^^^^"
    assert ("…" in line[:at]) == (column > 40)


def test_mark_of_a_long_line_stays_in_the_window() -> None:
    text = "日" * 5_000
    assert all(len(line) <= 400 for line in render(text, found(Span(300, 15_000))))


def test_color_changes_nothing_but_color() -> None:
    text = "one two"
    plain = render(text, found(spot(text, "two"), Label(spot(text, "one"), "this"), help="h"))
    color = render(text, found(spot(text, "two"), Label(spot(text, "one"), "this"), help="h"),
                   color=True)  # fmt: skip
    joined = "\n".join(color)
    assert "\x1b[31;1m" in joined
    for style in ("31;1", "34;1", "1", "0"):
        joined = joined.replace(f"\x1b[{style}m", "")
    assert joined.split("\n") == plain


def test_warning_has_its_own_color_and_name() -> None:
    warning = Diagnostic(CODE, "careful", severity=Severity.WARNING)
    assert render("", warning) == ["warning[code]: careful", " --> a.plastron"]
    assert render("", warning, color=True)[0].startswith("\x1b[33;1mwarning")


def test_nothing_of_a_terminal_passes() -> None:
    evil = "".join(map(chr, range(32))) + "\x7f\x9b\u202e\u2066\u200b\ufeff\ud800"
    text = f"one {evil.replace(chr(10), '')}".encode("utf-8", "replace").decode()
    diagnostic = Diagnostic(
        CODE, evil, Span(0, 3), Path(f"/tmp/{evil[1:]}"), evil, labels=(Label(Span(0, 3), evil),)
    )
    lines = LineIndex(text.encode())
    shown = TextRenderer(lambda _: lines).render(diagnostic)
    assert shown.replace("\n", "").isprintable()


def test_what_is_escaped_is_no_longer_than_a_message() -> None:
    evil = "\x1b" * 2_000
    shown = TextRenderer(lambda _: None).render(Diagnostic(CODE, evil, help=evil))
    assert max(map(len, shown.split("\n"))) <= 2_100


def test_what_is_visible_is_left_alone() -> None:
    assert visible("grüße, 日本 🤖") == "grüße, 日本 🤖"


def test_json_has_every_part() -> None:
    text = "one\ntwö three\n"
    edit = Edit(spot(text, "three"), "four")
    diagnostic = Diagnostic(
        CODE, "message", spot(text, "three"), help="help", fix=Fix("title", (edit,)),
        labels=(Label(spot(text, "one"), "label"),),
    )  # fmt: skip
    lines = LineIndex(text.encode())
    place = {"start": {"line": 2, "column": 5}, "end": {"line": 2, "column": 10}}
    first = {"start": {"line": 1, "column": 1}, "end": {"line": 1, "column": 4}}
    shown = as_json([diagnostic], lambda _: lines, Path("a.plastron"))
    assert json.loads(json.dumps(shown)) == [
        {
            "file": "a.plastron",
            "code": "code",
            "severity": "error",
            "message": "message",
            "range": place,
            "help": "help",
            "fix": {"title": "title", "edits": [{"range": place, "text": "four"}]},
            "labels": [{"range": first, "message": "label"}],
        }
    ]


def test_json_of_a_diagnostic_without_a_place() -> None:
    (shown,) = as_json([Diagnostic(CODE, "message")], lambda _: None)
    assert (shown["file"], shown["range"], shown["fix"], shown["labels"]) == (None, None, None, [])
