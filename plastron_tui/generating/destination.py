"""Where a file is written, and what is known of what is there."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from plastron_tui.model.source import FileSet
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.patch_stack import Author, Layers, are_untouched

from .file_names import FileNames
from .user_edits import files_on_disk, layers_at


class Writing(NamedTuple):
    """Where a program's files are written, and what may be written over.

    Attributes:
        output: the output folder.
        manifests: gives what is remembered of the files of a folder.
        author: the program: nodes of one name in two programs are two. Of one that has no file
            nothing is remembered.
        names: how the files of created nodes are called.
        in_place: whether a loaded node is written over the file that it came from.
        force: whether files are written anew, whatever was changed by hand.
    """

    output: Path
    manifests: Callable[[Path], Manifest]
    author: Author
    names: FileNames
    in_place: bool = False
    force: bool = False


@dataclass(frozen=True, slots=True)
class Place:
    """Where a file is written, and what is known of what is there.

    Attributes:
        shown: the path, for people.
        real: the path with symbolic links resolved.
        present: what the file and those that belong to it hold, None where there is none.
        manifest: what is remembered of the files of its folder.
        layers: what is remembered of programs that changed the file.
        index: the program's own place among them, None where it has none.
    """

    shown: Path
    real: Path
    present: FileSet | None
    manifest: Manifest
    layers: Layers
    index: int | None

    @property
    def has_handwork(self) -> bool:
        """Whether the file was changed by hand since the program at hand wrote it."""
        return not are_untouched(self.layers[self.index or 0 :], self.present)

    def owner(self, output: Manifest, name: str) -> str | None:
        """Return the program that the file was written by last, None where nothing tells.

        Args:
            output: what is remembered of the output folder, which the file may be further down in.
            name: what the file is called there.
        """
        if self.layers:
            return self.layers[-1].program
        base = self.manifest.bases.get(self.real.name) or output.bases.get(name, {})
        known = base.get("program")
        return known if isinstance(known, str) and known else None


def find_place(shown: Path, author: Author, manifests: Callable[[Path], Manifest]) -> Place:
    """Look at the place where a file is, or shall be, and at what a program did there."""
    try:
        real = Path(os.path.realpath(shown))
    except (OSError, ValueError):
        real = shown
    manifest = manifests(real.parent)
    present = files_on_disk(real)
    layers = layers_at(real, manifest, present)
    return Place(shown, real, present, manifest, layers, author.place(layers))


def found_by(place: Place, index: int) -> FileSet:
    """Return a program's output as it is before later programs' changes: handwork and all."""
    above = place.layers[index + 1 : index + 2]
    assert place.present is not None, "what is remembered of files shows in them"
    return above[0].original if above else place.present
