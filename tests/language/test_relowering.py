from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import boundary, broken_lines, read, shape, statements

from plastron_tui.diagnostics import Span
from plastron_tui.language import DECLARATIONS, Document, Program, lower
from plastron_tui.language.incremental_lowering import Lowered, lower_edited

PROGRAM = """\
// Überschrift: ein Knoten, der grüßt 🐢
create_node 'talker' as talker
create_message greeting of message_type String and input "grüß \\"dich\\", 世界"
create_node 'listener' as
talker publish greeting to 'chatter' of message_type String at 2 hz

subscribe talker too 'chatter' of message_type String
create_message twist of message_type Twist and input linear=(1, 2, 3), angular.z=0.5
generate talker
generate_node talker
"""
PIECES = st.sampled_from(
    [
        "create_node 'x' as y",
        "[" * 60,
        " publish m to 'a' of message_type String",
        "\nn publish m to 'b'\n",
        "\n/*",
        "*/",
        "//",
        "'",
        '"',
        "é",
        "🐢",
        "((",
        "]",
        "\\",
        "input",
        "1e5",
        "\ufeff",
        "\t",
        "$ $",
        "n",
        ",",
        " ",
        "\n\n",
        "as\n",
        "= ",
        "\r",
        "\r\n",
        "\n",
    ]
)
EDITS = st.lists(
    st.tuples(
        st.floats(0, 1),
        st.floats(0, 0.1),
        PIECES | statements() | broken_lines.map("\n{}\n".format) | st.text(max_size=4),
    ),
    min_size=1,
    max_size=8,
)


def described(program: Program) -> list[object]:
    """Return all that a program says, and where."""
    places = [
        [statement.span]
        + [statement.span_of(slot.name) for slot in DECLARATIONS[type(statement)].slots]
        for statement in program.statements
    ]
    return [places, shape(program), program.diagnostics, program.broken]


def test_a_statement_stays_where_it_is_while_the_text_behind_it_changes() -> None:
    text = b"P stop_publishing to '/L'\n" + b"create_node 'e' as e\n" * 5
    document = Document(text)
    program = lower(document)
    end = text.index(b"\n")
    document.edit(end, end, b"\ncreate_node 'x' as x")
    (first, *_) = lower_edited(document, Lowered(text, program)).statements
    assert first.span_of("topic") == Span(21, end)


@pytest.mark.long
@settings(max_examples=examples(300), deadline=None)
@given(st.lists(statements(), max_size=6).map("\n".join), st.booleans(), EDITS)
def test_what_is_lowered_after_edits_is_what_is_lowered_anew(
    written: str, is_broken: bool, edits: list[tuple[float, float, str]]
) -> None:
    text = ((PROGRAM if is_broken else "") + written).encode()
    document = Document(text)
    program = read(text)
    for at, length, new in edits:
        text = document.text
        start, end = boundary(text, at), boundary(text, min(1.0, at + length))
        document.edit(start, end, new.encode("utf-8", "replace"))
        program = lower_edited(document, Lowered(text, program))
        assert described(program) == described(read(document.text))


@pytest.mark.parametrize("inside", ["generate_node", "create_node 'listener' as", "\n\n"])
def test_what_an_edit_leaves_alone_is_not_lowered_again(inside: str) -> None:
    text = PROGRAM.encode()
    document = Document(text)
    program = read(text)
    at = text.index(inside.encode()) + len(inside)
    document.edit(at, at, b"x")
    again = lower_edited(document, Lowered(text, program))
    kept = [one for one in again.statements if one.span.end <= text.rfind(b"\n", 0, at)]
    assert kept
    assert all(one is other for one, other in zip(kept, program.statements, strict=False))
    parsed = {id(statement.syntax) for statement in program.statements}
    later = [one for one in again.statements if one.span.start > at + 40]
    assert all(id(statement.syntax) in parsed for statement in later)
