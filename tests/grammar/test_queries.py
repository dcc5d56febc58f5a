"""The queries that editors use, and what a parser must survive."""

from __future__ import annotations

from itertools import pairwise

import pytest
import tree_sitter_plastron
from tree_sitter import Language, Parser, Query, QueryCursor

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


@pytest.mark.parametrize("opening", ["(", "[", "x=(", "(1,"])
@pytest.mark.parametrize("closing", ["", "\n", "]", "$"])
def test_deep_brackets_do_not_crash_the_parser(opening: str, closing: str) -> None:
    line = b"create_message m of message_type T and input " + opening.encode() * 100_000
    root = Parser(LANGUAGE).parse(line + closing.encode()).root_node
    assert root.has_error
    assert root.type == "program"
