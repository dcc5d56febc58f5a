"""The lines of a source file of any size, coloured where they are looked at."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, overload

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.targets import language_of

from .source_lines import LONGEST, coloured, lexer_of
from .styles import Line, Piece

if TYPE_CHECKING:
    from tree_sitter import Language, Node, Tree

_XML = frozenset({".xml", ".urdf", ".xacro", ".launch", ".srdf", ".sdf"})

_LARGE = 512 * 1024
"""The bytes of the largest text that is parsed as a whole: that takes 0.2 seconds."""

_AROUND = 300
"""So many lines before those in sight are parsed of a larger one."""

_MOST_MADE = 5000
"""So many lines are remembered."""

_WIDEST = 10_000
"""The most bytes of a line that are shown."""

_WHOLE = {
    "comment": "quiet",
    "Comment": "quiet",
    "PI": "quiet",
    "XMLDecl": "quiet",
    "string": "string",
    "string_literal": "string",
    "raw_string_literal": "string",
    "char_literal": "string",
    "system_lib_string": "string",
    "AttValue": "string",
    "CDSect": "string",
    "integer": "number",
    "float": "number",
    "number_literal": "number",
    "true": "number",
    "false": "number",
    "none": "number",
    "null": "number",
    "decorator": "name",
    "primitive_type": "builtin",
    "type_identifier": "builtin",
}
"""The tones of syntax nodes, by their types in the grammars of Python, C++ and XML."""

_DEFINES = frozenset({"function_definition", "class_definition", "function_declarator"})
"""What a name is coloured in, since it defines that."""

_SIGNS = re.compile(r"[^\t\n]+")

_ELEMENTS = frozenset({"STag", "ETag", "EmptyElemTag"})


@cache
def _grammar(name: str) -> Language | None:
    """Return a grammar, None where it is not installed."""
    from tree_sitter import Language

    try:
        module = import_module(f"tree_sitter_{name}")
    except ImportError:
        return None
    load = getattr(module, "language_xml" if name == "xml" else "language", None)
    return None if load is None else Language(load())


def _grammar_of(path: Path) -> Language | None:
    if path.suffix in _XML:
        return _grammar("xml")
    language = language_of(path)
    return None if language is None else _grammar(language.name)


def _tone(node: Node, parent: str, field: str | None) -> str | None:
    """Return the tone of all of a syntax node, None where its parts have their own."""
    type_ = node.type
    if not node.is_named:
        # A keyword is a token that no rule names, and is spelt in letters: `def`, `#include`.
        return "keyword" if type_.lstrip("#").isalpha() else ""
    tone = _WHOLE.get(type_)
    if tone is not None:
        return "name" if type_ == "type_identifier" and parent == "class_specifier" else tone
    if type_ == "Name":
        return "keyword" if parent in _ELEMENTS else "name"
    if parent in _DEFINES and field in ("name", "declarator") and not node.named_child_count:
        return "name"
    if type_ == "qualified_identifier" and parent == "function_declarator":
        return "name"
    return None if node.child_count else ""


def _toned(tree: Tree, start: int, end: int) -> Iterator[tuple[int, int, str]]:
    """Yield the ranges of bytes that have a tone, of those between two offsets."""
    cursor = tree.walk()
    parents: list[str] = []
    while True:
        node = cursor.node
        if node is None or node.start_byte >= end:
            return
        parent = parents[-1] if parents else ""
        tone = _tone(node, parent, cursor.field_name)
        if tone:
            yield node.start_byte, node.end_byte, tone
        if tone is None and cursor.goto_first_child_for_byte(start) is not None:
            parents.append(node.type)
            continue
        while not cursor.goto_next_sibling():
            if not cursor.goto_parent():
                return
            parents.pop()


def _visible(text: str) -> str:
    """Return a text with what nobody would see escaped, tabs and ends of lines left out.

    Code can be written to look like other code, with signs that turn the direction of a line.
    """
    return _SIGNS.sub(lambda found: visible(found.group()), text)


class CodeLines(Sequence[Line]):
    """The lines of a text as `Line`s: each is made when it is asked for, with those around it."""

    def __init__(self, text: bytes, path: Path) -> None:
        """Index a text, and parse it where it is small.

        Args:
            text: the file's text.
            path: the file, which tells the language.
        """
        self.text = text
        self.starts = [0]
        find, at = text.find, text.find(b"\n")
        while at >= 0:
            self.starts.append(at + 1)
            at = find(b"\n", at + 1)
        if len(self.starts) > 1 and self.starts[-1] == len(text):
            self.starts.pop()
        self.widest = min(_WIDEST, max(self._end(row) - self.starts[row] for row in self._rows()))
        self._tree: Tree | None = None
        self._made: dict[int, Line] = {}
        self._grammar = _grammar_of(path)
        if self._grammar is not None:
            self._tree = self._parsed(0, len(text)) if len(text) <= _LARGE else None
        elif lexer_of(path) and len(self.starts) <= LONGEST and len(text) <= _LARGE:
            shown = text.decode("utf-8", "replace").replace("\r\n", "\n")
            self._made = dict(enumerate(coloured(_visible(shown), path)))

    def _rows(self) -> range:
        return range(len(self.starts))

    def _end(self, row: int) -> int:
        """Return where a line ends, its end of line left out."""
        start = self.starts[row]
        end = self.starts[row + 1] if row + 1 < len(self.starts) else len(self.text)
        for sign in (b"\n", b"\r"):
            if end > start and self.text[end - 1 : end] == sign:
                end -= 1
        return end

    def row_at(self, offset: int) -> int:
        """Return the row of an offset, from 0."""
        return bisect_right(self.starts, offset) - 1

    def __len__(self) -> int:
        """Return how many lines there are."""
        return len(self.starts)

    @overload
    def __getitem__(self, index: int) -> Line: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Line]: ...
    def __getitem__(self, index: int | slice) -> Line | Sequence[Line]:
        """Return a line, or several."""
        if isinstance(index, slice):
            return [self[row] for row in range(*index.indices(len(self)))]
        if not 0 <= index < len(self):
            raise IndexError(index)
        if index not in self._made:
            self._make(range(index, min(len(self), index + 64)))
        return self._made[index]

    def _parsed(self, start: int, end: int) -> Tree:
        from tree_sitter import Parser

        assert self._grammar is not None
        return Parser(self._grammar).parse(self.text[start:end])

    def _spans(self, rows: range) -> list[tuple[int, int, str]]:
        """Return the coloured ranges of rows; of a large text what is around them is parsed."""
        start, end = self.starts[rows[0]], self._end(rows[-1])
        if self._grammar is None or end - start > _LARGE:
            return []
        if self._tree is not None:
            return list(_toned(self._tree, start, end))
        base = self.starts[max(0, rows[0] - _AROUND)]
        if start - base > _LARGE:
            base = start
        tree = self._parsed(base, end)
        return [(at + base, to + base, tone) for at, to, tone in _toned(tree, start - base, end)]

    def _make(self, rows: range) -> None:
        if len(self._made) > _MOST_MADE and self._grammar is not None:
            self._made.clear()
        spans = self._spans(rows)
        at = 0
        for row in rows:
            first, last = self.starts[row], min(self._end(row), self.starts[row] + _WIDEST)
            while at < len(spans) and spans[at][1] <= first:
                at += 1
            self._made[row] = self._pieces(first, last, spans, at)

    def _pieces(
        self, first: int, last: int, spans: Sequence[tuple[int, int, str]], at: int
    ) -> Line:
        """Return a line between two offsets; the spans in it start with one of a number."""
        pieces: list[Piece] = []
        column = 0

        def add(start: int, end: int, tone: str) -> None:
            nonlocal column
            if start < end:
                words = _visible(self.text[start:end].decode("utf-8", "replace"))
                shown = (" " * (column % 4) + words).expandtabs(4)[column % 4 :]
                column += len(shown)
                pieces.append(Piece(shown, tone))

        while at < len(spans) and spans[at][0] < last:
            start, end, tone = spans[at]
            add(first, max(first, start), "")
            add(max(first, start), min(end, last), tone)
            first = max(first, min(end, last))
            at += 1
        add(first, last, "")
        return tuple(pieces)
