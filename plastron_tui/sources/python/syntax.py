"""A Python file as bytes, and its syntax tree over exactly these bytes."""

from __future__ import annotations

import codecs
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import tree_sitter_python
from tree_sitter import Node

from plastron_tui.sources.grammars import (
    AS_LETTERS,
    BoundedParser,
    Grammar,
    ParsedFile,
    count_errors,
    is_too_deep,
    python_lines,
    wide_errors,
)
from plastron_tui.sources.text_memo import remembered

from .error_recovery import bound_indents, mask_errors, straighten

# PEP 263: a coding line is one of the first two lines.
_CODING = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")

# What an encoding has to leave as it is, so that the grammar can be parsed from the bytes.
_ASCII = bytes([9, 10, *range(32, 127)])

# In these a part of a file has no meaning of its own, and some take the square of its length.
_NO_TEXT = frozenset({"idna", "punycode", "raw-unicode-escape", "unicode-escape", "utf-7"})

FUNCTIONS = frozenset({"function_definition", "lambda"})
"""What has statements of its own, which run when it is called."""

REPEATING = frozenset({"for_statement", "while_statement"})
"""The statements that repeat what they hold."""


@dataclass(frozen=True, slots=True)
class Syntax(ParsedFile):
    """A parsed Python file.

    Where the text does not parse, in `errors` places, the tree is of a text of the same length
    in which the lines at fault are masked.
    """

    grammar: ClassVar[Grammar] = Grammar(
        tree_sitter_python.language, Path(__file__).with_name("queries")
    )

    def called_name(self, call: Node | None) -> str:
        """Return the last name of what a call calls, "" for what has none or is no call."""
        callee = call.child_by_field_name("function") if call is not None else None
        if callee is not None and callee.type == "attribute":
            callee = callee.child_by_field_name("attribute")
        return self.slice(callee) if callee is not None and callee.type == "identifier" else ""

    def encode(self, text: str) -> bytes:
        """Return new source in the encoding of the file.

        Raises:
            UnicodeEncodeError: the encoding has no such character.
        """
        return text.encode(self.encoding)


@remembered
def parse(text: bytes) -> Syntax:
    """Parse a file, whatever its encoding, without moving an offset."""
    encoding = _encoding(text)
    source = text if encoding == "utf-8" else text.translate(AS_LETTERS)
    source = bound_indents(python_lines(source))
    parser = BoundedParser(Syntax.grammar.language())
    tree = parser.parse(source)
    errors = count_errors(tree.root_node)
    if errors and (straight := straighten(source)) != source:
        straightened = parser.parse(straight)
        if (fewer := count_errors(straightened.root_node)) < errors:
            source, tree, errors = straight, straightened, fewer
    if errors:
        masked = parser.parse(mask_errors(source))
        if count_errors(masked.root_node) < errors:
            tree = masked
    if next(wide_errors(tree.root_node), None) or is_too_deep(source, tree.root_node):
        tree = parser.given_up()
        errors = max(errors, 1)
    return Syntax(text, encoding, tree, errors)


def _encoding(text: bytes) -> str:
    """Return the encoding that the file names, or else the one that its bytes are in."""
    # A coding line that the bytes contradict is no better than none.
    wishes = [name for name in (declared_encoding(text), "utf-8", "latin-1") if name is not None]
    return next(name for name in wishes if _is_in(text, name))


def _is_in(text: bytes, encoding: str) -> bool:
    try:
        text.decode(encoding)
    except UnicodeError:
        return False
    return True


def declared_encoding(text: bytes) -> str | None:
    """Return what the coding line names, where Python could read a file in it."""
    if text.startswith(codecs.BOM_UTF8):
        return None
    for line in text.splitlines()[:2]:
        if found := _CODING.match(line):
            name = found[1].decode("ascii", "replace")
            try:
                is_text = _ASCII.decode(name) == _ASCII.decode("ascii")
                codec = codecs.lookup(name).name
            except (LookupError, UnicodeError):
                return None
            if not is_text or codec in _NO_TEXT:
                return None
            return "utf-8" if codec in ("utf-8", "utf-8-sig") else name
        if line.split(b"#")[0].strip():
            break
    return None


def parts_of(node: Node | None) -> list[Node]:
    """Return the named children of a node, without comments and the backslashes at line ends."""
    children = node.named_children if node is not None else []
    return [child for child in children if child.type not in ("comment", "line_continuation")]


def holders(target: Node | None) -> list[Node]:
    """Return `a.b` and `a` of `a.b.c`."""
    found = []
    while target is not None and target.type in ("attribute", "subscript"):
        target = target.child_by_field_name("object") or target.child_by_field_name("value")
        found += [target] if target is not None else []
    return found


def is_main_guard(statement: Node) -> bool:
    """Whether a statement holds what runs when the file is started."""
    condition = statement.child_by_field_name("condition")
    return condition is not None and b"__name__" in (condition.text or b"")


def is_in_loop(node: Node, loops: frozenset[str] = REPEATING) -> bool:
    """Whether a node is in a loop of its function, and not in what the loop goes over."""
    current: Node | None = node
    while current is not None and current.type not in FUNCTIONS:
        inner, current = current, current.parent
        if current is not None and current.type in loops:
            ahead = current.child_by_field_name("right")
            if ahead is None or ahead.id != inner.id:
                return True
    return False


def nodes_in(root: Node, ranges: Iterable[tuple[int, int]]) -> Iterator[Node]:
    """Yield the nodes that begin in parts of a text, from one offset to another each."""
    for start, end in ranges:
        pending = [root.descendant_for_byte_range(start, max(start, end - 1))]
        while pending:
            node = pending.pop()
            if node is None or node.end_byte <= start or node.start_byte >= end:
                continue
            pending.extend(node.named_children)
            if node.start_byte >= start:
                yield node
