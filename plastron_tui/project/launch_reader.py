"""Reading the launch files that a program loads to change them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.launches import LaunchSource, LoadedLaunch
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.output.own_files import MANIFEST
from plastron_tui.regular_files import read_regular, reason

from .missing_files import missing

if TYPE_CHECKING:
    from collections.abc import Callable

    from plastron_tui.boundary import Boundary
    from plastron_tui.generating.text_layers import Start
    from plastron_tui.output.manifest import Reading

_ENDINGS = (".launch", ".xml")
_ONLY_READ = {".py": "Python", ".yaml": "YAML", ".yml": "YAML"}


class LaunchReader:
    """Reads launch files by their paths from the program's folder, within the project.

    A file that the program itself changed on an earlier run stands for what the program started
    from then, with what was changed by hand since.
    """

    def __init__(
        self,
        folder: Path,
        boundary: Boundary,
        program: str,
        text: bytes,
        manifest: Callable[[Path], Reading],
    ) -> None:
        """Set where files are looked for.

        Args:
            folder: the program's folder.
            boundary: how far the project reaches.
            program: the name of the program's file, "" where it has none.
            text: the program.
            manifest: reads a folder's manifest.
        """
        self._folder = folder
        self._boundary = boundary
        self._program = program
        self._text = text
        self._manifest = manifest

    def __call__(self, source: str) -> LoadedLaunch:
        """Read the file that a `load_launch` asks for."""
        if "\0" in source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        path = self._folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        if not self._boundary.allows(path):
            message = f"`{source}` is {self._boundary.place_of(path)}"
            return _failed(codes.OUTSIDE_PROJECT, message, self._boundary.remedy)
        if not os.path.isfile(path):  # noqa: PTH113 - a path that is too long is not there
            remedy = missing(source, path, lambda each: each.suffix in _ENDINGS).remedy
            return _failed(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program", remedy)
        if path.suffix in _ONLY_READ:
            message = f"a launch file in {_ONLY_READ[path.suffix]} is only read, and not changed"
            remedy = f"`plastron graph {source}` shows it; only one in XML is changed"
            return _failed(codes.EDIT_REFUSED, message, remedy)
        try:
            text = read_regular(path, LARGEST_FILE)
        except OSError as error:
            return _failed(codes.UNREADABLE_FILE, f"`{source}` cannot be read: {reason(error)}")
        from plastron_tui.sources.launch.xml_reader import read_launch_xml

        start = self._started(path, text)
        origin = None if start is None else start.origin
        text = text if start is None else start.text
        read = read_launch_xml(text, path)
        if read.launch is None:
            return LoadedLaunch(None, read.diagnostics)
        found = LaunchSource(path, text, read.format, read.launch, origin)
        return LoadedLaunch(found, read.diagnostics)

    def _started(self, path: Path, present: bytes) -> Start | None:
        """Return what the program started from when it changed a file, None where it did not."""
        folder = Path(os.path.realpath(path)).parent
        if not self._program or not (folder / MANIFEST).is_file():
            return None
        from plastron_tui.generating.launch_layers import LAUNCH_FORM
        from plastron_tui.generating.text_layers import find_start
        from plastron_tui.output.manifest import digest
        from plastron_tui.output.patch_stack import Author

        author = Author(self._program, digest(self._text), self._folder)
        manifests = lambda folder: self._manifest(folder)[0]  # noqa: E731
        return find_start(path, present, author, manifests, LAUNCH_FORM)


def _failed(code: Code, message: str, remedy: str | None = None) -> LoadedLaunch:
    return LoadedLaunch(None, (Diagnostic(code, message, help=remedy),))
