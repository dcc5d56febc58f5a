"""The other sources of a package that define or make what the files of a unit declare.

They are looked into and never changed: they say what a member is made of, and what a constructor
is given. What they create themselves is theirs.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from plastron_tui.sources.still_disk import asked_once, read_once

from .scopes import CppFile, Function
from .structure import outline
from .syntax import parse

MOST_SOURCES = 6
"""The most other sources that one file is read with."""

_MOST_LOOKED_AT = 64
_LARGEST = 256 * 1024
_SUFFIXES = frozenset({".cpp", ".cc", ".cxx"})


def sources_beside(path: Path, files: list[CppFile]) -> tuple[list[CppFile], tuple[Path, ...]]:
    """Return the other sources that belong to the headers of a unit, with their paths."""
    headers = {name for file in files[1:] if (name := _declares(file, files, path.stem))}
    if not headers:
        return [], ()
    found: list[CppFile] = []
    paths: list[Path] = []
    own = {file.name.replace("{}", path.stem).rpartition("/")[2] for file in files}
    with suppress(OSError):
        beside = [each for each in _sources_in(path.parent) if each != path]
        for other in beside[:_MOST_LOOKED_AT]:
            if other.name in own or len(found) >= MOST_SOURCES:
                continue
            with suppress(OSError, ValueError):
                text = read_once(other, _LARGEST)
                if b"\x00" not in text and any(name in text for name in headers):
                    file = outline(other.name, parse(text))
                    file.is_beside = True
                    found.append(file)
                    paths.append(other)
    return found, tuple(paths)


@asked_once
def _sources_in(folder: Path) -> tuple[Path, ...]:
    return tuple(sorted(each for each in folder.iterdir() if each.suffix in _SUFFIXES))


def _declares(file: CppFile, files: list[CppFile], stem: str) -> bytes | None:
    """Return the name of a header that declares methods which none of the files defines."""
    for scope in file.scopes:
        if scope.kind != "class":
            continue
        for name, functions in scope.functions.items():
            is_open = any(each.scope is None and not _is_pure(each) for each in functions)
            if is_open and not _is_defined(name, scope.name, files):
                return _name(file, stem)
            makes = name == scope.name and any(each.parameters for each in functions)
            if makes and not _is_made(scope.name, files):
                return _name(file, stem)
    return None


def _name(file: CppFile, stem: str) -> bytes:
    return file.name.replace("{}", stem).rpartition("/")[2].encode()


def _is_pure(function: Function) -> bool:
    """Whether a method is not to be defined: it has no body, or that of the compiler."""
    code = function.file.syntax.code[function.declarator.end_byte : function.node.end_byte]
    return b"=" in code


def _is_defined(name: str, owner: str, files: list[CppFile]) -> bool:
    return any(
        each.scope is not None and each.qualifier.rpartition("::")[2] == owner
        for file in files
        for scope in file.scopes
        for each in scope.functions.get(name, ())
    )


def _is_made(owner: str, files: list[CppFile]) -> bool:
    """Whether the main file is a program that may make objects of a class."""
    code = files[0].syntax.code
    return b"main(" in code and owner.encode() in code
