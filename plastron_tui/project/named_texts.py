"""Finding and reading the files of one text that a program names: launch files, robots."""

from __future__ import annotations

import os
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from plastron_tui.boundary import Boundary
from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.output.own_files import MANIFEST
from plastron_tui.regular_files import read_regular, reason

from .missing_files import missing

if TYPE_CHECKING:
    from plastron_tui.generating.text_layers import Form, Start
    from plastron_tui.output.manifest import Reading

_MOST_NAMES = 1000

Manifests: TypeAlias = "Callable[[Path], Reading]"
"""Reads a folder's manifest."""


class NamedTexts:
    """Reads files by their paths from the program's folder, within the project.

    A file that the program itself changed on an earlier run stands for what the program started
    from then, with what was changed by hand since.

    Attributes:
        folder: the program's folder.
        boundary: how far the project reaches.
        text: the program.
    """

    def __init__(
        self, folder: Path, boundary: Boundary, program: str, text: bytes, manifest: Manifests
    ) -> None:
        """Set where files are looked for.

        Args:
            folder: the program's folder.
            boundary: how far the project reaches.
            program: the name of the program's file, "" where it has none.
            text: the program.
            manifest: reads a folder's manifest.
        """
        self.folder = folder
        self.boundary = boundary
        self._program = program
        self.text = text
        self._manifest = manifest

    def find(self, source: str, is_meant: Callable[[Path], bool]) -> Path | Diagnostic:
        """Return where a file is, or why it is not read.

        Args:
            source: its path as the program has it.
            is_meant: whether a neighbour could be what is meant where nothing is there.
        """
        if "\0" in source:
            return Diagnostic(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        path = self.folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        if not self.boundary.allows(path):
            message = f"`{source}` is {self.boundary.place_of(path)}"
            return Diagnostic(codes.OUTSIDE_PROJECT, message, help=self.boundary.remedy)
        # A path that is too long is not there for these.
        if os.path.isdir(path):  # noqa: PTH112
            message = f"`{source}` is a folder"
            remedy = _what_is_in(source, path, is_meant)
            return Diagnostic(codes.UNREADABLE_FILE, message, help=remedy)
        if not os.path.isfile(path):  # noqa: PTH113
            remedy = missing(source, path, is_meant).remedy
            message = f"no file `{source}` beside the program"
            return Diagnostic(codes.FILE_NOT_FOUND, message, help=remedy)
        return path

    def read(self, source: str, path: Path) -> bytes | Diagnostic:
        """Return what a file that was found holds, or why it cannot be read."""
        try:
            return read_regular(path, LARGEST_FILE)
        except OSError as error:
            message = f"`{source}` cannot be read: {reason(error)}"
            return Diagnostic(codes.UNREADABLE_FILE, message)

    def started(self, path: Path, present: bytes, form: Callable[[], Form]) -> Start | None:
        """Return what the program started from when it changed a file, None where it did not.

        Args:
            path: the file.
            present: what it holds.
            form: what there is in such files; it is asked for where the program changed any.
        """
        folder = Path(os.path.realpath(path)).parent
        if not self._program or not (folder / MANIFEST).is_file():
            return None
        from plastron_tui.generating.text_layers import find_start
        from plastron_tui.output.manifest import digest
        from plastron_tui.output.patch_stack import Author

        author = Author(self._program, digest(self.text), self.folder)
        return find_start(path, present, author, lambda folder: self._manifest(folder)[0], form())


def _what_is_in(source: str, folder: Path, is_meant: Callable[[Path], bool]) -> str | None:
    """Say which file of a folder could be meant, None where none could."""
    try:
        names = sorted(
            each.name for each in islice(folder.iterdir(), _MOST_NAMES) if is_meant(each)
        )
    except OSError:
        return None
    return f"name a file in it, such as `{source.rstrip('/')}/{names[0]}`" if names else None
