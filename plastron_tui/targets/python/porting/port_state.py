"""A file on its way to the other client library: rewrites, comments, and new imports."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from tree_sitter import Node

from plastron_tui.model.unique_names import numbered
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType, Section
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.callbacks import callback_target
from plastron_tui.sources.python.conventions import Conventions, conventions_of
from plastron_tui.sources.python.references import STATEMENT_PARENTS, is_member
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope
from plastron_tui.sources.python.splices import (
    Splice,
    apply,
    delete_statements,
    line_end,
    line_start,
)

# Where a comment may stand on a line of its own, beside before a statement.
_CLAUSES = frozenset({"elif_clause", "else_clause", "except_clause", "finally_clause"})


IMPORTS = frozenset({"import_statement", "import_from_statement", "future_import_statement"})
"""The types of the statements that import."""

COMMENT = "# port by hand: "
SEPARATOR = "; "
"""Between what one comment names."""


@dataclass(frozen=True, slots=True)
class Mark:
    """What has to be ported by hand.

    Attributes:
        node: what is meant.
        what: the words of the comment.
        remedy: what to write instead, where that is known.
        has_comment: whether the comment is in the text already.
    """

    node: Node
    what: str
    remedy: str | None = None
    has_comment: bool = False


@dataclass(frozen=True, slots=True)
class _Move:
    """Lines that go behind others; the lines from `end` to `gone` are left out."""

    start: int
    end: int
    gone: int
    to: int
    before: bytes

    def apply(self, text: bytes, splices: list[Splice]) -> list[Splice]:
        """Return splices that move the lines as well, with what is rewritten in them."""
        inside = [each for each in splices if self.start <= each.start and each.start < self.end]
        within = [
            Splice(each.start - self.start, each.end - self.start, each.text) for each in inside
        ]
        moved = self.before + apply(text[self.start : self.end], within)
        others = [each for each in splices if each not in inside]
        return [Splice(self.to, self.to, moved), *others, Splice(self.start, self.gone)]


@dataclass(slots=True)
class Work:
    """A file on its way.

    Attributes:
        analysis: what the file is.
        catalog: the types of the distribution that it goes to.
        marks: what has to be ported by hand.
        done: the ids of syntax nodes that are rewritten, so that nothing of them needs a mark.
        imports: import lines that the rewritten file needs.
        constants: lines that go behind the imports at the top of the file.
        helpers: functions that go behind them.
        callbacks: the functions that the endpoints call.
        before: the types of the distribution that it comes from.
        conventions: how the file writes things.
        kinds: what expressions give, by the ids of their nodes.
        types: the types of messages and their fields, by the ids of the expressions.
        freed: imported names whose uses are written otherwise.
        anchors: the statements before which rclpy makes the nodes, by the ids of the calls that
            make them; None until somebody asks.
    """

    analysis: Analysis
    catalog: Catalog
    marks: list[Mark] = field(default_factory=list)
    done: set[int] = field(default_factory=set)
    imports: set[str] = field(default_factory=set)
    constants: list[str] = field(default_factory=list)
    helpers: list[str] = field(default_factory=list)
    callbacks: dict[int, Scope] = field(default_factory=dict)
    before: Catalog = field(init=False)
    conventions: Conventions = field(init=False)
    kinds: dict[int, str | None] = field(default_factory=dict)
    types: dict[int, Section | FieldType | None] = field(default_factory=dict)
    freed: set[str] = field(default_factory=set)
    anchors: dict[int, Node] | None = None
    _splices: list[Splice] = field(default_factory=list)
    _last: list[Splice] = field(default_factory=list)
    _deleted: list[Node] = field(default_factory=list)
    _moves: list[_Move] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.before = Catalog(self.analysis.library.distribution)
        self.conventions = conventions_of(self.analysis)
        for site in self.analysis.sites:
            function = self.callback_of(site)
            if function is not None:
                self.callbacks[function.node.id] = function

    def string(self, value: str) -> str:
        """Write a string in the file's quotes."""
        return self.conventions.string(value)

    def slice(self, node: Node) -> str:
        """Return the source of a node, as it was."""
        return self.analysis.syntax.slice(node)

    def scope(self, node: Node) -> Scope:
        """Return the scope that a node is in."""
        return self.analysis.scopes.at(node.start_byte)

    def qualified(self, node: Node) -> tuple[str, ...]:
        """Return the qualified names that an expression may stand for."""
        return self.analysis.resolver.qualified(node, self.scope(node))

    def bindings(self, node: Node) -> list[Binding]:
        """Return all that a name or an attribute is bound to."""
        if node.type == "attribute":
            return self.analysis.resolver.attribute_bindings(node, self.scope(node))
        found = self.scope(node).lookup(self.slice(node)) if node.type == "identifier" else None
        return found[1] if found is not None else []

    def text(self, node: Node) -> str:
        """Return the source of a node, with what is rewritten inside of it."""
        inner = [
            Splice(each.start - node.start_byte, each.end - node.start_byte, each.text)
            for each in (*self._splices, *self._last)
            if node.start_byte <= each.start and each.end <= node.end_byte
        ]
        source = self.analysis.syntax.text[node.start_byte : node.end_byte]
        return apply(source, inner).decode(self.analysis.syntax.encoding, "replace")

    def replace(self, node: Node, text: str) -> None:
        """Rewrite a node; what was rewritten inside of it must be in the text."""
        self.done.add(node.id)
        self.replace_between(node.start_byte, node.end_byte, text)

    def replace_between(self, start: int, end: int, text: str) -> None:
        """Rewrite what is between two offsets, with what was rewritten there."""
        for splices in (self._splices, self._last):
            splices[:] = [each for each in splices if not (start <= each.start and each.end <= end)]
        self._put(start, end, text)

    def insert(self, offset: int, text: str) -> None:
        """Insert text."""
        self._put(offset, offset, text)

    def insert_first(self, offset: int, text: str) -> None:
        """Insert text before all else that is inserted at the place."""
        self._splices.insert(0, Splice(offset, offset, self.analysis.syntax.encode(text)))

    def insert_last(self, offset: int, text: str) -> None:
        """Insert text behind all else that is or will be inserted at the place."""
        self._last.append(Splice(offset, offset, self.analysis.syntax.encode(text)))

    def cut(self, splice: Splice) -> None:
        """Take text away."""
        self._splices.append(splice)

    def move(self, start: int, end: int, gone: int, to: int, before: str) -> None:
        """Move the lines between two offsets to another, behind `before`; `gone` ends the gap."""
        self._moves.append(_Move(start, end, gone, to, self.analysis.syntax.encode(before)))

    def delete(self, statement: Node) -> None:
        """Take a statement away, with all that is in it."""
        self._deleted.append(statement)

    def keep(self, statement: Node) -> None:
        """Keep a statement as it was, which was to be taken away or rewritten."""
        place = (statement.start_byte, statement.end_byte)
        self._splices = [each for each in self._splices if (each.start, each.end) != place]
        self._deleted = [each for each in self._deleted if each.id != statement.id]

    def mark(self, node: Node, what: str, remedy: str | None = None) -> None:
        """Note what has to be ported by hand, for the line where it stands."""
        self.marks.append(Mark(node, what, remedy))

    def is_gone(self, node: Node) -> bool:
        """Tell whether a node is in a statement that is taken away."""
        return any(
            gone.start_byte <= node.start_byte and node.end_byte <= gone.end_byte
            for gone in self._deleted
        )

    def is_written(self, name: Node) -> bool:
        """Tell whether a name is in the new file: not taken away, nor rewritten without it."""
        if self.is_gone(name):
            return False
        words = re.compile(rf"(?<![\w.]){re.escape(self.slice(name))}(?!\w)")
        around = [
            each.text.decode(self.analysis.syntax.encoding, "replace")
            for each in (*self._splices, *self._last)
            if each.start <= name.start_byte and name.end_byte <= each.end
        ]
        return all(words.search(text) is not None for text in around)

    def is_rewritten(self, node: Node) -> bool:
        """Tell whether a node is in what is rewritten as a whole."""
        return any(
            each.start <= node.start_byte and node.end_byte <= each.end
            for each in (*self._splices, *self._last)
        )

    def is_in_callback(self, node: Node) -> bool:
        """Tell whether a node is in the body of a callback, which is carried over as it is."""
        return any(
            function.start <= node.start_byte < function.end for function in self.callbacks.values()
        )

    def callback_of(self, site: Site) -> Scope | None:
        """Return the function of the file that an endpoint calls."""
        if site.shape.callback is None:
            return None
        given = site.arguments.get(site.shape.callback)
        target = callback_target(given, site.scope, self.analysis)
        if target is None or target is not given:
            return None
        if target.type == "identifier":
            found = site.scope.lookup(self.slice(target))
            bindings = found[1] if found is not None else []
        else:
            bindings = self.analysis.resolver.attribute_bindings(target, site.scope)
        functions = [each.owner for each in bindings if each.kind is BindingKind.FUNCTION]
        return functions[0] if len(functions) == 1 else None

    def free_name(self, wanted: str) -> str:
        """Return a name that the file does not use."""
        used = {name for scope in self.analysis.scopes.all for name in scope.bindings}
        wishes = chain((wanted, f"ros_{wanted}"), numbered(f"_ros_{wanted}"))
        return next(name for name in wishes if name not in used)

    def result(self, limit: int) -> bytes:
        """Return the file with all that was noted; comments are no longer than a line may be."""
        syntax = self.analysis.syntax
        newline = b"\r\n" if b"\r\n" in syntax.text else b"\n"
        lines: dict[int, list[str]] = {}
        for mark in self.marks:
            if mark.has_comment:
                continue
            place = comment_place(mark.node, syntax.text)
            words = lines.setdefault(line_start(syntax.text, place.start_byte), [])
            if mark.what not in words:
                words.append(mark.what)
        splices = [*self._splices, *self._last, *delete_statements(syntax.text, self._deleted)]
        for at, words in lines.items():
            line = syntax.text[at : line_end(syntax.text, at)]
            indent = line[: len(line) - len(line.lstrip(b" \t\f"))]
            comments = _comments(words, limit - len(indent))
            text = b"".join(indent + syntax.encode(each) + b"\n" for each in comments)
            splices.append(Splice(at, at, text))
        for move in reversed(self._moves):
            splices = move.apply(syntax.text, splices)
        fitted = [
            Splice(each.start, each.end, each.text.replace(b"\r\n", b"\n").replace(b"\n", newline))
            for each in splices
        ]
        return apply(syntax.text, fitted)

    def _put(self, start: int, end: int, text: str) -> None:
        self._splices.append(Splice(start, end, self.analysis.syntax.encode(text)))


def _comments(words: list[str], room: int) -> list[str]:
    """Return the comments that name what is to be ported by hand, as many as it takes."""
    first, *others = words
    found = [COMMENT + first]
    for word in others:
        longer = found[-1] + SEPARATOR + word
        if len(longer) <= room:
            found[-1] = longer
        else:
            found.append(COMMENT + word)
    return found


def comment_place(node: Node, text: bytes) -> Node:
    """Return the statement or clause around a node that begins its line."""
    current = node
    while (parent := current.parent) is not None and parent.type != "module":
        mate = current.prev_named_sibling if parent.type in STATEMENT_PARENTS else None
        if mate is not None and mate.end_point.row == current.start_point.row:
            current = mate  # `x = 1; y = 2` has one comment
            continue
        is_own = parent.type in STATEMENT_PARENTS or current.type in _CLAUSES
        if is_own and not text[line_start(text, current.start_byte) : current.start_byte].strip():
            return current
        current = parent
    return current


def walk(root: Node) -> Iterator[Node]:
    """Yield the named nodes of a tree, parents first."""
    pending = [root]
    while pending:
        node = pending.pop()
        yield node
        pending.extend(reversed(node.named_children))


def is_inner(node: Node) -> bool:
    """Tell whether a node is a part of a dotted name, or names an argument."""
    return node.parent is not None and (node.parent.type == "attribute" or is_member(node))


def is_imported(node: Node) -> bool:
    """Tell whether a node stands in an import."""
    current = node.parent
    while current is not None and current.type not in IMPORTS:
        current = current.parent
    return current is not None


def first_of(nodes: Iterable[Node]) -> Node | None:
    """Return the node that comes first in the text."""
    return min(nodes, key=lambda node: node.start_byte, default=None)
