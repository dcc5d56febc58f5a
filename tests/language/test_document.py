from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import boundary

from plastron_tui.language import Document, format_document, lower

PROGRAM = """\
// Überschrift: ein Knoten, der grüßt 🐢
create_node 'talker' as talker
create_message greeting of message_type String and input "grüß \\"dich\\", 世界"
talker publish greeting to 'chatter' of message_type String at 2 hz
/* two
lines */ generate_node talker
"""
PIECES = st.sampled_from(
    [
        "",
        "\n",
        "\r\n",
        " ",
        "'",
        '"',
        "/*",
        "*/",
        "// ",
        "é",
        "世",
        "🐢",
        "create_node 'x' as y",
        " publish m to 'a' of message_type String",
        "((",
        "]",
        "\\",
        "input",
        "1e5",
        "\ufeff",
        "\t",
    ]
)


@st.composite
def edits(draw: st.DrawFn) -> list[tuple[float, float, str, bool]]:
    ends = st.floats(0, 1)
    text = PIECES | st.text(max_size=8)
    return draw(st.lists(st.tuples(ends, ends, text, st.booleans()), min_size=1, max_size=8))


@settings(max_examples=examples(150), deadline=None)
@given(edits())
def test_an_edited_document_is_the_document_of_its_text(
    found: list[tuple[float, float, str, bool]],
) -> None:
    document = Document(PROGRAM.encode())
    for first, second, new, is_asked in found:
        start, end = sorted((boundary(document.text, first), boundary(document.text, second)))
        before = document.text
        document.edit(start, end, new.encode("utf-8", "replace"))
        assert document.text == before[:start] + new.encode("utf-8", "replace") + before[end:]
        if is_asked:
            assert document.tree.root_node.end_byte <= len(document.text)
    fresh = Document(document.text)
    assert str(document.tree.root_node) == str(fresh.tree.root_node)
    assert lower(document).diagnostics == lower(fresh).diagnostics
    assert format_document(document) == format_document(fresh)
    assert len(document.lines) == document.text.count(b"\n") + 1


@pytest.mark.parametrize(("start", "end"), [(-1, 0), (2, 1), (0, 6), (6, 6)])
def test_an_edit_outside_of_the_text_is_refused(start: int, end: int) -> None:
    document = Document(b"12345")
    with pytest.raises(ValueError, match="no range"):
        document.edit(start, end, b"")
    assert document.text == b"12345"


def test_an_empty_document_grows_letter_by_letter() -> None:
    document = Document()
    for letter in PROGRAM:
        document.edit(len(document.text), len(document.text), letter.encode())
    assert document.text == PROGRAM.encode()
    assert str(document.tree.root_node) == str(Document(PROGRAM.encode()).tree.root_node)
