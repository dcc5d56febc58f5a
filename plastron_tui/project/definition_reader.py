"""Reading the definition files that a program loads to change them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.context import FoundDefinition, LoadedDefinition
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.catalog.folders import package_of
from plastron_tui.ros.definition import MAX_DEFINITION_BYTES
from plastron_tui.ros.interfaces import InterfaceKind

from .missing_files import missing

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary

_KINDS = {f".{kind.value}": kind for kind in InterfaceKind}


class DefinitionReader:
    """Reads definitions by their paths from the program's folder, within the project."""

    def __init__(self, folder: Path, boundary: Boundary) -> None:
        """Set where files are looked for, and how far the project reaches."""
        self._folder = folder
        self._boundary = boundary

    def __call__(self, source: str) -> LoadedDefinition:
        """Read the file that a `load_type` asks for."""
        if "\0" in source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        path = self._folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        kind = _KINDS.get(path.suffix)
        if kind is None:
            endings = ", ".join(f"`{suffix}`" for suffix in _KINDS)
            return _failed(
                codes.FILE_NOT_FOUND, f"`{source}` is no definition: it ends in none of {endings}"
            )
        if not self._boundary.allows(path):
            message = f"`{source}` is {self._boundary.place_of(path)}"
            return _failed(codes.OUTSIDE_PROJECT, message, self._boundary.remedy)
        if not os.path.isfile(path):  # noqa: PTH113 - a path that is too long is not there
            remedy = missing(source, path, lambda each: each.suffix in _KINDS).remedy
            return _failed(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program", remedy)
        try:
            text = read_regular(path, MAX_DEFINITION_BYTES)
        except OSError as error:
            return _failed(codes.UNREADABLE_FILE, f"`{source}` cannot be read: {reason(error)}")
        return LoadedDefinition(FoundDefinition(path, text, package_of(path), kind))


def _failed(code: Code, message: str, remedy: str | None = None) -> LoadedDefinition:
    return LoadedDefinition(None, (Diagnostic(code, message, help=remedy),))
