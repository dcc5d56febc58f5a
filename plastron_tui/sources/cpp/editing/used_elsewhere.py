"""Other sources of a package that use what an edit takes out of a header."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from plastron_tui.model.source import place_of
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.splices import line_number

from ..analysis import Analysis
from ..headers import included_by
from ..macros import blanked
from ..scopes import CppFile

_SUFFIXES = frozenset({".cpp", ".cc", ".cxx"})
_LARGEST = 256 * 1024
_MOST_SOURCES = 200
_MOST_FOLDERS = 400
_MOST_ABOVE = 4
_COMMENT = re.compile(rb"//[^\n]*|/\*.*?\*/", re.DOTALL)


def used_elsewhere(path: Path, before: Analysis, after: Analysis) -> str | None:
    """Return where another source uses a member that a header has no more, None for nowhere.

    Args:
        path: the main file.
        before: the files as they were.
        after: the files as they are to be.
    """
    pairs = zip(before.unit.files, after.unit.files, strict=True)
    lost = {
        place_of(path, old.name).resolve(): gone
        for old, new in pairs
        if old.name and old is not new and (gone := _members(old) - _members(new))
    }
    if not lost:
        return None
    own = {place_of(path, file.name).resolve() for file in before.unit.files if file.name}
    for other in _sources(path):
        if other.resolve() in own or other == path:
            continue
        with suppress(OSError, ValueError):
            text = _COMMENT.sub(blanked, read_regular(other, _LARGEST))
            if not any(each.name.encode() in text for each in lost):
                continue
            for header in dict.fromkeys(each.resolve() for each in included_by(other, text)):
                for owner, name in sorted(lost.get(header, ())):
                    use = _use(text, owner, name)
                    if use is not None:
                        where = f"line {use} of `{other.name}`"
                        return f"`{name}` of `{header.name}` is used in {where}"
    return None


def _members(file: CppFile) -> set[tuple[str, str]]:
    """Return the members that a file declares, each with its class."""
    return {
        (scope.name, name)
        for scope in file.scopes
        if scope.kind == "class"
        for name in (*scope.variables, *scope.functions)
    }


def _use(text: bytes, owner: str, name: str) -> int | None:
    """Return the line in which a source uses a member: one of its class, or of an object."""
    is_own = re.search(rb"\b%s\s*::" % re.escape(owner.encode()), text) is not None
    reach = rb"(?<![\w])" if is_own else rb"(?:\.|->)\s*"
    found = re.search(reach + re.escape(name.encode()) + rb"(?!\w)", text)
    return None if found is None else line_number(text, found.start())


def _sources(path: Path) -> Iterator[Path]:
    """Yield the sources of the package that a file is in, none for a file of no package."""
    above = path.absolute().parents[:_MOST_ABOVE]
    root = next((each for each in above if (each / "package.xml").is_file()), None)
    if root is None:
        return
    found = 0
    for looked_at, (folder, inner, names) in enumerate(os.walk(root)):
        inner[:] = sorted(each for each in inner if not each.startswith("."))
        for name in sorted(names):
            if Path(name).suffix in _SUFFIXES:
                found += 1
                yield Path(folder, name)
        if looked_at >= _MOST_FOLDERS or found >= _MOST_SOURCES:
            return
