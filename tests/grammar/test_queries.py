"""The queries that editors use, and what a parser must survive."""

from __future__ import annotations

from itertools import pairwise

import pytest
import tree_sitter_plastron
from tree_sitter import Language, Parser, Query, QueryCursor

from plastron_tui.language import DECLARATIONS, Declaration, SlotKind
from plastron_tui.language.keywords import WORDS
from plastron_tui.language.tokens import WORD_KINDS, leaves
from plastron_tui.ros.qos_words import WORDS as QOS_WORDS

from .statements import STATEMENTS

LANGUAGE = Language(tree_sitter_plastron.language())
MISTAKES = [
    '/* x */ $ \'a "b"',
    "create_node \"x\" = as 'x'",
    'n1 foo "bar" . /',
    'create_message m of message_type T and input "a\\n',
    "generate_node n1 /* never closed",
]


def test_abi() -> None:
    assert LANGUAGE.abi_version == 15
    assert LANGUAGE.name == "plastron"


@pytest.mark.parametrize(
    "query",
    [
        tree_sitter_plastron.HIGHLIGHTS_QUERY,
        tree_sitter_plastron.LOCALS_QUERY,
        tree_sitter_plastron.TAGS_QUERY,
    ],
    ids=["highlights", "locals", "tags"],
)
def test_queries_name_what_the_grammar_has(query: str) -> None:
    assert Query(LANGUAGE, query).capture_count > 0


def test_highlights_are_disjoint() -> None:
    text = "\n".join([text for texts in STATEMENTS.values() for text in texts] + MISTAKES)
    root = Parser(LANGUAGE).parse(text.encode()).root_node
    captures = QueryCursor(Query(LANGUAGE, tree_sitter_plastron.HIGHLIGHTS_QUERY)).captures(root)
    spans = sorted(
        (node.start_byte, node.end_byte) for nodes in captures.values() for node in nodes
    )
    assert len(spans) > 200
    for (_, end), (start, _) in pairwise(spans):
        assert end <= start


def captured(query: str, text: str) -> dict[str, list[str]]:
    """Return what is captured in a text, by capture."""
    root = Parser(LANGUAGE).parse(text.encode()).root_node
    captures = QueryCursor(Query(LANGUAGE, query)).captures(root)
    return {
        name: [(node.text or b"").decode() for node in nodes] for name, nodes in captures.items()
    }


def test_every_keyword_is_highlighted() -> None:
    text = "\n".join(text for texts in STATEMENTS.values() for text in texts)
    words = "keyword", "keyword.function", "constant.builtin", "boolean"
    found = captured(tree_sitter_plastron.HIGHLIGHTS_QUERY, text + " , False")
    assert {text for word in words for text in found[word]} - {*QOS_WORDS} == WORDS
    firsts = {declaration.keyword for declaration in DECLARATIONS.values()}
    assert set(found["keyword.function"]) == firsts


@pytest.mark.parametrize(
    "declaration", DECLARATIONS.values(), ids=[each.kind for each in DECLARATIONS.values()]
)
def test_every_variable_is_defined_or_referred_to(declaration: Declaration) -> None:
    """A declaration's variables, as its example has them, are what queries for editors find."""
    root = Parser(LANGUAGE).parse(declaration.example.encode()).root_node.children[0]
    assert root.type == declaration.kind
    variables: dict[bool, list[str]] = {True: [], False: []}
    calls = []
    for slot in declaration.slots:
        node = root.child_by_field_name(slot.name)
        text = "" if node is None or node.text is None else node.text.decode()
        if slot.kind.is_variable:
            variables[slot.kind.makes is not None].append(text)
        elif slot.kind is SlotKind.FUNCTION and text:
            calls.append(text)
    found = captured(tree_sitter_plastron.LOCALS_QUERY, declaration.example)
    assert found.get("local.definition", []) == variables[True]
    assert sorted(found.get("local.reference", [])) == sorted(variables[False])
    tags = captured(tree_sitter_plastron.TAGS_QUERY, declaration.example)["name"]
    assert set(tags) >= {*variables[True], *variables[False], *calls}


def test_a_message_knows_each_word_for_a_word() -> None:
    text = "\n".join(text for texts in STATEMENTS.values() for text in texts)
    root = Parser(LANGUAGE).parse(text.encode()).root_node
    words = {
        each.node.type for each in leaves(root) if (each.node.text or b"").decode().isidentifier()
    }
    assert words <= WORD_KINDS


@pytest.mark.parametrize("opening", ["(", "[", "x=(", "(1,"])
@pytest.mark.parametrize("closing", ["", "\n", "]", "$"])
def test_deep_brackets_do_not_crash_the_parser(opening: str, closing: str) -> None:
    line = b"create_message m of message_type T and input " + opening.encode() * 100_000
    root = Parser(LANGUAGE).parse(line + closing.encode()).root_node
    assert root.has_error
    assert root.type == "program"
