"""From what a program asked to generate to the texts of files."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.model.workspace import Generation
from plastron_tui.output.layers import are_untouched
from plastron_tui.output.manifest import Base, Manifest, Reading
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.remembered import recall, remember

from .adaptation import Adaptation, Library
from .changes import changes_of
from .derivation import Derivation
from .file_names import is_same_path, refuse_name
from .handwork import (
    cover,
    kept_handwork,
    layers_at,
    of_other_program,
    on_disk,
    unmergeable,
)
from .place import Writing

if TYPE_CHECKING:
    from plastron_tui.sources.base import Language
    from plastron_tui.targets.base import Target

    from .merging import Merged

Notes = tuple[Diagnostic, ...]

# What a target puts behind a node's name tells what the node does, and changes with it.
_PARTS = ("_pub", "_sub1", "_sub2", "_client", "_server", "_node")


@dataclass(frozen=True, slots=True)
class Generated:
    """The file of one `generate_node`, or why there is none."""

    generation: Generation
    file: OutputFile | None
    diagnostics: tuple[Diagnostic, ...] = ()


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


def last_of_each(made: Sequence[Generated], output: Path) -> list[Generated]:
    """Leave out the files that the program loads after it generated them, and generates again.

    Of two that are one file the last is kept; or the first, which knows of handwork in what it
    created, where the last neither changes nor changed anything.
    """
    made = [each for at, each in enumerate(made) if not _is_copy(each, made[:at], output)]
    loaded = [
        (at, source, _is_chained(each))
        for at, each in enumerate(made)
        if (source := each.generation.node.source) is not None
    ]
    kept = []
    for index, each in enumerate(made):
        is_created = each.generation.node.source is None
        path = each.file and (each.file.path or output / each.file.name)
        if path is None or not any(
            source.path == path and (is_created or (at > index and is_chained))
            for at, source, is_chained in loaded
        ):
            kept.append(each)
    return kept


def _is_copy(made: Generated, before: Sequence[Generated], output: Path) -> bool:
    """Tell whether a node is what the program itself creates, loaded and left as it was."""
    node, file = made.generation.node, made.file
    if node.source is None or file is None or file.path is not None or file.layers is not None:
        return False
    if node.source.library != made.generation.library or changes_of(node):
        return False
    return any(
        other.generation.node.source is None
        and other.file is not None
        and other.file.name == file.name
        and output / file.name == node.source.path
        for other in before
    )


def _is_chained(made: Generated) -> bool:
    """Tell whether a node was loaded from what the program itself generates from another file."""
    source = made.generation.node.source
    return source is not None and source.origin is not None and source.origin.start is not None


def generate(
    generation: Generation, library: Library, writing: Writing, *, own: Library | None = None
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
    """
    node = generation.node
    if node.source is None:
        manifest = writing.manifests(writing.output)
        made = _Creation(generation, library, writing, manifest).result()
    else:
        derived = Derivation(Adaptation(node, node.source, library, own), writing).result()
        made = Generated(generation, derived.file, derived.diagnostics)
    problem = _wrong_name(made, writing, library.target.language)
    if made.file is None or problem is not None:
        return _refused(generation, made.diagnostics if problem is None else (problem,))
    return made


def _wrong_name(made: Generated, writing: Writing, language: Language) -> Diagnostic | None:
    """Say why a file cannot have its name, None where it can, or where there is none."""
    node, file = made.generation.node, made.file
    if file is None:
        return None
    path, source = file.path or writing.output / file.name, node.source
    return refuse_name(
        file.name,
        node.packages,
        language,
        is_own=source is None,
        is_in_place=source is not None and is_same_path(path, source.path),
    )


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
        rendered = target.render(node, catalog)
        if rendered.text is None:
            return _refused(self.generation, rendered.diagnostics)
        name = target.file_name(node)
        base = remember(node, target.name, program)
        file = OutputFile(
            name,
            rendered.text,
            target.language.is_executable,
            base=base,
            seen=((output, manifest),),
        )
        owner = _other_program(name, program, manifest)
        there = on_disk(output / name) if owner is not None else None
        if owner is not None and there not in (None, rendered.text):
            # Forced too it is a conflict, so that a backup is kept.
            file = replace(file, problem=of_other_program(output / name, owner))
            return Generated(self.generation, file, rendered.diagnostics)
        others = _other_files(name, base, target, output, manifest)
        notes = (*rendered.diagnostics, *(_left_behind(output / other, name) for other in others))
        earlier = _earlier(name, others, output, manifest)
        if earlier is None:
            return self._written(file, notes)
        return self._moved(replace(file, supersedes=earlier), earlier, notes)

    def _written(self, file: OutputFile, notes: Notes) -> Generated:
        """Write a node where it was before, or where nothing is."""
        path = self.writing.output / file.name
        present = on_disk(path)
        layers = layers_at(path, self.manifest, present)
        # What programs that loaded the file made of it lies over what is to be renewed.
        before = layers[0].original if layers else present
        is_foreign = before != file.text and file.name not in self.manifest
        if layers and layers[0].origin is None and is_foreign:
            # Programs that loaded somebody's file do not make it one of Plastron's.
            return Generated(self.generation, replace(file, layers=()), notes)
        is_clean = self.manifest.has(file.name, before or b"")
        is_own = before in (None, file.text) or is_clean or any(x.is_clean for x in layers[:1])
        if not (self.writing.force or is_own or before is None or file.name not in self.manifest):
            merged = self._merged(path, before)
            if merged.text is None:
                problem = unmergeable(path, merged.reason)
                return Generated(self.generation, replace(file, problem=problem), notes)
            file = replace(file, text=merged.text, merged_from=before, has_handwork=True)
            notes = (*notes, kept_handwork(path, file.name), *merged.notes)
        if layers and before is not None and present is not None:
            covered = cover(path, layers, before, file.text, present, force=self.writing.force)
            is_renewed = self.writing.force and not (is_own and are_untouched(layers, present))
            file = replace(
                file,
                text=covered.text,
                merged_from=None if is_renewed else present,
                layers=covered.layers,
                problem=covered.problem,
            )
            notes = (*notes, *covered.notes)
        return Generated(self.generation, file, notes)

    def _moved(self, file: OutputFile, earlier: str, notes: Notes) -> Generated:
        """Write a node under another name than before; handwork goes along."""
        path, origin = self.writing.output / file.name, self.writing.output / earlier
        present = on_disk(origin)
        if not self.writing.force and not _may_replace(path, self.manifest):
            file = replace(file, problem=_stale(path, earlier))
            return Generated(self.generation, file, notes)
        is_own = present in (None, file.text) or self.manifest.has(earlier, present or b"")
        if self.writing.force or is_own or present is None:
            return Generated(self.generation, file, notes)
        merged = self._merged(origin, present)
        if merged.text is None:
            problem = unmergeable(origin, merged.reason)
            return Generated(self.generation, replace(file, problem=problem), notes)
        file = replace(file, text=merged.text, has_handwork=True)
        notes = (*notes, kept_handwork(origin, file.name), *merged.notes)
        return Generated(self.generation, file, notes)

    def _merged(self, path: Path, present: bytes) -> Merged:
        """Merge what the program changed in a node into a file that was changed by hand."""
        from plastron_tui.targets import read_source

        from .merging import Merged, merge

        seen = read_source(path, present).source
        target, catalog = self.library
        if seen is not None and seen.library != target.name:
            return Merged(None, f"it is a node of `{seen.library}`")
        read = target.read(path, present)
        if read.source is None or not read.source.nodes:
            return Merged(None, "it holds no node that can be read")
        known = self.manifest.bases.get(path.name)
        base = None if known is None else recall(known)
        return merge(read.source, base, self.generation.node, target, catalog)


def _other_program(name: str, program: str, manifest: Manifest) -> str | None:
    """Return the other program that a file was made by, None where nothing tells of one."""
    layers = manifest.layers.get(name, ())
    known = manifest.bases.get(name, {}).get("program")
    if layers and layers[0].origin is not None:
        known = layers[0].program
    is_other = isinstance(known, str) and known and program and known != program
    return known if is_other else None


def _other_files(
    name: str, base: Base, target: Target, output: Path, manifest: Manifest
) -> list[str]:
    """Return the files of other names that a program made of the same node before."""
    names = (f"{base['node']}{part}{target.language.suffix}" for part in _PARTS)
    same = ("node", "library", "program")
    return [
        other
        for other in names
        if other != name
        and (known := manifest.bases.get(other)) is not None
        and all(known.get(key) == base[key] for key in same)
        and (output / other).is_file()
    ]


def _earlier(name: str, others: list[str], output: Path, manifest: Manifest) -> str | None:
    """Return the file that held a node until its file's name became another."""
    is_current = name in manifest and manifest.successor(name) is None
    if not others or (is_current and (output / name).is_file()):
        return None
    return next((other for other in others if manifest.successor(other) is None), None)


def _may_replace(path: Path, manifest: Manifest) -> bool:
    """Tell whether a file of an earlier generate holds nothing but what Plastron wrote."""
    present = on_disk(path)
    return present is None or path.name not in manifest or manifest.has(path.name, present)


def _left_behind(path: Path, name: str) -> Diagnostic:
    return Diagnostic(
        "left-behind",
        f"the node of `{path.name}` is in `{name}` now, but can still be started from the old file",
        file=path,
        help=f"compare it with `{name}`, and remove it",
        severity=Severity.WARNING,
    )


def _stale(path: Path, current: str) -> Diagnostic:
    return Diagnostic(
        "file-conflict",
        f"`{path.name}` was changed by hand, and later the node went on in `{current}`",
        file=path,
        help=f"remove `{path.name}`, and what `{current}` holds goes there; or use "
        "`generate --force` to overwrite it and keep a backup",
    )


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
