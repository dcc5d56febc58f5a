"""The queries that editors use, and what a parser must survive."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import pytest
import tree_sitter_plastron
from machine import mostly_long
from tree_sitter import Language, Parser, Query, QueryCursor

from plastron_tui.language import DECLARATIONS, Declaration, SlotKind
from plastron_tui.language.keywords import WORDS
from plastron_tui.language.tokens import WORD_KINDS, leaves
from plastron_tui.ros.qos_words import WORDS as QOS_WORDS

from .statements import STATEMENTS

LANGUAGE = Language(tree_sitter_plastron.language())
QUERIES = Path(__file__).parents[2] / "tree-sitter-plastron" / "queries"
HELIX = sorted((QUERIES / "helix").glob("*.scm"))
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
        tree_sitter_plastron.FOLDS_QUERY,
        tree_sitter_plastron.INDENTS_QUERY,
        tree_sitter_plastron.INJECTIONS_QUERY,
        *[path.read_text() for path in HELIX],
    ],
    ids=[
        *("highlights", "locals", "tags", "folds", "indents", "injections"),
        *(f"helix/{path.stem}" for path in HELIX),
    ],
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


HELIX_NAMES = {
    "@boolean": "@constant.builtin.boolean",
    "@module": "@namespace",
    "@number": "@constant.numeric",
    "@property": "@variable.other.member",
    "@string.escape": "@constant.character.escape",
}


def test_helix_highlights_the_same_under_its_own_names() -> None:
    ours = tree_sitter_plastron.HIGHLIGHTS_QUERY.splitlines()
    renamed = [
        re.sub(r"@[a-z.]+", lambda name: HELIX_NAMES.get(name[0], name[0]), line) for line in ours
    ]
    assert (QUERIES / "helix" / "highlights.scm").read_text().splitlines()[1:] == renamed[1:]


TWO_THINGS = """\
// What a talker
// does.
create_node 'talker' as talker
// It says hello.
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
/* Of
   another thing. */
create_robot 'rover' as rover
rover has_link 'base'
rover has_link 'wheel' /* round */
generate_robot rover
generate_node talker
"""


def lines_captured(query: str, name: str, text: str) -> list[tuple[int, int]]:
    """Return the first and last lines of what each match captures, counted from 1."""
    root = Parser(LANGUAGE).parse(text.encode()).root_node
    matches = [match[name] for _, match in QueryCursor(Query(LANGUAGE, query)).matches(root)
               if name in match]  # fmt: skip
    lines = [(nodes[0].start_point.row + 1, nodes[-1].end_point.row + 1) for nodes in matches]
    return sorted(each for each in lines if each[0] < each[1])


def test_what_is_said_of_a_thing_folds() -> None:
    folds = lines_captured(tree_sitter_plastron.FOLDS_QUERY, "fold", TWO_THINGS)
    assert folds == [(1, 2), (3, 6), (7, 8), (9, 12)]
    objects = (QUERIES / "helix" / "textobjects.scm").read_text()
    assert lines_captured(objects, "class.around", TWO_THINGS) == [(3, 6), (9, 12)]
    assert lines_captured(objects, "class.inside", TWO_THINGS) == [(5, 6), (10, 12)]
    assert lines_captured(objects, "comment.around", TWO_THINGS) == [(1, 2), (7, 8)]


@pytest.mark.parametrize("declaration", DECLARATIONS.values(), ids=str)
def test_every_statement_about_a_thing_folds_with_it(declaration: Declaration) -> None:
    """A new statement has to be in one of the lists, unless it makes what others are about."""
    nodes = re.findall(r"\((\w+_statement)\)", tree_sitter_plastron.FOLDS_QUERY)
    assert nodes.count(declaration.kind) == 1
    objects = (QUERIES / "helix" / "textobjects.scm").read_text()
    assert re.findall(r"\((\w+_statement)\)", objects) == nodes


def test_statements_begin_at_the_start_of_a_line_and_comments_are_another_language() -> None:
    indents = captured(tree_sitter_plastron.INDENTS_QUERY, TWO_THINGS)
    assert len(indents["indent.zero"]) == 13
    assert len(indents["indent.auto"]) == 2
    injected = captured(tree_sitter_plastron.INJECTIONS_QUERY, TWO_THINGS)["injection.content"]
    assert {"// What a talker", "/* round */"} < set(injected)


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
@pytest.mark.parametrize("closing", mostly_long(["", "\n", "]", "$"], ["", "$"]))
def test_deep_brackets_do_not_crash_the_parser(opening: str, closing: str) -> None:
    line = b"create_message m of message_type T and input " + opening.encode() * 100_000
    root = Parser(LANGUAGE).parse(line + closing.encode()).root_node
    assert root.has_error
    assert root.type == "program"
