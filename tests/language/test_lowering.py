from __future__ import annotations

import math

import pytest
from cases import check_each
from hypothesis import given, settings
from hypothesis import strategies as st
from lowering_cases import CASES
from machine import examples
from plastron_programs import argument, read, shape, statements

from plastron_tui.diagnostics import escapes
from plastron_tui.language import DECLARATIONS, Clause, Document, lower
from plastron_tui.language.inputs import DEEPEST_NESTING, Literal
from plastron_tui.language.statements import CreateMessage


def check_slots(text: str, expected: tuple[object, ...]) -> None:
    program = read(text + "\n")
    assert program.diagnostics == ()
    assert shape(program) == [expected]


def test_a_statement_becomes_its_slots() -> None:
    check_each(CASES.items(), check_slots)


def test_the_cases_have_every_statement_with_and_without_its_clauses() -> None:
    counts = {declaration.type.__name__: 0 for declaration in DECLARATIONS.values()}
    for expected in CASES.values():
        counts[str(expected[0])] += 1
    for declaration in DECLARATIONS.values():
        clauses = sum(isinstance(element, Clause) for element in declaration.elements)
        assert counts[declaration.type.__name__] >= 1 + clauses


@pytest.mark.parametrize(
    "comment", ["/* c */", "/* two\nlines */", "/**/", "\t", "\ufeff", "/* 'a' \" as */"]
)
def test_comments_and_space_between_words_say_nothing(comment: str) -> None:
    for text, expected in CASES.items():
        spread = f" {comment} ".join(text.split(" ")) if "a b" not in text else text
        program = read(spread + " // the end\n")
        assert program.diagnostics == (), text
        assert shape(program) == [expected]


@pytest.mark.parametrize(
    "wrap",
    ["{}", "{}\n", "{}\r\n", "\r\n{}\r\n\r\n", "\ufeff{}\n", "\n\n  {}", "// c\n{} // d"],
    ids=["none", "newline", "crlf", "crlf around", "byte order mark", "spaces", "comments"],
)
def test_what_is_around_a_statement_says_nothing(wrap: str) -> None:
    for text, expected in CASES.items():
        program = read(wrap.format(text))
        assert program.diagnostics == ()
        assert shape(program) == [expected]


def test_statements_come_in_their_order_around_a_broken_line() -> None:
    program = read("create_node 'a' as n\nsubscribe n\ngenerate_node n\n")
    assert [type(found).__name__ for found in program.statements] == ["CreateNode", "GenerateNode"]
    assert [found.code for found in program.diagnostics] == ["syntax-error"]


def test_a_statement_knows_where_its_slots_are() -> None:
    text = "subscribe nö to 'a' of message_type String // ö\n".replace("nö", "n")
    (statement,) = read("// ö\n" + text).statements
    start = len("// ö\n".encode())
    assert statement.span == (start, start + len("subscribe n to 'a' of message_type String"))
    assert statement.span_of("topic") == (start + 15, start + 18)
    assert statement.span_of("function") == statement.span


NUMBERS = {
    "5": 5,
    "-5": -5,
    "+5": 5,
    "-0": 0,
    "007": 7,
    "0.25": 0.25,
    ".5": 0.5,
    "-.5": -0.5,
    "5.": 5.0,
    "1e-3": 0.001,
    "1E+3": 1000.0,
    "1e999": math.inf,
    "-1e999": -math.inf,
    "1e-999": 0.0,
    "9" * 5000: math.inf,
    "-" + "9" * 5000: -math.inf,
    "9" * 400: int("9" * 400),
    "0." + "3" * 5000: float("0." + "3" * 50),
}


@pytest.mark.parametrize(("text", "value"), NUMBERS.items(), ids=[key[:12] for key in NUMBERS])
def test_numbers(text: str, value: float) -> None:
    (found,) = values_of(text)
    assert isinstance(found, Literal)
    assert found.value == value
    assert type(found.value) is type(value)


STRINGS = {
    '""': "",
    '"a b"': "a b",
    '" a "': " a ",
    r'"\"\\\n\t"': '"\\\n\t',
    r'"\u00e9\u0041"': "éA",
    r'"\ud83d\ude00"': "😀",
    r'"a\ud83d\ude00b\ud83d"': "a😀b\ud83d",
    r'"\ude00\ud83d"': "\ude00\ud83d",
    r'"\u0000"': "\0",
    r'"\\u0041"': "\\u0041",
    '"// no /* comment */"': "// no /* comment */",
    '"it\'s, ok"': "it's, ok",
    '"世界🐢é"': "世界🐢é",
    '"{{ x }} {% y %}"': "{{ x }} {% y %}",
    '"\u202eabc"': "\u202eabc",
    '"\ufeff"': "\ufeff",
    '"tab\there"': "tab\there",
}


@pytest.mark.parametrize(("text", "value"), STRINGS.items())
def test_strings(text: str, value: str) -> None:
    (found,) = values_of(text)
    assert isinstance(found, Literal)
    assert found.value == value


@pytest.mark.parametrize(("escape", "meaning"), escapes.MEANINGS.items())
def test_what_is_listed_as_an_escape_is_one(escape: str, meaning: str) -> None:
    (found,) = values_of(f'"a{escape}b"')
    assert isinstance(found, Literal)
    assert found.value == f"a{meaning}b"


@given(st.text(st.characters(exclude_characters='"\\\r\n', exclude_categories=["Cs"])))
def test_a_string_is_what_stands_in_it(text: str) -> None:
    (found,) = values_of(f'"{text}"')
    assert isinstance(found, Literal)
    assert found.value == text


SHAPES = {
    "True, False": ["True", "False"],
    "[]": [["list"]],
    "[1, [2], []]": [["list", "1", ["list", "2"], ["list"]]],
    "()": [["nested"]],
    "(1, x=2), y = (z.w = [()])": [
        ["nested", "1", ("x", "=", "2")],
        ("y", "=", ["nested", ("z.w", "=", ["list", ["nested"]])]),
    ],
    "to=1, none=2, True=3, publish . x = 4": [
        ("to", "=", "1"),
        ("none", "=", "2"),
        ("True", "=", "3"),
        ("publish.x", "=", "4"),
    ],
    "a /* c */ . /* d */ b = /* e */ [ /* f */ 1 /* g */ ]": [("a.b", "=", ["list", "1"])],
    "parameter 'p', [parameter '~q'], (x=parameter 'r')": [
        "parameter p",
        ["list", "parameter ~q"],
        ["nested", ("x", "=", "parameter r")],
    ],
    "received.a, received.b.to[3], x = received . none": [
        "received a",
        "received b.to[3]",
        ("x", "=", "received none"),
    ],
    "received.a-1, received.a - -1, received.a * 2 + .5 / 3": [
        "received a - 1",
        "received a - -1",
        "received a * 2 + 0.5 / 3",
    ],
    "received.a+received.b.c[1]-parameter 'p' / -2": [
        "received a + received b.c[1] - parameter p / -2",
    ],
    "received /* c */ . /* d */ a /* e */ [ /* f */ 1 ] /* g */ * /* h */ 2": ["received a[1] * 2"],
    "parameter=1, received=2, received.x=3, parameter.x=4, x.received=5, x.parameter=6": [
        ("parameter", "=", "1"),
        ("received", "=", "2"),
        ("received.x", "=", "3"),
        ("parameter.x", "=", "4"),
        ("x.received", "=", "5"),
        ("x.parameter", "=", "6"),
    ],
}


@pytest.mark.parametrize(("text", "expected"), SHAPES.items())
def test_values_of_values(text: str, expected: list[object]) -> None:
    assert [argument(value) for value in values_of(text)] == expected


def values_of(text: str) -> tuple[object, ...]:
    program = read(f"create_message m of message_type T and input {text}\n")
    assert program.diagnostics == ()
    (statement,) = program.statements
    assert isinstance(statement, CreateMessage)
    return statement.input


@pytest.mark.parametrize(("opening", "closing"), ["()", "[]", ("(x=", ")"), ("([", "])")])
def test_nesting_has_a_limit(opening: str, closing: str) -> None:
    each = opening.count("(") + opening.count("[")

    def nested(depth: int) -> str:
        values = opening * depth + "1" + closing * depth
        return f"create_message m of message_type T and input {values}\ngenerate_node n\n"

    assert read(nested(DEEPEST_NESTING // each)).diagnostics == ()
    for depth in (DEEPEST_NESTING // each + 1, 20_000):
        program = read(nested(depth))
        assert [found.code for found in program.diagnostics] == ["too-deep"]
        assert [type(found).__name__ for found in program.statements] == ["GenerateNode"]
        assert "m" in program.broken.declared


@settings(max_examples=examples(100), deadline=None)
@given(st.lists(statements(), max_size=6), st.sampled_from(["\n", "\r\n", "\n\n // c\n"]))
def test_every_statement_is_lowered(lines: list[str], ending: str) -> None:
    program = lower(Document(ending.join(lines).encode()))
    assert program.diagnostics == ()
    assert len(program.statements) == len(lines)
