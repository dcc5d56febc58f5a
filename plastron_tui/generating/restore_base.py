"""What a program starts from, where it loads what it wrote itself on an earlier run."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from plastron_tui.model.source import FileSet, Origin, SourceUnit
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.merge3 import replay_files
from plastron_tui.output.patch_stack import Author, Layer, digest_of
from plastron_tui.targets import find_target, read_source

from .destination import find_place, found_by
from .language_checks import is_worse
from .user_edits import files_on_disk, shown

_MOST_STEPS = 4
"""How often a file may be made from one that the program made as well."""


class Start(NamedTuple):
    """Files to start from: the path of the main one, and where they come from."""

    path: Path
    files: FileSet
    origin: Origin


def find_start(
    path: Path,
    author: Author,
    manifests: Callable[[Path], Manifest],
    may_read: Callable[[Path], bool],
    steps: int = _MOST_STEPS,
) -> Start | None:
    """Return what a program started from when it wrote a file, None where it did not write it.

    The text has what was changed in the file by hand since, as far as that fits.

    Args:
        path: the file.
        author: the program.
        manifests: gives what is remembered of the files of a folder.
        may_read: tells whether a manifest may lead to a file, whoever wrote it.
        steps: how often the file may be made from one that the program made as well.
    """
    place = find_place(path, author, manifests)
    if place.index is None:
        return None
    layer = place.layers[place.index]
    first, original, is_torn = path, layer.original, False
    above = Path(os.path.normpath(place.real.parent / (layer.origin or "")))
    if layer.origin is not None and steps and _is_near(above, author) and may_read(above):
        start = find_start(above, author, manifests, may_read, steps - 1)
        found = files_on_disk(above) if start is None else start.files
        if found is not None:
            first = above
        if found is not None and digest_of(found) != layer.seen:
            is_torn = digest_of(layer.original) != layer.seen
            original = found
    visible = original
    present = found_by(place, place.index)
    if present != layer.written and not is_torn:
        visible = replay_files(layer.written, present, original)
        if not _is_right(path, visible, original, layer, present):
            visible = original
    return Start(first, visible, Origin(first, original, place.real, is_torn=is_torn))


def _is_near(path: Path, author: Author) -> bool:
    """Tell whether a name may mean a file: a manifest leads to no other, whoever wrote it."""
    folders = (author.folder.absolute(), os.path.realpath(author.folder), Path.cwd())
    return any(path.is_relative_to(folder) for folder in folders)


def chained(source: SourceUnit) -> Origin:
    """Return the origin of what a program generates from a source, and loads again."""
    known = source.origin
    if known is None:
        return Origin(source.path, source.files, start=source.files, turns=1)
    start = source.files if known.start is None else known.start
    return known._replace(start=start, turns=known.turns + 1)


def _is_right(
    path: Path, files: FileSet, original: FileSet, layer: Layer, present: FileSet
) -> bool:
    """Tell whether handwork was brought into an original without what the program wrote."""
    source = read_source(path, original).source
    target = find_target(str(layer.base.get("library")) if source is None else source.library)
    if target is not None and is_worse(target.language, files, original):
        return False
    found, before, written, now = (
        shown(path, each) for each in (files, original, layer.written, present)
    )
    return found == before + (now - written) - (written - now)
