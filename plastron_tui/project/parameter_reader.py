"""Reading the parameter files that launch files name."""

from __future__ import annotations

import os
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.launches import LoadedParameters
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.parameter_values import params_problem

from .missing_files import missing

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary

LARGEST = 256 * 1024
"""In bytes; PyYAML reads some 100 kB a second."""

_ENDINGS = (".yaml", ".yml")


class ParameterReader:
    """Reads parameter files by their paths from the program's folder, within the project."""

    def __init__(self, folder: Path, boundary: Boundary) -> None:
        """Set where files are looked for, and how far the project reaches."""
        self._folder = folder
        self._boundary = boundary

    def __call__(self, source: str, ros_version: int) -> LoadedParameters:
        """Read the file that a `starts` asks for.

        Args:
            source: its path from the program's folder.
            ros_version: the generation of ROS that takes it.
        """
        if "\0" in source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        path = self._folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        if path.suffix not in _ENDINGS:
            message = f"`{source}` is no parameter file: it ends in neither `.yaml` nor `.yml`"
            return _failed(codes.BAD_PARAMETERS, message)
        if not self._boundary.allows(path):
            message = f"`{source}` is {self._boundary.place_of(path)}"
            return _failed(codes.OUTSIDE_PROJECT, message, self._boundary.remedy)
        try:
            text = read_regular(path, LARGEST)
        except FileNotFoundError:
            remedy = missing(source, path, lambda each: each.suffix in _ENDINGS).remedy
            return _failed(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program", remedy)
        except OSError as error:
            return _failed(codes.UNREADABLE_FILE, f"`{source}` cannot be read: {reason(error)}")
        wrong = _problem(text, ros_version)
        if wrong is not None:
            return _failed(codes.BAD_PARAMETERS, f"`{source}` {wrong[0]}", wrong[1])
        return LoadedParameters(Path(os.path.normpath(path)), text)


@lru_cache(maxsize=16)
def _problem(text: bytes, ros_version: int) -> tuple[str, str | None] | None:
    """Return what is wrong with a parameter file, and the remedy; None for nothing."""
    try:
        decoded = text.decode("utf-8")
    except UnicodeDecodeError:
        return "is not UTF-8", None
    wrong = params_problem(decoded, ros_version)
    if wrong is None:
        return None
    line = decoded.count("\n", 0, wrong.start) + 1
    return f"cannot be used, line {line}: {wrong.message}", wrong.help


def _failed(code: Code, message: str, remedy: str | None = None) -> LoadedParameters:
    return LoadedParameters(None, b"", (Diagnostic(code, message, help=remedy),))
