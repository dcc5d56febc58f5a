from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as some
from tree_sitter import QueryCursor

from plastron_tui.language import Document
from plastron_tui.language.grammar import highlights_query, new_parser

LINES = some.sampled_from(
    [
        "create_node 'talker' as talker",
        "subscribe talker to 'a' of message_type String // why",
        "subscribe talker to",
        "/* one line */ load a as b",
        "/* it begins",
        "and ends */ generate_node b",
        "*/",
        "/*",
        'create_message m of message_type String and input "/* é',
        "",
        "\t'open",
    ]
)
Edit = tuple[float, float, str]
EDITS = some.lists(
    some.tuples(
        some.floats(0, 1),
        some.floats(0, 0.2),
        some.sampled_from(["", "x", "\n", "/*", "*/", "'", '"', "é", "subscribe n\n"]),
    ),
    max_size=6,
)


def edited(document: Document, edit: Edit) -> None:
    text = document.text.decode()
    start = int(edit[0] * len(text))
    end = min(len(text), start + int(edit[1] * len(text)))
    document.edit(len(text[:start].encode()), len(text[:end].encode()), edit[2].encode())


def captures(document: Document, start: int, end: int) -> set[tuple[str, int, int]]:
    excerpt = document.excerpt(start, end)
    return {
        (name, node.start_byte + excerpt.start, node.end_byte + excerpt.start)
        for name, nodes in QueryCursor(highlights_query()).captures(excerpt.tree.root_node).items()
        for node in nodes
    }


@given(some.lists(LINES, max_size=9), EDITS)
@settings(deadline=None)
def test_a_tree_after_edits_is_that_of_the_text(lines: list[str], edits: list[Edit]) -> None:
    document = Document("\n".join(lines).encode())
    for edit in edits:
        edited(document, edit)
    fresh = Document(document.text)
    assert str(document.tree.root_node) == str(fresh.tree.root_node)
    assert document.tree.root_node.end_byte == fresh.tree.root_node.end_byte


@given(some.lists(LINES, min_size=1, max_size=9), EDITS, some.data())
@settings(deadline=None)
def test_an_excerpt_is_highlighted_as_the_whole_text(
    lines: list[str], edits: list[Edit], data: some.DataObject
) -> None:
    document = Document("\n".join(lines).encode())
    for edit in edits:
        edited(document, edit)
        assert document.tree is not None  # where the comments are is then known
    text = document.text
    start = data.draw(some.integers(0, len(text)))
    end = data.draw(some.integers(start, len(text)))
    whole = QueryCursor(highlights_query()).captures(new_parser().parse(text).root_node)
    first = text.rfind(b"\n", 0, start) + 1
    last = text.find(b"\n", end)
    last = len(text) if last < 0 else last
    expected = {
        (name, node.start_byte, node.end_byte)
        for name, nodes in whole.items()
        for node in nodes
        if node.end_byte > first and node.start_byte < last
    }
    found = {entry for entry in captures(document, start, end) if entry[2] > first}
    assert {entry for entry in found if entry[1] < last} == expected


def test_an_excerpt_takes_a_chain_of_comments_along() -> None:
    text = b"load a as b /* one\n*/ load c as d /* two\n*/ load e as f /* three\nend */ load g as h"
    document = Document(text)
    start = text.index(b"end */")
    excerpt = document.excerpt(start, start)
    assert (excerpt.start, excerpt.text) == (0, text)
    assert ("comment", text.index(b"/* three"), start + 6) in captures(document, start, start)


def test_an_edit_beyond_the_text_is_refused() -> None:
    document = Document(b"load a as b")
    for start, end in ((-1, 0), (3, 2), (0, 12)):
        try:
            document.edit(start, end, b"")
        except ValueError:
            continue
        raise AssertionError((start, end))
