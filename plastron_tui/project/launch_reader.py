"""Reading the launch files that a program loads to change them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.model.launches import LaunchSource, LoadedLaunch
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import read_regular, reason

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary

_ENDINGS = (".launch", ".xml")
_ONLY_READ = {".py": "Python", ".yaml": "YAML", ".yml": "YAML"}


class LaunchReader:
    """Reads launch files by their paths from the program's folder, within the project."""

    def __init__(self, folder: Path, boundary: Boundary) -> None:
        """Set where files are looked for, and how far the project reaches."""
        self._folder = folder
        self._boundary = boundary

    def __call__(self, source: str) -> LoadedLaunch:
        """Read the file that a `load_launch` asks for."""
        if "\0" in source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        path = self._folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        if not self._boundary.allows(path):
            message = f"`{source}` is {self._boundary.place_of(path)}"
            return _failed(codes.OUTSIDE_PROJECT, message, self._boundary.remedy)
        if not os.path.isfile(path):  # noqa: PTH113 - a path that is too long is not there
            return self._not_there(source, path)
        if path.suffix in _ONLY_READ:
            message = f"a launch file in {_ONLY_READ[path.suffix]} is only read, and not changed"
            remedy = f"`plastron graph {source}` shows it; only one in XML is changed"
            return _failed(codes.EDIT_REFUSED, message, remedy)
        try:
            text = read_regular(path, LARGEST_FILE)
        except OSError as error:
            return _failed(codes.UNREADABLE_FILE, f"`{source}` cannot be read: {reason(error)}")
        from plastron_tui.sources.launch.xml_reader import read_launch_xml

        read = read_launch_xml(text, path)
        if read.launch is None:
            return LoadedLaunch(None, read.diagnostics)
        return LoadedLaunch(LaunchSource(path, text, read.format, read.launch), read.diagnostics)

    def _not_there(self, source: str, path: Path) -> LoadedLaunch:
        try:
            names = sorted(each.name for each in path.parent.iterdir() if each.suffix in _ENDINGS)
        except (OSError, ValueError):
            names = []
        name = nearest(path.name, names)
        folder = source[: len(source) - len(path.name)]
        remedy = f"did you mean `{folder}{name}`?" if name else f"it is looked for as `{path}`"
        return _failed(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program", remedy)


def _failed(code: Code, message: str, remedy: str | None = None) -> LoadedLaunch:
    return LoadedLaunch(None, (Diagnostic(code, message, help=remedy),))
