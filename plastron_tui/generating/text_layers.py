"""Files of one text that a program changes in place: what it started from, what it made of that.

As with nodes, a layer for each program keeps both (`output/patch_stack.py`): a program that runs
again starts from what it started from before, with what was changed by hand since. Launch files
and robots are such files; a `Form` tells what there is in the texts of a kind.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple, Protocol

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import FileSet, TextOrigin
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.merge3 import Merge, MergedText, merge_lines, replay, split_lines
from plastron_tui.output.patch_stack import Author, Layer, Layers, digest_of, live_layers
from plastron_tui.output.plan import OutputFile
from plastron_tui.targets.packages.spec import PackageFile

from .destination import Writing
from .file_names import is_same_path
from .text_files import SAME_LINES, Folder, text_files
from .user_edits import cover, kept_handwork, unmergeable

Manifests = Callable[[Path], Manifest]
"""Gives what is remembered of the files of a folder."""


class Form(NamedTuple):
    """What there is in the texts of a kind of file.

    Attributes:
        parts: returns all that a text says, part by part; None for one that cannot be read.
        names: returns by what a program's work is known again in a text, which need not be
            readable.
        merge: merges where lines do not fit; None for texts that are merged by lines alone.
    """

    parts: Callable[[bytes], Iterable[Hashable] | None]
    names: Callable[[bytes], set[Hashable]]
    merge: Merge | None = None


class LoadedText(Protocol):
    """A file that a program has loaded."""

    @property
    def path(self) -> Path:
        """Where it is."""

    @property
    def text(self) -> bytes:
        """What the program starts from."""

    @property
    def present(self) -> bytes:
        """What it holds."""

    @property
    def origin(self) -> TextOrigin | None:
        """Where what the program starts from comes from, if it is not simply what it holds."""


class Start(NamedTuple):
    """What a program starts from: the text, and where it comes from."""

    text: bytes
    origin: TextOrigin


class Version(NamedTuple):
    """What a program makes of a file, of one text that it starts from.

    Attributes:
        start: what it starts from.
        made: what it makes of that.
    """

    start: bytes
    made: bytes


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a file is, and what is remembered of the programs that changed it."""

    real: Path
    manifest: Manifest
    layers: Layers
    index: int | None

    def before(self, present: bytes) -> bytes:
        """Return the file as it is below what later programs made of it."""
        assert self.index is not None
        above = self.layers[self.index + 1 : self.index + 2]
        return above[0].original.main if above else present

    def files(self, text: bytes) -> FileSet:
        """Return a text as layers keep it."""
        return FileSet.single(self.real.suffix, text)


def find_start(
    path: Path, present: bytes, author: Author, manifests: Manifests, form: Form
) -> Start | None:
    """Return what a program started from when it changed a file, None where it did not.

    Args:
        path: the file.
        present: what it holds.
        author: the program.
        manifests: gives what is remembered of the files of a folder.
        form: what there is in such files.
    """
    place = _find_place(path, present, author, manifests, form)
    if place.index is None:
        return None
    layer, before = place.layers[place.index], place.before(present)
    original = layer.original.main
    text = replay(layer.written.main, before, original)
    is_whole = _is_whole(text, layer, before, form)
    return Start(text if is_whole else original, TextOrigin(original, present, is_whole))


def _is_whole(text: bytes, layer: Layer, before: bytes, form: Form) -> bool:
    """Tell whether a text is what a program started from with all that was done by hand since."""
    written = layer.written.main
    lines = (Counter(split_lines(each)) for each in (before, written, text))
    now, then, there = lines
    parts = form.parts(text)
    if any(there[line] < 1 for line in now - then) or parts is None:
        return False
    texts = (layer.original.main, written, before)
    first, made, found = (Counter(form.parts(each) or ()) for each in texts)
    return Counter(parts) == first + (found - made) - (made - found)


def changed_file(
    source: LoadedText,
    named: tuple[str, PackageFile],
    remade: Callable[[bytes], bytes | None],
    folder: Folder,
    writing: Writing,
    form: Form,
) -> tuple[OutputFile, tuple[Diagnostic, ...]]:
    """Return a file that is loaded as it is to be written, and what is to be said of it.

    Args:
        source: the file.
        named: what it is called in the output folder, and what it shall hold.
        remade: returns what the program makes of another text, None where it cannot.
        folder: the output folder.
        writing: whether it is written over the file that it came from, and what is known of that.
        form: what there is in such files.
    """
    name, file = named
    if not writing.in_place and not is_same_path(folder.output / name, source.path):
        merges = {} if form.merge is None else {name: form.merge}
        (output,), notes = text_files({name: file}, folder, merges=merges)
        return output, tuple(notes)
    version = Version(source.text, file.text)
    original = None if source.origin is None else source.origin.original
    made = None if original is None else remade(original)
    pure = version if original is None or made is None else Version(original, made)
    return in_place(source, version, pure, writing, form)


def in_place(
    source: LoadedText,
    version: Version,
    pure: Version,
    writing: Writing,
    form: Form,
) -> tuple[OutputFile, tuple[Diagnostic, ...]]:
    """Return a file that is written over itself, and what is to be said of that.

    Args:
        source: the file.
        version: what the program makes of it, of what was changed by hand too.
        pure: the same without what was changed by hand; where the program needs that, with it.
        writing: the program, what is remembered of the files of a folder, and whether what was
            changed by hand is written over.
        form: what there is in such files.
    """
    present, author, force = source.present, writing.author, writing.force
    place = _find_place(source.path, present, author, writing.manifests, form)
    start, made = place.files(pure.start), place.files(pure.made)
    layer = Layer(author.name, start, made, text=author.text, left=digest_of(made))
    output = OutputFile(
        source.path.name,
        version.made,
        is_executable=False,
        merged_from=present,
        path=source.path,
        # Another program may have made the file, and merges what comes from this one by lines.
        has_handwork=True,
        seen=((place.real.parent, place.manifest),),
    )
    own: Layers = (layer,) if author.name and start != made else ()
    if place.index is None:
        return _with(output, version.made, (*place.layers, *own), place), ()
    lower, upper = place.layers[: place.index], place.layers[place.index + 1 :]
    known, before = place.layers[place.index].written.main, place.before(present)
    notes: tuple[Diagnostic, ...] = ()
    made_of = MergedText(pure.made)
    if before != known and not force:
        notes = (kept_handwork(source.path, source.path.name),)
        made_of = _merged(source, (known, before), version, pure, form)
    text = made_of.text
    if text is None:
        problem = unmergeable(source.path, made_of.reason)
        return _with(output, pure.made, place.layers, place, problem), ()
    sets = (place.files(each) for each in (before, text, present))
    covered = cover(source.path, upper, *sets, force=force)
    own = tuple(replace(each, left=digest_of(covered.files)) for each in own)
    layers = (*lower, *own, *covered.layers)
    done = _with(output, covered.files.main, layers, place, covered.problem)
    return done, (*notes, *covered.notes)


def _with(
    output: OutputFile,
    text: bytes,
    layers: Layers,
    place: _Place,
    problem: Diagnostic | None = None,
) -> OutputFile:
    is_news = layers != place.manifest.layers.get(place.real.name, ())
    return replace(output, text=text, layers=layers if is_news else None, problem=problem)


def _merged(
    source: LoadedText, texts: tuple[bytes, bytes], version: Version, pure: Version, form: Form
) -> MergedText:
    """Bring what was changed by hand into what the program makes.

    Args:
        source: the file.
        texts: what the program made of it before, and what came of that by hand.
        version: what it makes of it now, of what was changed by hand too.
        pure: the same without that.
        form: what there is in such files.
    """
    known, before = texts
    merged = merge_lines(known, pure.made, before)
    if merged is not None and form.parts(merged) is not None:
        return MergedText(merged)
    found = None if form.merge is None else form.merge(source.path, known, pure.made, before)
    if found is not None and found.text is not None:
        return found
    if source.origin is None or source.origin.is_whole:
        return MergedText(version.made)
    return found or MergedText(None, SAME_LINES)


def _find_place(
    path: Path, present: bytes, author: Author, manifests: Manifests, form: Form
) -> _Place:
    real = Path(os.path.realpath(path))
    manifest = manifests(real.parent)

    def shows(layer: Layer, files: FileSet) -> bool:
        """Tell whether a file has or lacks anything as a program left it, not as it found it."""
        texts = (layer.original.main, layer.written.main, files.main)
        before, after, now = (form.names(each) for each in texts)
        return any((each in now) == (each in after) for each in before ^ after)

    known = manifest.layers.get(real.name, ())
    layers = live_layers(known, FileSet.single(real.suffix, present), shows)
    return _Place(real, manifest, layers, author.place(layers))
