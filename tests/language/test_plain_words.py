"""The plain words that came after version 0.1.0 stay names wherever their clause cannot stand."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples, mostly_long
from plastron_programs import EXAMPLES, read, shape, variables

from plastron_tui.language import DECLARATIONS, Program, SlotKind
from plastron_tui.language.keywords import KEYWORDS, WORDS

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("examples/**/*.plastron"), *ROOT.glob("tests/programs/*.plastron")])
PROGRAMS = [*(file.read_text("utf-8") for file in FILES), "\n".join(EXAMPLES)]
PLAIN = sorted(WORDS - KEYWORDS)
FUNCTIONS = (SlotKind.FUNCTION, SlotKind.TIMER)


@cache
def named(text: str) -> list[tuple[int, int, str]]:
    """Return where the names of a program's variables and functions stand, and each."""
    return sorted(
        (*statement.span_of(slot.name), getattr(statement, slot.name))
        for statement in read(text).statements
        for slot in DECLARATIONS[type(statement)].slots
        if slot.kind.is_variable or slot.kind in FUNCTIONS
        if getattr(statement, slot.name) is not None
    )


def renamed(text: str, words: list[str]) -> tuple[str, dict[str, str]]:
    """Return a program with other names, and the name that each has got."""
    found = named(text)
    names = dict(zip(dict.fromkeys(name for *_, name in found), words, strict=False))
    source = text.encode()
    for start, end, name in reversed(found):
        source = source[:start] + names.get(name, name).encode() + source[end:]
    return source.decode(), names


def with_names(program: Program, names: dict[str, str]) -> list[object]:
    """Return what a program says, with other names for its variables and functions."""
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind.is_variable or slot.kind in FUNCTIONS:
                name = getattr(statement, slot.name)
                setattr(statement, slot.name, names.get(name, name))
    return shape(program)


def test_the_words_are_those_that_came_later() -> None:
    assert set(PLAIN) == {
        *("all", "answering", "any", "between", "default", "managed", "node", "once", "parameter"),
        *("qos", "received", "renames", "repeats", "when"),
        *("contains", "in", "includes", "inside", "parameters", "remapping", "reporting"),
        *("returning", "setting", "starts"),
        *("axis", "damping", "effort", "friction", "mimicking", "painted", "shaped", "times"),
        *("turned", "velocity", "weighing"),
    }


@pytest.mark.parametrize("word", mostly_long(PLAIN, PLAIN[::3]))
def test_a_program_means_the_same_with_one_word_for_a_name(word: str) -> None:
    for text in PROGRAMS:
        for at in range(len({name for *_, name in named(text)})):
            words = [f"name_{index}" for index in range(at)]
            other, names = renamed(text, [*words, word])
            program = read(other)
            assert program.diagnostics == (), other
            assert shape(program) == with_names(read(text), names), other


@settings(max_examples=examples(100), deadline=None)
@given(
    st.sampled_from(PROGRAMS),
    st.lists(st.sampled_from(PLAIN) | variables, min_size=1, max_size=14, unique=True),
)
def test_a_program_means_the_same_with_any_names(text: str, words: list[str]) -> None:
    other, names = renamed(text, words)
    program = read(other)
    assert program.diagnostics == ()
    assert shape(program) == with_names(read(text), names)


@pytest.mark.parametrize("word", PLAIN)
def test_a_field_may_have_the_name(word: str) -> None:
    text = f"create_message m of message_type T and input {word}=1, x.{word}=2, {word}.x=3\n"
    program = read(text)
    assert program.diagnostics == ()
    assert shape(program) == [
        (
            *("CreateMessage", "m", "T"),
            ((word, "=", "1"), (f"x.{word}", "=", "2"), (f"{word}.x", "=", "3")),
        )
    ]
