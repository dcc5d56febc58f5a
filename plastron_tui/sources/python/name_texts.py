"""The texts of a file that say the name of an endpoint, whatever they are for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.gone_names import is_surely_name

from .analysis import Analysis
from .references import identifiers
from .splices import is_commented_code, line_end, line_start

# Frames of tf and attributes often have the names of topics.
_OTHER = re.compile(rb"frame|transform|\btf|(has|get|set)attr", re.IGNORECASE)


class NameText(NamedTuple):
    """A string that says a name.

    Attributes:
        node: the string.
        start: the byte where the name begins, with the `/` or `~` before it.
        end: the byte behind it.
        written: the name as the string says it.
        is_whole: whether the string says nothing else.
        is_sure: whether it is no plain word that may mean something else.
    """

    node: Node
    start: int
    end: int
    written: str
    is_whole: bool
    is_sure: bool


def texts_saying(analysis: Analysis, name: str) -> Iterator[NameText]:
    """Yield the strings of a file that say a name, but for docstrings.

    What goes on before or behind a string, as in `prefix + '/scan'`, says another name.
    """
    bare = name.lstrip("~/")
    for found, node in _mentions(analysis, bare):
        if node.type != "string" or is_documentation(node):
            continue
        if _goes_on(node, found.start(), found.end()):
            continue
        parts = [each for each in node.named_children if each.type == "string_content"]
        is_whole = [analysis.syntax.slice(each).lstrip("~/") for each in parts] == [bare]
        is_sure = is_surely_name(found[0], bare, node.text or b"")
        yield NameText(node, found.start(), found.end(), found[0].decode(), is_whole, is_sure)


def docs_naming(analysis: Analysis, name: str) -> Iterator[NameText]:
    """Yield the comments and docstrings that say a name for sure, but for code in comments."""
    bare, text = name.lstrip("~/"), analysis.syntax.text
    is_word = bare.isidentifier() and any(identifiers(bare, analysis))
    for found, node in _mentions(analysis, bare):
        is_docstring = node.type == "string" and is_documentation(node)
        if not is_docstring and (node.type != "comment" or is_commented_code(node.text or b"")):
            continue
        line = text[line_start(text, found.start()) : line_end(text, found.start())]
        written = found[0].decode()
        is_sure = is_surely_name(found[0], bare, line) and not (is_word and written == bare)
        said = NameText(node, found.start(), found.end(), written, False, is_sure)
        if is_sure and not is_other_name(analysis, said):
            yield said


def _mentions(analysis: Analysis, bare: str) -> Iterator[tuple[re.Match[bytes], Node]]:
    """Yield where a file says a name, with the string, comment or expression that does."""
    word = re.compile(rb"(?<![\w/.}-])[~/]*%s(?![\w/{]|[.-]\w)" % re.escape(bare.encode()))
    for found in word.finditer(analysis.syntax.text):
        node = analysis.syntax.root.descendant_for_byte_range(found.start(), found.end())
        while node is not None and node.type in ("string_content", "escape_sequence"):
            node = node.parent
        if node is not None:
            yield found, node


def is_documentation(string: Node) -> bool:
    """Whether a string is a statement of its own."""
    return string.parent is not None and string.parent.type == "expression_statement"


def _goes_on(string: Node, start: int, end: int) -> bool:
    """Whether a name at an end of a string is a part of one that an expression makes."""
    parts = [each for each in string.named_children if each.type == "string_content"]
    outer = string.parent
    if outer is None or not parts or outer.type not in ("binary_operator", "concatenated_string"):
        return False
    operator = outer.child_by_field_name("operator")
    if operator is not None and operator.type != "+":
        return False
    is_first = outer.start_byte == string.start_byte
    is_last = outer.end_byte == string.end_byte
    return (start == parts[0].start_byte and not is_first) or (
        end == parts[-1].end_byte and not is_last
    )


def is_other_name(analysis: Analysis, text: NameText) -> bool:
    """Whether the line of a text speaks of something else that has names."""
    source = analysis.syntax.text
    start = source.rfind(b"\n", 0, text.start) + 1
    end = source.find(b"\n", text.end)
    return bool(_OTHER.search(source, start, end if end >= 0 else len(source)))
