"""From what a program asked to generate to the texts of files."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import FileSet
from plastron_tui.model.workspace import Generation, Node
from plastron_tui.output.manifest import Manifest, Reading
from plastron_tui.output.node_json import recall, remember
from plastron_tui.output.patch_stack import are_untouched

from .apply_changes import Adaptation, Library
from .destination import Writing
from .file_names import is_same_path, refuse_name
from .merged import Merged
from .node_diff import changes_of
from .node_files import NodeFiles, are_recorded, name_of
from .regenerate import Derivation
from .user_edits import (
    cover,
    files_on_disk,
    kept_handwork,
    layers_at,
    of_other_program,
    unmergeable,
)

if TYPE_CHECKING:
    from plastron_tui.sources.base import Language

    from .line_merge import Sides

Notes = tuple[Diagnostic, ...]


@dataclass(frozen=True, slots=True)
class Generated:
    """The files of one `generate_node`, or why there are none.

    Attributes:
        generation: what was asked for.
        files: the files.
        diagnostics: what there is to say of them.
        earlier: what else was asked for, and is the same file before the program loads it.
    """

    generation: Generation
    files: NodeFiles | None
    diagnostics: tuple[Diagnostic, ...] = ()
    earlier: tuple[Generation, ...] = ()

    def path(self, output: Path) -> Path | None:
        """Return the path of the main file in an output folder, None where there are no files."""
        return None if self.files is None else self.files.path or output / self.files.name


class Manifests:
    """What is remembered of the files of the folders that are asked for.

    Attributes:
        problems: what is wrong with it.
    """

    def __init__(self, read: Callable[[Path], Reading]) -> None:
        """Set what reads a folder's manifest."""
        self.problems: list[Diagnostic] = []
        self._read = read
        self._known: dict[Path, Manifest] = {}

    def __call__(self, folder: Path) -> Manifest:
        """Return the manifest of a folder; one that is missing or broken is empty."""
        # Paths of one folder may differ: links, and a relative one.
        real = Path(os.path.realpath(folder))
        if real not in self._known:
            self._known[real], problems = self._read(folder)
            self.problems += problems
        return self._known[real]


def nodes_of_file(generation: Generation, generations: Sequence[Generation]) -> tuple[Node, ...]:
    """Return the nodes that a program loads from one file, each by its name, and generates.

    They are written to one file, with the changes of all.
    """
    source = generation.node.source
    if source is None or source.label is None:
        return (generation.node,)
    found = {source.label: generation.node}
    order = []
    for each in generations:
        other = each.node.source
        if other is None or other.label is None or each.library != generation.library:
            continue
        if other.path == source.path:
            order.append(other.label)
            if other.label != source.label:
                found[other.label] = each.node
    return tuple(found[label] for label in dict.fromkeys((*order, source.label)))


def last_of_each(made: Sequence[Generated], output: Path) -> list[Generated]:
    """Leave out the files that the program loads after it generated them, and generates again.

    Of two that are one file the last is kept; or the first, which knows of handwork in what it
    created, where the last neither changes nor changed anything.
    """
    rest: list[Generated] = []
    earlier: dict[int, tuple[Generation, ...]] = {}
    for at, each in enumerate(made):
        original = _original_of(each, made[:at], output)
        if original is None:
            rest.append(each)
        else:
            known = earlier.get(id(original), ())
            earlier[id(original)] = (*known, each.generation)
    loaded = [
        (at, source, _is_chained(each))
        for at, each in enumerate(rest)
        if (source := each.generation.node.source) is not None
    ]
    kept = []
    for index, each in enumerate(rest):
        is_created = each.generation.node.source is None
        path = each.path(output)
        later = [
            rest[at]
            for at, source, is_chained in loaded
            if source.path == path and (is_created or (at > index and is_chained))
        ]
        if path is None or not later:
            kept.append(each)
        else:
            known = (*earlier.get(id(later[-1]), ()), *earlier.get(id(each), ()))
            earlier[id(later[-1])] = (*known, each.generation)
    return [replace(each, earlier=earlier.get(id(each), ())) for each in kept]


def _original_of(made: Generated, before: Sequence[Generated], output: Path) -> Generated | None:
    """Return what a node is a copy of: what the program creates, loads and leaves as it was."""
    node, files = made.generation.node, made.files
    if node.source is None or files is None or files.path is not None or files.layers is not None:
        return None
    if node.source.library != made.generation.library or changes_of(node):
        return None
    return next(
        (
            other
            for other in before
            if other.generation.node.source is None
            and other.files is not None
            and other.files.name == files.name
            and output / files.name == node.source.path
        ),
        None,
    )


def _is_chained(made: Generated) -> bool:
    """Tell whether a node was loaded from what the program itself generates from another file."""
    source = made.generation.node.source
    return source is not None and source.origin is not None and source.origin.start is not None


def generate(
    generation: Generation,
    library: Library,
    writing: Writing,
    *,
    own: Library | None = None,
    nodes: Sequence[Node] = (),
) -> Generated:
    """Make the text of one `generate_node`.

    A created node is written anew; where its file was changed by hand, what the program changed
    since is merged into it, unless the new text is forced. A loaded node is the file that the
    program started from, changed by splices. Where it is for another client library, the changes
    are made in the file's own (`own`), and the result is ported.

    Args:
        generation: what is asked for.
        library: what the node is written for.
        writing: where files are written.
        own: the client library of a loaded node's file.
        nodes: all nodes of that file that the program generates, in their order.
    """
    node = generation.node
    if node.source is None:
        manifest = writing.manifests(writing.output)
        made = _Creation(generation, library, writing, manifest).result()
    else:
        derived = Derivation(Adaptation(tuple(nodes) or (node,), library, own), writing).result()
        made = Generated(generation, derived.files, derived.diagnostics)
    problem = _wrong_name(made, writing, library.target.language) or _outside(made)
    if made.files is None or problem is not None:
        return _refused(generation, made.diagnostics if problem is None else (problem,))
    return made


def _wrong_name(made: Generated, writing: Writing, language: Language) -> Diagnostic | None:
    """Say why a file cannot have its name, None where it can, or where there is none."""
    node, path, source = (
        made.generation.node,
        made.path(writing.output),
        made.generation.node.source,
    )
    if made.files is None or path is None:
        return None
    is_in_place = source is not None and is_same_path(path, source.path)
    names = (PurePath(name_of(made.files.name, each)).name for each in made.files.files.names)
    refusals = (
        refuse_name(name, node.packages, language, is_own=source is None, is_in_place=is_in_place)
        for name in names
    )
    return next(filter(None, refusals), None)


def _outside(made: Generated) -> Diagnostic | None:
    """Say which file of a loaded node would lie outside of the output folder, None for none.

    The files keep their places to each other, and the main one is where it would be alone.
    """
    files, node = made.files, made.generation.node
    if files is None or files.path is not None or node.source is None:
        return None
    names = (name_of(files.name, each) for each in files.files.names)
    outside = next((each for each in names if each.startswith("../")), None)
    if outside is None:
        return None
    message = f"`{PurePath(outside).name}` belongs to `{PurePath(files.name).name}`, and is too "
    message += "far from it for both to be in the output folder"
    help_ = "change the files where they are, with `--in-place`"
    return Diagnostic(codes.OUTSIDE_OUTPUT, message, node.span, help=help_)


@dataclass(frozen=True, slots=True)
class _Creation:
    """One `generate_node` of a created node."""

    generation: Generation
    library: Library
    writing: Writing
    manifest: Manifest

    def result(self) -> Generated:
        node, output, manifest = self.generation.node, self.writing.output, self.manifest
        target, catalog = self.library
        program = self.writing.author.name
        unwritable = target.unwritable(node)
        if unwritable is not None:
            return _refused(self.generation, (unwritable,))
        name = self.writing.names.of(node, target)
        rendered = target.render(_called(node, name), catalog)
        if rendered.files is None:
            return _refused(self.generation, rendered.diagnostics)
        base = remember(node, target.name, program)
        files = NodeFiles(
            name,
            rendered.files,
            target.language.is_executable,
            base=base,
            seen=((output, manifest),),
        )
        owner = _other_program(output / name, name, self.writing)
        there = files_on_disk(output / name) if owner is not None else None
        if owner is not None and there not in (None, rendered.files):
            # Forced too it is a conflict, so that a backup is kept.
            files = replace(files, problem=of_other_program(output / name, owner))
            return Generated(self.generation, files, rendered.diagnostics)
        return self._written(files, rendered.diagnostics)

    def _written(self, files: NodeFiles, notes: Notes) -> Generated:
        """Write a node where it was before, or where nothing is."""
        path = self.writing.output / files.name
        present = files_on_disk(path)
        layers = layers_at(path, _layers_of(path, self.writing), present)
        # What programs that loaded the file made of it lies over what is to be renewed.
        before = layers[0].original if layers else present
        is_foreign = before != files.files and files.name not in self.manifest
        if layers and layers[0].origin is None and is_foreign:
            # Programs that loaded somebody's file do not make it one of Plastron's.
            return Generated(self.generation, replace(files, layers=()), notes)
        is_clean = are_recorded(self.manifest, files.name, before)
        is_own = before in (None, files.files) or is_clean or any(x.is_clean for x in layers[:1])
        if not (self.writing.force or is_own or before is None or files.name not in self.manifest):
            merged = self._merged(files.name, path, files.files, before)
            if merged.files is None:
                problem = unmergeable(path, merged.reason)
                return Generated(self.generation, replace(files, problem=problem), notes)
            files = replace(files, files=merged.files, merged_from=before, has_handwork=True)
            notes = (*notes, kept_handwork(path, files.name), *merged.all_notes)
        if layers and before is not None and present is not None:
            force = self.writing.force
            covered = cover(path, layers, before, files.files, present, force=force)
            is_renewed = force and not (is_own and are_untouched(layers, present))
            files = replace(
                files,
                files=covered.files,
                merged_from=None if is_renewed else present,
                layers=covered.layers,
                problem=covered.problem,
            )
            notes = (*notes, *covered.notes)
        return Generated(self.generation, files, notes)

    def _merged(self, name: str, path: Path, mine: FileSet, present: FileSet) -> Merged:
        """Merge what the program changed in a node into a file that was changed by hand."""
        from plastron_tui.targets import read_source

        from .endpoint_merge import merge
        from .line_merge import merge_created

        seen = read_source(path, present).source
        target, catalog = self.library
        if seen is not None and seen.library != target.name:
            return Merged(None, f"it is a node of `{seen.library}`")
        read = target.read(path, present)
        if read.source is None or not read.source.nodes:
            return Merged(None, "it holds no node that can be read")
        known = self.manifest.bases.get(name)
        base, node = None if known is None else recall(known), self.generation.node
        sides = None if base is None else self._sides(path, base, mine, present)
        if base is None or sides is None:
            return merge(read.source, base, node, target, catalog)
        return merge_created(read.source, sides, (node, base), self.library)

    def _sides(self, path: Path, base: Node, mine: FileSet, present: FileSet) -> Sides | None:
        """Return what is merged by lines, None where what the program made before is not known.

        A node in a package may have the style of one alone: an earlier version of Plastron wrote
        it, or a formatter did. It keeps the style that it has more lines of.
        """
        from .line_merge import Sides, lines_in_common

        target, catalog = self.library
        node = self.generation.node.snapshot()
        base.home = node.home
        base.file = node.file = path.name
        made = target.render(base, catalog).files
        if node.home is not None and made is not None:
            base.home = node.home = None
            alone = target.render(base, catalog).files
            if alone is not None and lines_in_common(alone, present) > lines_in_common(
                made, present
            ):
                made, mine = alone, target.render(node, catalog).files or mine
        return None if made is None else Sides(path, made, mine, present)


def _called(node: Node, name: str) -> Node:
    """Let a node know its file, by the file's name in the output folder: others may name it."""
    return replace(node, file=PurePath(name).name)


def _layers_of(path: Path, writing: Writing) -> Manifest:
    """Return the manifest that knows what programs made of a file: that of its own folder."""
    return writing.manifests(Path(os.path.realpath(path)).parent)


def _other_program(path: Path, name: str, writing: Writing) -> str | None:
    """Return the other program that a file was made by, None where nothing tells of one."""
    program, manifest = writing.author.name, writing.manifests(writing.output)
    layers = _layers_of(path, writing).layers.get(path.name, ())
    known = manifest.bases.get(name, {}).get("program")
    if layers and layers[0].origin is not None:
        known = layers[0].program
    is_other = isinstance(known, str) and known and program and known != program
    return known if is_other else None


def _refused(generation: Generation, diagnostics: Notes) -> Generated:
    """Give every diagnostic a place: where none says better, the statement that generates."""
    return Generated(
        generation,
        None,
        tuple(
            found
            if found.span is not None or found.file is not None
            else found._replace(span=generation.span)
            for found in diagnostics
        ),
    )
