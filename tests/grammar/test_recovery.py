"""What is wrong on a line stays on that line: the lines around it are statements, always."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import pytest
import tree_sitter_plastron
from cases import check_each
from hypothesis import example, given, settings
from hypothesis import strategies as st
from machine import examples
from tree_sitter import Language, Node, Parser

from .statements import ENDINGS, STATEMENTS

LANGUAGE = Language(tree_sitter_plastron.language())
WHOLE = [(kind, text) for kind, texts in STATEMENTS.items() for text in texts]
FIRST_WORDS = sorted({text.split(" ", 1)[0] for _, text in WHOLE})
WORDS = sorted({word for _, text in WHOLE for word in text.split(" ")})
STRAYS = [
    '"', "'", "\\", "$", "/", "//", "*/", "é", "😀", "\0", "\t", "\f", "\r", "\ufeff", "\u2028",
    '"abc', "'abc", '"a\\q"', '"a\\u12"', "1e", "-", "+.", "..", ";", "{", "}", "a/", "a/b/c/d",
    "// comment", "None", "_", "*", "<", ">", "received.", "parameter 'a",
]  # fmt: skip


PARSER = Parser(LANGUAGE)


def parse(text: str) -> Node:
    return PARSER.parse(text.encode()).root_node


def mistakes(root: Node) -> Iterator[Node]:
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.is_error or node.is_missing:
            yield node
        if node.has_error:
            waiting.extend(node.children)


def assert_statement(root: Node, row: int, kind: str, text: str) -> None:
    """The row holds this statement, from its first byte to its last, and nothing is wrong in it."""
    found = [node for node in root.named_children if node.start_point == (row, 0)]
    assert [node.type for node in found] == [kind], str(root)
    assert found[0].end_point == (row, len(text.encode())), str(root)
    assert not found[0].has_error, str(root)


def assert_mistakes_stay(root: Node, row: int) -> None:
    for node in mistakes(root):
        assert (node.start_point.row, node.end_point.row) == (row, row), str(root)


def assert_recovers(
    middle: str, before: tuple[str, str], after: tuple[str, str], newline: str = "\n"
) -> Node:
    root = parse(before[1] + newline + middle + newline + after[1] + newline)
    assert root.type == "program"
    assert_statement(root, 0, *before)
    assert_statement(root, 2, *after)
    assert_mistakes_stay(root, 1)
    return root


def neighbours() -> Iterator[tuple[tuple[str, str], tuple[str, str]]]:
    """Every statement before and after, the other side held."""
    for whole in WHOLE:
        yield whole, WHOLE[0]
        yield WHOLE[0], whole


def cuts(text: str) -> Iterator[str]:
    words = text.split(" ")
    return (" ".join(words[:count]) for count in range(1, len(words)))


def test_every_statement_of_the_grammar_has_examples() -> None:
    statement = LANGUAGE.id_for_node_kind("_statement", True)
    assert statement is not None
    kinds = {LANGUAGE.node_kind_for_id(kind) for kind in LANGUAGE.subtypes(statement)}
    assert kinds == set(STATEMENTS)


def test_whole_statements_parse() -> None:
    check_each(WHOLE, lambda kind, text: assert_statement(parse(text), 0, kind, text))


@pytest.mark.long
@pytest.mark.parametrize(("kind", "text"), WHOLE)
def test_cut_after_every_word(kind: str, text: str) -> None:
    for cut in cuts(text):
        for before, after in neighbours():
            root = assert_recovers(cut, before, after)
            assert root.has_error == ((text, cut) not in ENDINGS)


@pytest.mark.long
@pytest.mark.parametrize(("kind", "text"), WHOLE)
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_cut_within_every_word(kind: str, text: str, newline: str) -> None:
    followers = [
        next(whole for whole in WHOLE if whole[1].startswith(word)) for word in FIRST_WORDS
    ]
    for end in range(1, len(text)):
        for after in followers:
            assert_recovers(text[:end], WHOLE[-1], after, newline)


def assert_cuts_are_last(text: str, befores: Sequence[tuple[str, str]]) -> None:
    for cut in cuts(text):
        for before in befores:
            root = parse(before[1] + "\n" + cut)
            assert root.type == "program"
            assert_statement(root, 0, *before)
            assert_mistakes_stay(root, 1)


def test_a_cut_last_line_without_newline() -> None:
    """Behind some of the statements each; behind all of them it takes long."""
    cases = [(text, WHOLE[at % 8 :: 8]) for at, (_, text) in enumerate(WHOLE)]
    check_each(cases, assert_cuts_are_last)


@pytest.mark.long
def test_a_cut_last_line_behind_every_statement() -> None:
    check_each([(text, WHOLE) for _, text in WHOLE], assert_cuts_are_last)


def assert_strays_stay(text: str, strays: Sequence[str]) -> None:
    words = text.split(" ")
    for position in range(len(words) + 1):
        for stray in strays:
            middle = " ".join([*words[:position], stray, *words[position:]])
            assert_recovers(middle, WHOLE[0], WHOLE[-1])


def test_a_stray_word_between_any_two() -> None:
    """Each of them in some of the statements; in all of them it takes long."""
    cases = [(text, STRAYS[at % 4 :: 4]) for at, (_, text) in enumerate(WHOLE)]
    check_each(cases, assert_strays_stay)


@pytest.mark.long
def test_every_stray_word_between_any_two() -> None:
    check_each([(text, STRAYS) for _, text in WHOLE], assert_strays_stay)


@pytest.mark.long
@pytest.mark.parametrize(("kind", "text"), WHOLE)
def test_a_word_left_out_or_doubled(kind: str, text: str) -> None:
    words = text.split(" ")
    for position in range(len(words)):
        for after in WHOLE:
            assert_recovers(" ".join(words[:position] + words[position + 1 :]), WHOLE[0], after)
            assert_recovers(" ".join(words[: position + 1] + words[position:]), WHOLE[0], after)


def test_brackets_open_as_deep_as_one_likes() -> None:
    for opening in ("[", "(", "x=(", "[(", '["a", '):
        for depth in (1, 7, 8, 9, 16, 17, 40, 1000):
            middle = "create_message m of message_type T and input " + opening * depth
            assert_recovers(middle, WHOLE[0], WHOLE[-1])


def test_a_comment_without_an_end_keeps_to_its_line() -> None:
    for before, after in neighbours():
        root = assert_recovers("generate_node n1 /* never closed", before, after)
        assert root.has_error
    root = assert_recovers("/* a /* b // c", WHOLE[0], WHOLE[-1])
    assert root.has_error


def test_a_comment_that_is_closed_later_is_a_comment() -> None:
    root = parse("generate_node a /* one\n/* two\n*/ /* three\ngenerate_node b\n")
    comments = [node for node in root.named_children[0].children if node.type == "block_comment"]
    assert [(node.start_point.row, node.end_point.row) for node in comments] == [(0, 2)]
    assert_statement(root, 3, "generate_node_statement", "generate_node b")
    assert_mistakes_stay(root, 2)


words = st.one_of(st.sampled_from(WORDS), st.sampled_from(STRAYS))
wild_text = st.text(st.characters(exclude_characters="\n", exclude_categories=["Cs"]), max_size=8)
garbage = st.lists(st.one_of(words, words, wild_text), min_size=1, max_size=30).flatmap(
    lambda parts: st.sampled_from([" ", ""]).map(lambda space: space.join(parts))
)


@st.composite
def mutated(draw: st.DrawFn) -> str:
    """Draw a statement in which words are others, doubled, left out, or those of another one."""
    line = draw(st.sampled_from(WHOLE))[1].split(" ")
    for _ in range(draw(st.integers(1, 3))):
        first, last = sorted(draw(st.integers(0, len(line))) for _ in range(2))
        other = draw(st.sampled_from(WHOLE))[1].split(" ")
        new = draw(
            st.sampled_from([[], line[first:last] * 2, other[len(other) // 2 :]])
            | words.map(lambda word: [word])
        )
        line = [*line[:first], *new, *line[last:]]
    return " ".join(line)


@settings(max_examples=examples(2000), deadline=None)
@given(
    (garbage | mutated()).filter(lambda line: "/*" not in line),
    st.sampled_from(WHOLE),
    st.sampled_from(WHOLE),
    st.sampled_from(["\n", "\r\n"]),
)
@example("n1 pubish m", WHOLE[0], WHOLE[-1], "\n")
@example("stop_service T a = 1 $ AddTwoInts", WHOLE[-1], WHOLE[3], "\n")
@example('1e-3 a b ( hz "a "a $', WHOLE[12], WHOLE[5], "\n")
@example("' \0 \"x\" create_node 'a'", WHOLE[9], WHOLE[5], "\n")
def test_garbage(
    middle: str, before: tuple[str, str], after: tuple[str, str], newline: str
) -> None:
    assert_recovers(middle, before, after, newline)


@settings(max_examples=examples(300), deadline=None)
@given(st.lists(garbage.filter(lambda line: "/*" not in line), min_size=2, max_size=12))
def test_garbage_on_many_lines(lines: list[str]) -> None:
    """Every second line is whole, and stays so."""
    text = "".join(f"{line}\ngenerate_node n1\n" for line in lines)
    root = parse(text)
    for number in range(len(lines)):
        assert_statement(root, 2 * number + 1, "generate_node_statement", "generate_node n1")
    for node in mistakes(root):
        assert node.start_point.row == node.end_point.row
        assert node.start_point.row % 2 == 0


@settings(max_examples=examples(500), deadline=None)
@given(
    st.lists(st.one_of(st.sampled_from([t for _, t in WHOLE]), garbage), max_size=8),
    st.data(),
)
def test_an_edited_tree_is_the_tree_of_the_edited_text(
    lines: list[str], data: st.DataObject
) -> None:
    # Between two characters, as editors do: bytes that are none have no place that stays.
    written = "\n".join(lines)
    first = data.draw(st.integers(0, len(written)))
    last = data.draw(st.integers(first, min(len(written), first + 10)))
    old = written.encode()
    start, end = (len(written[:at].encode()) for at in (first, last))
    new = data.draw(st.sampled_from(["", " ", "\n", "/*", "*/", "'", '"', "x", "(", "\\"])).encode()
    text = old[:start] + new + old[end:]
    parser = Parser(LANGUAGE)
    tree = parser.parse(old)
    tree.edit(
        start,
        end,
        start + len(new),
        point(old, start),
        point(old, end),
        point(text, start + len(new)),
    )
    assert str(parser.parse(text, tree).root_node) == str(Parser(LANGUAGE).parse(text).root_node)


def point(text: bytes, offset: int) -> tuple[int, int]:
    return text.count(b"\n", 0, offset), offset - (text.rfind(b"\n", 0, offset) + 1)
