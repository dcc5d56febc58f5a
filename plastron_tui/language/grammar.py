"""The one handle on the compiled grammar."""

from __future__ import annotations

from functools import cache

import tree_sitter_plastron
from tree_sitter import Language, Parser, Query

LANGUAGE = Language(tree_sitter_plastron.language())


def new_parser() -> Parser:
    """Return a parser for Plastron."""
    return Parser(LANGUAGE)


def field_id(name: str) -> int:
    """Return the number of a field of the grammar."""
    number = LANGUAGE.field_id_for_name(name)
    if number is None:
        raise LookupError(f"the grammar has no field {name!r}")
    return number


def kind_id(name: str) -> int:
    """Return the number of a named node kind of the grammar."""
    number = LANGUAGE.id_for_node_kind(name, True)
    if number is None:
        raise LookupError(f"the grammar has no node {name!r}")
    return number


@cache
def highlights_query() -> Query:
    """Return the highlight query, compiled once."""
    return Query(LANGUAGE, tree_sitter_plastron.HIGHLIGHTS_QUERY)
