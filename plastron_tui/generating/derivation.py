"""Writing a node that was loaded: the text that the program started from, with its changes.

A program that is generated again finds its own output. It starts from what it started from
before; what was changed by hand since is merged, line by line where that does, endpoint by
endpoint otherwise.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.loading import add_found
from plastron_tui.model.source import Remove, SourceFile
from plastron_tui.model.workspace import Node
from plastron_tui.output.layers import Author, Layer, Layers, are_untouched
from plastron_tui.output.manifest import Manifest, digest
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.remembered import recall, remember
from plastron_tui.output.three_way import merge_lines
from plastron_tui.ros.catalog import Catalog
from plastron_tui.targets.base import Rendered

from .changes import call_again, changes_of, drop, is_extended, names_in
from .handwork import (
    cover,
    kept_handwork,
    layers_at,
    of_other_program,
    on_disk,
    unmergeable,
)

if TYPE_CHECKING:
    from plastron_tui.targets.base import Target

    from .merging import Merged


class Derived(NamedTuple):
    """The file of a loaded node, or why there is none."""

    file: OutputFile | None
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class Place:
    """Where a file is written, and what is known of what is there.

    Attributes:
        shown: the path, for people.
        real: the path with symbolic links resolved.
        present: what the file holds, None where there is none.
        manifest: what is remembered of the files of its folder.
        layers: what is remembered of programs that changed the file.
        index: the program's own place among them, None where it has none.
    """

    shown: Path
    real: Path
    present: bytes | None
    manifest: Manifest
    layers: Layers
    index: int | None

    @property
    def has_handwork(self) -> bool:
        """Whether the file was changed by hand since the program at hand wrote it."""
        return not are_untouched(self.layers[self.index or 0 :], self.present)

    def owner(self) -> str | None:
        """Return the program that the file was written by last, None where nothing tells."""
        if self.layers:
            return self.layers[-1].program
        known = self.manifest.bases.get(self.real.name, {}).get("program")
        return known if isinstance(known, str) and known else None


def find_place(shown: Path, author: Author, manifests: Callable[[Path], Manifest]) -> Place:
    """Look at the place where a file is, or shall be, and at what a program did there."""
    try:
        real = Path(os.path.realpath(shown))
    except (OSError, ValueError):
        real = shown
    manifest = manifests(real.parent)
    present = on_disk(real)
    layers = layers_at(real, manifest, present)
    return Place(shown, real, present, manifest, layers, author.place(layers))


def found_by(place: Place, index: int) -> bytes:
    """Return a program's output as it is before later programs' changes: handwork and all."""
    above = place.layers[index + 1 : index + 2]
    return above[0].original if above else place.present or b""


@dataclass(frozen=True, slots=True)
class Derivation:
    """One `generate_node` of a loaded node.

    Attributes:
        node: the node.
        source: what it was loaded from.
        target: what the node is written for.
        catalog: the interface types of the target's ROS.
        own: the target of the source's own client library, with its types; None where there is
            none.
        output: the output folder.
        manifests: gives what is remembered of the files of a folder.
        author: the program; of one that has no file nothing is remembered.
        in_place: whether the node is written over the file that it came from.
        force: whether it is written anew, whatever was changed by hand.
    """

    node: Node
    source: SourceFile
    target: Target
    catalog: Catalog
    own: tuple[Target, Catalog] | None
    output: Path
    manifests: Callable[[Path], Manifest]
    author: Author
    in_place: bool
    force: bool

    def result(self) -> Derived:
        """Make the file."""
        made = self._made(self.source)
        if made.text is None:
            return Derived(None, self._refusal(made))
        path = self.source.path
        name = f"{path.stem}{self.target.suffix}" if self._is_ported else path.name
        is_elsewhere = self.in_place and not self._is_ported and path.parent != self.output
        shown = path if is_elsewhere else self.output / name
        place = find_place(shown, self.author, self.manifests)
        layer = self._layer(place, made.text)
        # A file that is written over where it came from keeps its mode: it is the user's.
        is_over = not self._is_ported and (path == shown and place.present is not None)
        file = OutputFile(
            name,
            layer.written,
            self.target.is_executable and not is_over,
            path=shown if is_elsewhere else None,
        )
        if place.index is None:
            derived = Derived(self._first(file, place, layer))
        else:
            derived = self._again(file, place, place.index, layer)
        return derived._replace(diagnostics=(*self._placed(made), *derived.diagnostics))

    @property
    def _is_ported(self) -> bool:
        return self.source.library != self.target.name

    @property
    def _is_mixed(self) -> bool:
        """Whether the program loads what it made of a file that has handwork in it."""
        origin = self.source.origin
        return origin is not None and origin.start not in (None, origin.text)

    def _made(self, source: SourceFile) -> Rendered:
        """Make the program's changes in a text, and bring it to the target's client library."""
        changes = changes_of(self.node)
        if not self._is_ported:
            return self.target.edit(source, changes, self.catalog)
        if changes and self.own is not None:
            own, catalog = self.own
            edited = own.edit(source, changes, catalog)
            read = own.read(source.path, edited.text).source if edited.text is not None else None
            if read is None:
                return edited
            source = read
        return self.target.port(self.node, source, self.catalog)

    def _placed(self, made: Rendered) -> tuple[Diagnostic, ...]:
        """Return what was found, with no place where the text is not as it is on the disk."""
        if not self._is_ported or not (changes_of(self.node) or self.source.origin):
            return made.diagnostics
        return tuple(found._replace(span=None) for found in made.diagnostics)

    def _refusal(self, made: Rendered) -> tuple[Diagnostic, ...]:
        """Say why a change is refused, with the lines of the file as it is on the disk."""
        if self.own is None:
            return made.diagnostics
        own, catalog = self.own
        present = on_disk(self.source.path)
        read = None if present is None else own.read(self.source.path, present).source
        for source in (read, self.source) if read is not None else (self.source,):
            for change in changes_of(self.node):
                if isinstance(change, Remove) and change.name in names_in(source)[change.kind]:
                    alone = own.edit(source, [change], catalog)
                    if alone.text is None:
                        return alone.diagnostics
        return made.diagnostics

    def _without_handwork(self, place: Place, made: bytes) -> tuple[bytes, bytes]:
        """Return what the program starts from, and what it makes of it, without handwork.

        Where the program changes what was added by hand, that counts as there from the start.
        """
        source, origin = self.source, self.source.origin
        if origin is not None and origin.start is not None:
            return origin.start, made
        if origin is None or not self._is_from(place) or self.own is None:
            return source.text, made
        read = self.own[0].read(source.path, origin.text).source
        pure = None if read is None else self._made(read).text
        return (source.text, made) if pure is None else (origin.text, pure)

    def _is_from(self, place: Place) -> bool:
        """Tell whether the source has the handwork of the very file that is written."""
        origin = self.source.origin
        return origin is not None and origin.output == place.real

    def _layer(self, place: Place, made: bytes) -> Layer:
        start, written = self._without_handwork(place, made)
        origin = self.source.origin
        read = origin.text if origin is not None and self._is_from(place) else start
        # A link stays one: what it leads to may be another file later.
        first = (self.source.path if origin is None else origin.path).absolute()
        is_itself = os.path.realpath(first) == os.fspath(place.real)
        return Layer(
            self.author.name,
            start,
            written,
            remember(self._own_node(place), self.target.name, self.author.name),
            None if is_itself else os.path.relpath(first, place.real.parent),
            None if is_itself else digest(read),
            text=self.author.text,
        )

    def _own_node(self, place: Place) -> Node:
        """Return the node without what was added to the file by hand, or calls another function."""
        node = self.node.snapshot()
        original = self._original() if self._is_from(place) else None
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

    def _original(self) -> SourceFile | None:
        """Return what the program found at first, without handwork."""
        origin = self.source.origin
        if origin is None or self.own is None:
            return None
        return self.own[0].read(origin.path, origin.text).source

    def _first(self, file: OutputFile, place: Place, layer: Layer) -> OutputFile:
        """Write where the program wrote nothing yet, or nothing that is left."""
        present, loaded = place.present, self.source.text
        is_kept = not self._is_ported and (present == loaded or file.path is not None)
        is_over = layer.origin is None and present == loaded
        lower = place.layers if is_over else ()
        name = place.real.name
        layers: Layers | None = None
        if self.author.name and not (layer.origin is None and layer.original == layer.written):
            is_clean = is_over and place.manifest.has(name, loaded)
            layers = (*lower, replace(layer, is_clean=is_clean, left=digest(layer.written)))
        elif place.manifest.layers.get(name, ()) != lower:
            layers = lower
        file = replace(file, merged_from=loaded if is_kept else None, layers=layers)
        owner = place.owner()
        is_others = owner is not None and self.author.name not in ("", owner)
        if owner is not None and is_others and present not in (None, loaded, file.text):
            file = replace(file, problem=of_other_program(place.shown, owner))
        return file

    def _again(self, file: OutputFile, place: Place, index: int, layer: Layer) -> Derived:
        """Write where the program wrote before."""
        known = place.layers[index]
        upper = place.layers[index + 1 :]
        before = found_by(place, index)
        assert place.present is not None
        merged = self._with_handwork(place, known, before, layer)
        if merged.text is None:
            problem = unmergeable(place.shown, merged.reason)
            return Derived(replace(file, problem=problem), merged.notes)
        covered = cover(place.shown, upper, before, merged.text, place.present, force=self.force)
        if self._is_mixed:
            # What is the program's and what is not can no longer be told apart in what it loads.
            if covered.text == place.present and not self.force:
                known_still = replace(file, text=place.present, merged_from=place.present)
                file = replace(known_still, has_handwork=True, layers=place.layers)
                return Derived(file, merged.notes)
            covered = covered._replace(
                problem=unmergeable(place.shown, "the program changes what it loads of its own")
            )
        is_as_left = covered.layers or covered.text == place.present
        left = known.left if is_as_left else digest(covered.text)
        kept: Layers = (replace(layer, is_clean=known.is_clean, left=left),)
        if layer.origin is None and layer.original == layer.written and not covered.layers:
            kept = ()
        is_renewed = self.force and place.has_handwork
        is_clean = covered.text == layer.written or (covered.layers and not place.has_handwork)
        file = replace(
            file,
            text=covered.text,
            merged_from=None if is_renewed else place.present,
            has_handwork=not is_clean,
            layers=(*place.layers[:index], *kept, *covered.layers),
            problem=covered.problem,
        )
        return Derived(file, (*merged.notes, *covered.notes))

    def _with_handwork(self, place: Place, known: Layer, before: bytes, new: Layer) -> Merged:
        """Bring what was changed by hand into what the program makes."""
        from .merging import Merged, merge

        mine = new.written
        if self.force or before == known.written:
            return Merged(mine)
        notes = (kept_handwork(place.shown, place.shown.name),)
        origin = self.source.origin
        # Handwork that the program changes is in the original, and the texts tell nothing.
        is_apart = origin is None or new.original in (origin.text, origin.start)
        if mine == known.written and is_apart:
            return Merged(before, notes=notes)
        if origin is not None and origin.is_torn:
            return Merged(None, f"`{origin.path}`, which it was made from, was changed as well")
        base = self._base(known)
        text = merge_lines(known.written, mine, before)
        if text is not None and self._is_sound(place.real, text, before, mine, base):
            return Merged(text, notes=notes)
        if origin is not None and known.seen != new.seen:
            return Merged(None, f"`{origin.path}`, which it was made from, in the same lines")
        read = self.target.read(place.real, before).source
        if self._is_ported or read is None:
            return Merged(None, "the program now changes the same lines")
        merged = merge(read, base, self.node, self.target, self.catalog)
        return merged._replace(notes=(*notes, *merged.notes))

    def _base(self, known: Layer) -> Node | None:
        """Return what the node had when the file was written, and what was added by hand."""
        base, original = recall(known.base), self._original()
        if base is None or original is None:
            return base
        names = names_in(original)
        for each in self.source.endpoints:
            if each.name is not None and each.name not in names[each.kind]:
                add_found(base, each, each.name)
        return base

    def _is_sound(
        self, path: Path, text: bytes, before: bytes, mine: bytes, base: Node | None
    ) -> bool:
        """Tell whether lines were merged into a file that holds what it is to hold."""
        from .merging import call_sites

        sources = [self.target.read(path, each).source for each in (text, before, mine)]
        if self.target.is_worse(text, before, mine):
            return False
        if self._is_ported:
            return sources[0] is not None
        found, there, made = ({} if each is None else call_sites(each) for each in sources)
        wanted, known = self.node.endpoints, {} if base is None else base.endpoints
        has_all = all(key in found or (key in known and key not in there) for key in wanted)
        has_no_more = all(
            (key in wanted or (key in there and key not in known))
            and len(sites) <= max(len(there.get(key, ())), len(made.get(key, ())))
            for key, sites in found.items()
        )
        return has_all and has_no_more
