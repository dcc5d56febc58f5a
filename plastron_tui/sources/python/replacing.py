"""Text of a file that an update replaces where it stands."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic

from .addition import Addition
from .analysis import Analysis, Site
from .references import identifiers, is_member
from .splices import Splice
from .syntax import parse

_WORD = re.compile(rb"\w+")


class NotInPlaceError(Exception):
    """An endpoint cannot be changed where it stands: the file decides it elsewhere."""


@dataclass(slots=True)
class Replacement:
    """The update of one endpoint.

    Attributes:
        added: what is written of the endpoint.
        site: the call that creates it.
        splices: what takes the place of text, or deletes it.
        lost: the call sites that a reader no longer finds as they were.
        is_silent: what was sent is deleted; what is sent now is still to be added.
        notes: warnings: what may no longer fit.
    """

    added: Addition
    site: Site
    splices: list[Splice] = field(default_factory=list)
    lost: list[Site] = field(default_factory=list)
    is_silent: bool = False
    notes: list[Diagnostic] = field(default_factory=list)

    @property
    def analysis(self) -> Analysis:
        """The file."""
        return self.added.analysis

    def put(self, node: Node, text: str) -> None:
        """Replace an expression by one that says something else."""
        written = self.analysis.syntax.encode(text)
        if _tokens(node) != _tokens(parse(written).root):
            self.splices.append(Splice(node.start_byte, node.end_byte, written))

    def all_splices(self) -> list[Splice]:
        """Return all that makes the update, imports and functions included."""
        return [*self.added.imports.splices(), *self.splices, *self.added.writer.splices]

    def freed(self) -> frozenset[str]:
        """Return the names that are used in what is replaced or deleted."""
        syntax = self.analysis.syntax
        gone = [(each.start, each.end) for each in self.splices]
        words = {word for start, end in gone for word in _WORD.findall(syntax.text, start, end)}
        names = (word.decode(syntax.encoding, "replace") for word in words)
        return frozenset(
            name
            for name in names
            if any(
                start <= node.start_byte < end and not is_member(node)
                for node in identifiers(name, self.analysis)
                for start, end in gone
            )
        )


def _tokens(node: Node) -> list[bytes]:
    """Return the text of an expression without what only formats it."""
    found: list[bytes] = []
    pending = [node]
    while pending:
        each = pending.pop()
        if each.type == "comment":
            continue
        pending += reversed(each.children)
        if not each.children:
            if found[-1:] == [b","] and each.type in (")", "]"):
                found.pop()
            found.append(each.text or b"")
    return found
