"""A loaded node's text, with what the program changes in it, for a client library."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.loading import add_found
from plastron_tui.model.source import FileSet, Remove, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.output.layers import Layer
from plastron_tui.output.remembered import recall
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.base import Rendered

from .changes import call_again, changes_of, drop, is_extended, names_in
from .handwork import files_on_disk

if TYPE_CHECKING:
    from plastron_tui.targets.base import Target


class Library(NamedTuple):
    """A client library to write for, and the interface types of its ROS."""

    target: Target
    catalog: Catalog


@dataclass(frozen=True, slots=True)
class Adaptation:
    """What a program makes of a node that it loaded, wherever that is written.

    Attributes:
        node: the node.
        source: what it was loaded from.
        library: what the node is written for.
        own: the source's own client library; None where there is none.
    """

    node: Node
    source: SourceUnit
    library: Library
    own: Library | None

    @property
    def is_ported(self) -> bool:
        """Whether the node goes to another client library than it came from."""
        return self.source.library != self.library.target.name

    def made_of(self, source: SourceUnit) -> Rendered:
        """Make the program's changes in a text, and bring it to the target's client library."""
        changes = changes_of(self.node)
        if not self.is_ported:
            return self.library.target.edit(source, changes, self.library.catalog)
        if changes and self.own is not None:
            own = self.own.target
            edited = own.edit(source, changes, self.own.catalog)
            files = edited.files
            read = None if files is None else own.read(source.path, files).source
            if read is None:
                return edited
            source = read
        return self.library.target.port(self.node, source, self.library.catalog)

    def made_of_original(self) -> FileSet | None:
        """Return what the program would make of what it found at first, None for nothing."""
        origin = self.source.origin
        if origin is None or self.own is None:
            return None
        read = self.own.target.read(self.source.path, origin.files).source
        return None if read is None else self.made_of(read).files

    def placed(self, made: Rendered) -> tuple[Diagnostic, ...]:
        """Return what was found, with no place where the text is not as it is on the disk."""
        if not self.is_ported or not (changes_of(self.node) or self.source.origin):
            return made.diagnostics
        return tuple(found._replace(span=None) for found in made.diagnostics)

    def refusal(self, made: Rendered) -> tuple[Diagnostic, ...]:
        """Say why a change is refused, with the lines of the file as it is on the disk."""
        if self.own is None:
            return made.diagnostics
        own, catalog = self.own
        present = files_on_disk(self.source.path)
        read = None if present is None else own.read(self.source.path, present).source
        for source in (read, self.source) if read is not None else (self.source,):
            for change in changes_of(self.node):
                if isinstance(change, Remove) and change.name in names_in(source)[change.kind]:
                    alone = own.edit(source, [change], catalog)
                    if alone.files is None:
                        return alone.diagnostics
        return made.diagnostics

    def own_node(self) -> Node:
        """Return the node without what was added to the file by hand, or calls another function."""
        node = self.node.snapshot()
        original = self._original()
        if original is None:
            return node
        names = names_in(original)
        asked = set()
        for (kind, name), endpoint in self.node.endpoints.items():
            if endpoint.span is not None or is_extended(endpoint):
                asked.add((kind, name))
            elif name not in names[kind]:
                drop(node, kind, name)
        for each in original.endpoints:
            if (each.kind, each.name) not in asked and each.name is not None:
                call_again(node, each, each.name)
        return node

    def _original(self) -> SourceUnit | None:
        """Return what the program found at first, without handwork."""
        origin = self.source.origin
        if origin is None or self.own is None:
            return None
        return self.own.target.read(origin.path, origin.files).source

    def base(self, known: Layer) -> Node | None:
        """Return what the node had when the file was written, and what was added by hand."""
        base, original = recall(known.base), self._original()
        if base is None or original is None:
            return base
        names = names_in(original)
        for each in self.source.endpoints:
            if each.name is not None and each.name not in names[each.kind]:
                add_found(base, each, each.name)
        return base
