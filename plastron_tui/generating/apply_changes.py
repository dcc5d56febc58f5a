"""A loaded node's text, with what the program changes in it, for a client library."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import is_sending
from plastron_tui.model.loading import add_found
from plastron_tui.model.source import Add, Change, FileSet, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.output.node_json import recall
from plastron_tui.output.patch_stack import Layer
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.base import Rendered

from .node_diff import call_again, changes_of, names_in
from .user_edits import files_on_disk

if TYPE_CHECKING:
    from plastron_tui.targets.base import Target


class Library(NamedTuple):
    """A client library to write for, and the interface types of its ROS."""

    target: Target
    catalog: Catalog


@dataclass(frozen=True, slots=True)
class Adaptation:
    """What a program makes of the nodes that it loaded from one file, wherever that is written.

    Attributes:
        nodes: the nodes, each with the part of the file that is its own.
        library: what they are written for.
        own: the source's own client library; None where there is none.
    """

    nodes: tuple[Node, ...]
    library: Library
    own: Library | None

    @property
    def source(self) -> SourceUnit:
        """What the nodes were loaded from."""
        source = self.nodes[0].source
        assert source is not None, "a node that was loaded has a source"
        return source

    @property
    def is_ported(self) -> bool:
        """Whether the nodes go to another client library than they came from."""
        return self.source.library != self.library.target.name

    @property
    def changes(self) -> tuple[Change, ...]:
        """What the program changes in the file."""
        return tuple(change for node in self.nodes for change in changes_of(node))

    def made_of(self, source: SourceUnit) -> Rendered:
        """Make the program's changes in files, and bring them to the target's client library."""
        changes = self.changes
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
        return self.library.target.port(self.nodes[0], source, self.library.catalog)

    def made_of_original(self) -> FileSet | None:
        """Return what the program would make of what it found at first, None for nothing."""
        origin = self.source.origin
        if origin is None or self.own is None:
            return None
        read = self.own.target.read(self.source.path, origin.files).source
        return None if read is None else self.made_of(read).files

    def placed(self, made: Rendered) -> tuple[Diagnostic, ...]:
        """Return what was found, with no place where the text is not as it is on the disk."""
        if not self.is_ported or not (self.changes or self.source.origin):
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
            for change in self.changes:
                names = names_in(source.only(change.node))
                if not isinstance(change, Add) and change.name in names[change.kind]:
                    alone = own.edit(source, [change], catalog)
                    if alone.files is None:
                        return alone.diagnostics
        return made.diagnostics

    def own_nodes(self) -> tuple[Node, ...]:
        """Return the nodes without what was added by hand, or calls another function."""
        original = self._original()
        if original is None:
            return self.nodes
        return tuple(_own_node(node, original.only(_label(node))) for node in self.nodes)

    def _original(self) -> SourceUnit | None:
        """Return what the program found at first, without handwork."""
        origin = self.source.origin
        if origin is None or self.own is None:
            return None
        return self.own.target.read(origin.path, origin.files).source

    def base(self, known: Layer, node: Node) -> Node | None:
        """Return what a node had when the file was written, and what was added by hand."""
        original, label = self._original(), _label(node)
        base = recall(known.base, label)
        if base is None and label is not None and node.source is not None and recall(known.base):
            # The program changes another node of the file for the first time.
            base = Node(node.name, "", node.span, node.library)
            for each in node.source.endpoints:
                if each.label is not None:
                    add_found(base, each, each.label)
        if base is None or original is None or node.source is None:
            return base
        names = names_in(original.only(label))
        for each in node.source.endpoints:
            if each.label is not None and each.label not in names[each.kind]:
                add_found(base, each, each.label)
        return base


def _label(node: Node) -> str | None:
    return None if node.source is None else node.source.label


def _own_node(node: Node, original: SourceUnit) -> Node:
    own = node.snapshot()
    names = names_in(original)
    asked = set()
    for (kind, name), endpoint in node.endpoints.items():
        is_asked = endpoint.span is not None or (kind, name) in node.renamed
        if is_asked or is_sending(endpoint):
            asked.add((kind, name))
        elif name not in names[kind]:
            own.take(kind, name)
    for each in original.endpoints:
        if (each.kind, each.label) not in asked and each.label is not None:
            call_again(own, each, each.label)
    return own
