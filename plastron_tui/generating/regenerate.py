"""Writing a node that was loaded: the text that the program started from, with its changes.

A program that is generated again finds its own output. It starts from what it started from
before; what was changed by hand since is merged, line by line where that does, endpoint by
endpoint otherwise.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.source import FileSet
from plastron_tui.output.manifest import Base
from plastron_tui.output.node_json import remember_all
from plastron_tui.output.patch_stack import Layer, Layers, digest_of

from .apply_changes import Adaptation
from .destination import Place, Writing, find_place, found_by
from .line_merge import Sides, merge_lines, restored_lines, tell_lost_in, tell_rewritten
from .lost_lines import dropped_line
from .merged import Merged
from .node_files import NodeFiles, are_recorded
from .user_edits import cover, kept_handwork, of_other_program, unmergeable

# What an edit leaves behind is told when it is made; who runs the program again knows.
_ONCE = (
    *(codes.UNCALLED_FUNCTION, codes.STILL_READ, codes.IDLE_CODE, codes.STILL_NAMED),
    codes.UNREAD_PARAMETER,
)


class Derived(NamedTuple):
    """The files of a loaded node, or why there are none."""

    files: NodeFiles | None
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class Derivation:
    """One `generate_node` of a loaded node.

    Attributes:
        work: what the program makes of the node.
        writing: where its files are written.
    """

    work: Adaptation
    writing: Writing

    def result(self) -> Derived:
        """Make the files."""
        made = self.work.made_of(self.work.source)
        if made.files is None:
            return Derived(None, self.work.refusal(made))
        writing, target, is_ported = self.writing, self.work.library.target, self.work.is_ported
        path = self.work.source.path
        name = f"{path.stem}{target.language.suffix}" if is_ported else path.name
        home = self.work.nodes[0].home
        if home is not None and not writing.in_place:
            name = target.packaged(home, name)
        # A header lies in another folder than the source that it belongs to.
        leads_out = any(each.startswith("../") for each in made.files.names)
        is_elsewhere = writing.in_place and not is_ported
        is_elsewhere = is_elsewhere and (leads_out or path.parent != writing.output)
        shown = path if is_elsewhere else writing.output / name
        place = find_place(shown, writing.author, writing.manifests)
        layer = self._layer(place, made.files)
        # A file that is written over where it came from keeps its mode: it is the user's.
        is_over = not is_ported and path == shown and place.present is not None
        files = NodeFiles(
            name,
            layer.written,
            target.language.is_executable and not is_over,
            path=shown if is_elsewhere else None,
            seen=((place.real.parent, place.manifest),),
        )
        notes = self.work.placed(made)
        if place.index is None:
            derived = Derived(self._first(files, place, layer))
        else:
            derived = self._again(files, place, place.index, layer)
            known = place.layers[place.index]
            if known.written == layer.written or _asks_the_same(layer, known):
                # It was told when that was written, and may be removed by hand since.
                notes = tuple(each for each in notes if each.code not in _ONCE)
        return derived._replace(diagnostics=(*notes, *derived.diagnostics))

    @property
    def _is_mixed(self) -> bool:
        """Whether the program loads what it made of a file that has handwork in it."""
        origin = self.work.source.origin
        return origin is not None and origin.start not in (None, origin.files)

    def _without_handwork(self, place: Place, made: FileSet) -> tuple[FileSet, FileSet]:
        """Return what the program starts from, and what it makes of it, without handwork.

        Where the program changes what was added by hand, that counts as there from the start.
        """
        source, origin = self.work.source, self.work.source.origin
        if origin is not None and origin.start is not None:
            return origin.start, made
        if origin is None or origin.files == source.files or not self._is_from(place):
            return source.files, made
        pure = self.work.made_of_original()
        return (source.files, made) if pure is None else (origin.files, pure)

    def _is_from(self, place: Place) -> bool:
        """Tell whether the source has the handwork of the very file that is written."""
        origin = self.work.source.origin
        return origin is not None and origin.output == place.real

    def _layer(self, place: Place, made: FileSet) -> Layer:
        author, origin = self.writing.author, self.work.source.origin
        start, written = self._without_handwork(place, made)
        is_from = self._is_from(place)
        read = origin.files if origin is not None and is_from else start
        nodes = self.work.own_nodes() if is_from else self.work.nodes
        # A link stays one: what it leads to may be another file later.
        first = (self.work.source.path if origin is None else origin.path).absolute()
        is_itself = os.path.realpath(first) == os.fspath(place.real)
        return Layer(
            author.name,
            start,
            written,
            remember_all(nodes, self.work.library.target.name, author.name),
            None if is_itself else os.path.relpath(first, place.real.parent),
            None if is_itself else digest_of(read),
            text=author.text,
        )

    def _first(self, files: NodeFiles, place: Place, layer: Layer) -> NodeFiles:
        """Write where the program wrote nothing yet, or nothing that is left."""
        author = self.writing.author
        present, loaded = place.present, self.work.source.files
        is_kept = not self.work.is_ported and (present == loaded or files.path is not None)
        is_over = layer.origin is None and present == loaded
        lower = place.layers if is_over else ()
        name = place.real.name
        layers: Layers | None = None
        if author.name and not (layer.origin is None and layer.original == layer.written):
            is_clean = is_over and (
                are_recorded(place.manifest, name, loaded)
                or are_recorded(self.writing.manifests(self.writing.output), files.name, loaded)
            )
            layers = (*lower, replace(layer, is_clean=is_clean, left=digest_of(layer.written)))
        elif place.manifest.layers.get(name, ()) != lower:
            layers = lower
        files = replace(files, merged_from=loaded if is_kept else None, layers=layers)
        owner = place.owner(self.writing.manifests(self.writing.output), files.name)
        is_others = owner is not None and author.name not in ("", owner)
        if owner is not None and is_others and present not in (None, loaded, files.files):
            files = replace(files, problem=of_other_program(place.shown, owner))
        return files

    def _again(self, files: NodeFiles, place: Place, index: int, layer: Layer) -> Derived:
        """Write where the program wrote before."""
        known = place.layers[index]
        upper, force = place.layers[index + 1 :], self.writing.force
        before = found_by(place, index)
        assert place.present is not None
        if before != known.written and not force and _asks_the_same(layer, known):
            # Another version may lay the same out in another way: that is no reason to merge.
            layer = replace(layer, written=known.written)
        merged = self._with_handwork(place, known, before, layer)
        if merged.files is None:
            problem = unmergeable(place.shown, merged.reason)
            return Derived(replace(files, problem=problem), merged.notes)
        covered = cover(place.shown, upper, before, merged.files, place.present, force=force)
        if self._is_mixed:
            # What is the program's and what is not can no longer be told apart in what it loads.
            if covered.files == place.present and not force:
                known_still = replace(files, files=place.present, merged_from=place.present)
                files = replace(known_still, has_handwork=True, layers=place.layers)
                return Derived(files, merged.notes)
            covered = covered._replace(
                problem=unmergeable(place.shown, "the program changes what it loads of its own")
            )
        is_as_left = covered.layers or covered.files == place.present
        left = known.left if is_as_left else digest_of(covered.files)
        kept: Layers = (replace(layer, is_clean=known.is_clean, left=left),)
        if layer.origin is None and layer.original == layer.written and not covered.layers:
            kept = ()
        is_renewed = force and place.has_handwork
        is_clean = covered.files == layer.written or (covered.layers and not place.has_handwork)
        files = replace(
            files,
            files=covered.files,
            merged_from=None if is_renewed else place.present,
            has_handwork=not is_clean,
            layers=(*place.layers[:index], *kept, *covered.layers),
            problem=covered.problem,
        )
        return Derived(files, (*merged.notes, *covered.notes))

    def _with_handwork(self, place: Place, known: Layer, before: FileSet, new: Layer) -> Merged:
        """Bring what was changed by hand into what the program makes."""
        from .endpoint_merge import merge

        mine = new.written
        if self.writing.force or before == known.written:
            return Merged(mine)
        notes = (kept_handwork(place.shown, place.shown.name),)
        origin = self.work.source.origin
        # Handwork that the program changes is in the original, and the texts tell nothing.
        is_apart = origin is None or new.original in (origin.files, origin.start)
        if mine == known.written and is_apart:
            return Merged(before, notes=notes)
        if origin is not None and origin.is_torn:
            return Merged(None, f"`{origin.path}`, which it was made from, was changed as well")
        bases = [(node, self.work.base(known, node)) for node in self.work.nodes]
        target, catalog = self.work.library
        sides = Sides(place.real, known.written, mine, before)
        nodes = () if self.work.is_ported else bases
        files = merge_lines(sides, nodes, target)
        restored = restored_lines(sides, new.original)
        if files is None and restored:
            files = merge_lines(sides, nodes, target, restores=True)
        if files is not None:
            return Merged(files, notes=notes)
        if origin is not None and known.seen != new.seen:
            return Merged(None, f"`{origin.path}`, which it was made from, in the same lines")
        if self.work.is_ported:
            return Merged(None, "the program now changes the same lines")
        merged = Merged(before, notes=notes)
        for node, base in bases:
            read = None if merged.files is None else target.read(place.real, merged.files).source
            if read is None or node.source is None:
                return merged._replace(files=None)
            made = merge(read.only(node.source.label), base, node, target, catalog)
            told = () if made.files is None else made.all_notes
            merged = Merged(made.files, made.reason, (*merged.notes, *told))
        dropped = None if merged.files is None else dropped_line(mine, before, merged.files)
        if dropped is not None:
            # Endpoint by endpoint, more goes than program and hands ask for.
            files = merge_lines(sides, nodes, target, side_by_side=True)
            reason = f"it has changes beside what the program changes, and would lose `{dropped}`"
            return Merged(files, notes=notes) if files is not None else Merged(None, reason)
        merged = tell_lost_in(merged, sides, target)
        if restored:
            merged = tell_rewritten(merged, restored, place.shown)
        return merged._replace(notes=merged.all_notes, lost=())


def _asks_the_same(layer: Layer, known: Layer) -> bool:
    """Tell whether a program asks for what it asked for before, of the same files."""
    fields = ("text", "original", "origin", "seen")
    is_same = all(getattr(layer, each) == getattr(known, each) for each in fields)
    return is_same and _as_known(layer.base, known.base) == _as_known(known.base, known.base)


def _as_known(base: Base, known: Base) -> Base:
    """Return a base without what an earlier version did not remember.

    That are whole kinds, and whether a program leaves a rate open.
    """
    untyped = {kind.value for kind in EndpointKind if kind.facts.interface is None}
    found = {key: each for key, each in base.items() if key not in untyped - known.keys()}
    publishers = found.get(EndpointKind.PUBLISHER.value)
    if isinstance(publishers, dict):
        found[EndpointKind.PUBLISHER.value] = {
            name: _closed(each) for name, each in publishers.items()
        }
    return found


def _closed(publisher: Any) -> Any:
    """Return a publisher without whether its rates were left open; a broken one as it is."""
    match publisher:
        case {"sends": [*sends]}:
            return {**publisher, "sends": [_closed_sending(each) for each in sends]}
        case _:
            return publisher


def _closed_sending(sent: Any) -> Any:
    match sent:
        case [rate, message, {"open": _, **rest}]:
            return [rate, message, rest] if rest else [rate, message]
        case _:
            return sent
