"""Finding and reading the files that a program loads."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.model.setting import Loaded, LoadRequest
from plastron_tui.model.workspace import Generation

LARGEST_FILE = 4 * 1024 * 1024
"""The largest node file that is read, in bytes; a node is a few kilobytes."""

_SUFFIXES = (".py", ".cpp")


class NodeLoader:
    """Reads node files for the interpreter, each only once.

    A bare name is looked for in what the program generates, in the output folder, in the
    program's folder and in the working folder; a path is relative to the program's folder.
    """

    def __init__(
        self,
        folder: Path,
        output: Path,
        rendered: Callable[[Generation], tuple[Path, bytes] | None],
    ) -> None:
        self._folder = folder
        self._output = output
        self._rendered = rendered
        self._read: dict[tuple[Path, int], Loaded] = {}

    def __call__(self, request: LoadRequest) -> Loaded:
        """Read the file that a `load` asks for."""
        if "\0" in request.source:
            return _failed("file-not-found", "a path holds no NUL character")
        if not request.is_path:
            for path, text in self._generated(request):
                return read_node(path, text)
        for path in self._candidates(request):
            # The functions of `os.path` take a path that is too long for one that is not there.
            if os.path.isdir(path):  # noqa: PTH112
                return _failed("unreadable-file", f"`{path.name}` is a folder")
            if os.path.isfile(path):  # noqa: PTH113
                return self._read_once(path)
        return self._not_found(request)

    def _generated(self, request: LoadRequest) -> Iterator[tuple[Path, bytes]]:
        names = {request.source + suffix for suffix in _SUFFIXES}
        for generation in reversed(request.generated):
            # Rendering costs more than asking for the name: a node's name starts its file's.
            if request.source.startswith(generation.node.name):
                rendered = self._rendered(generation)
                if rendered is not None and rendered[0].name in names:
                    yield rendered

    def _candidates(self, request: LoadRequest) -> Iterator[Path]:
        if request.is_path:
            yield self._folder / os.path.expanduser(request.source)  # noqa: PTH111
            return
        for folder in dict.fromkeys((self._output, self._folder, Path.cwd())):
            for suffix in _SUFFIXES:
                yield folder / f"{request.source}{suffix}"

    def _read_once(self, path: Path) -> Loaded:
        try:
            status = path.stat()
            key = (path, status.st_mtime_ns)
            if key not in self._read:
                if status.st_size > LARGEST_FILE:
                    limit = LARGEST_FILE // (1024 * 1024)
                    message = f"`{path.name}` is larger than {limit} MB, which no node is"
                    return _failed("unreadable-file", message)
                self._read[key] = read_node(path, path.read_bytes())
            return self._read[key]
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            return _failed("unreadable-file", f"`{path.name}` cannot be read: {reason}")

    def _not_found(self, request: LoadRequest) -> Loaded:
        if request.is_path:
            path = self._folder / request.source
            name = nearest(path.name, _names(path.parent, full=True))
            folder = request.source[: len(request.source) - len(path.name)]
            return _not_there(
                f"no file `{request.source}` beside the program",
                name,
                None if name is None or "'" in name else f"'{folder}{name}'",
            )
        known = {name for folder in (self._output, self._folder) for name in _names(folder)}
        name = nearest(request.source, sorted(known))
        return _not_there(
            f"no file `{request.source}.py` or `{request.source}.cpp` in the output folder, the "
            "program's folder or the working folder",
            name,
            name if name is not None and name.isidentifier() and name.isascii() else None,
        )


def read_node(path: Path, text: bytes) -> Loaded:
    """Read the text of a node file."""
    from plastron_tui.targets import read_source

    result = read_source(path, text)
    return Loaded(result.source, result.diagnostics)


def _names(folder: Path, *, full: bool = False) -> list[str]:
    try:
        files = [file for file in folder.iterdir() if file.suffix in _SUFFIXES]
    except OSError:
        return []
    return sorted(file.name if full else file.stem for file in files)


def _failed(code: str, message: str, remedy: str | None = None) -> Loaded:
    return Loaded(None, (Diagnostic(code, message, help=remedy),))


def _not_there(message: str, name: str | None, right: str | None) -> Loaded:
    """Say that no file has a name, and which one may be meant: its name, and how it is written."""
    remedy = None if name is None else f"did you mean `{name}`?"
    return Loaded(None, (Diagnostic("file-not-found", message, help=remedy),), right)
