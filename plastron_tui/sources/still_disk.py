"""What the disk has, asked once for the many files that are read one after the other.

Each file of a package asks which headers lie around it, and what these hold. For who reads a whole
workspace the disk counts as still until all is read.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager, suppress
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from plastron_tui.regular_files import Observer, observed, observer, read_regular

_MOST_BYTES = 2 * 1024 * 1024
_MOST_ANSWERS = 20_000

_Given = ParamSpec("_Given")
_Result = TypeVar("_Result")
_Read = tuple["os.stat_result | None", "bytes | None"]


class _Known(threading.local):
    """What is known of the disk while it counts as still."""

    depth = 0

    def __init__(self) -> None:
        """Begin with nothing, in a thread that asks for the first time."""
        self.files: dict[str, frozenset[str]] = {}
        self.answers: dict[Hashable, Any] = {}
        self.texts: dict[str, tuple[os.stat_result, bytes]] = {}
        self.size = 0

    def clear(self) -> None:
        """Forget all."""
        self.files.clear()
        self.answers.clear()
        self.forget_texts()

    def forget_texts(self) -> None:
        """Forget what files hold."""
        self.texts.clear()
        self.size = 0


_KNOWN = _Known()


@contextmanager
def still_disk() -> Iterator[None]:
    """Let the disk count as still meanwhile, in this thread."""
    _KNOWN.depth += 1
    try:
        yield
    finally:
        _KNOWN.depth -= 1
        if not _KNOWN.depth:
            _KNOWN.clear()


def asked_once(ask: Callable[_Given, _Result]) -> Callable[_Given, _Result]:
    """Let a function of the disk remember its answers while that counts as still.

    Its arguments are hashable, and nobody changes what it returns.
    """

    @wraps(ask)
    def answer(*given: _Given.args, **named: _Given.kwargs) -> _Result:
        if not _KNOWN.depth or named:
            return ask(*given, **named)
        key = ask, given
        if key not in _KNOWN.answers:
            if len(_KNOWN.answers) >= _MOST_ANSWERS:
                _KNOWN.answers.clear()
            _KNOWN.answers[key] = ask(*given, **named)
        found: _Result = _KNOWN.answers[key]
        return found

    return answer


def is_file(path: str) -> bool:
    """Tell whether a path is that of a file, through links."""
    if not _KNOWN.depth:
        return os.path.isfile(path)  # noqa: PTH113
    folder, _, name = path.rpartition(os.sep)
    files = _KNOWN.files.get(folder)
    if files is None:
        files = _KNOWN.files[folder] = _files_in(folder or os.sep)
    return name in files


def _files_in(folder: str) -> frozenset[str]:
    with suppress(OSError, ValueError), os.scandir(folder) as entries:
        return frozenset(entry.name for entry in entries if entry.is_file())
    return frozenset()


def read_once(path: Path | str, limit: int) -> bytes:
    """Return what a regular file holds, see `read_regular`; who notes what is read notes it."""
    if not _KNOWN.depth:
        return read_regular(path, limit)
    name = os.fspath(path)
    known = _KNOWN.texts.get(name)
    if known is not None and len(known[1]) <= limit:
        tell = observer()
        if tell is not None:
            tell(name, *known)
        return known[1]
    return _read_first(name, limit, observer())


def _read_first(name: str, limit: int, tell: Observer | None) -> bytes:
    found: list[_Read] = []

    def note(path: str, status: os.stat_result | None, text: bytes | None) -> None:
        found.append((status, text))
        if tell is not None:
            tell(path, status, text)

    with observed(note):
        text = read_regular(name, limit)
    status = found[-1][0]
    if status is not None and len(text) <= _MOST_BYTES:
        if _KNOWN.size + len(text) > _MOST_BYTES:
            _KNOWN.forget_texts()
        _KNOWN.texts[name] = status, text
        _KNOWN.size += len(text)
    return text
