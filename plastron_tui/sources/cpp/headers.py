"""Which files of its package a C++ file is read and changed together with.

A node is a source file with the headers of its own package that it includes, also by way of
others: these declare its members, callbacks and constants. A header is read with the source file
of its name.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from plastron_tui.sources.still_disk import asked_once, is_file, read_once

MOST_HEADERS = 24
"""The most headers that one file is read with."""

_MOST_INCLUDES = 200
_MOST_TEXTS = 64
_LARGEST = 256 * 1024
_MOST_BYTES = 1024 * 1024
_MOST_DEEP = 4
_MOST_FOLDERS = 100
_MOST_ABOVE = 5
_SOURCES = (".cpp", ".cc", ".cxx")
_HEADERS = (".hpp", ".h", ".hh", ".hxx")
_INCLUDE = re.compile(
    rb'^(?:\xef\xbb\xbf)?[ \t]*#[ \t]*include[ \t]*(?:<([^<>\n]+)>|"([^"\n]+)")', re.MULTILINE
)

_ADDED = re.compile(rb"include_directories\s*\(([^()#]*)\)", re.IGNORECASE)
_OWN_FOLDER = re.compile(r"(?:\$<BUILD_INTERFACE:)?\$\{(?:CMAKE_CURRENT|PROJECT)_SOURCE_DIR\}/")


def others(path: Path, text: bytes) -> tuple[str, ...]:
    """Return the names of the files that belong to a file, see `FileSet`."""
    folder = os.path.dirname(os.path.abspath(path))  # noqa: PTH100,PTH120 (never raises)
    roots = _roots(folder)
    found: dict[str, None] = {}
    if path.suffix in _HEADERS:
        for name in (*_sources_of(path, folder), *_declaring(path)):
            found[name] = None
    left = [_MOST_BYTES]
    _gather(text, folder, roots, folder, path.stem, found, left, 0)
    # What Plastron writes names its header like this before there is one on the disk.
    for include in _includes(text):
        name = include.rpartition("/")[2]
        stem = name.rpartition(".")[0]
        if stem == path.stem and len(found) < MOST_HEADERS:
            outer = include.rpartition("/")[0]
            beside = "{}" + name[len(stem) :]
            usual = f"../include/{outer}/{beside}" if outer else beside
            if not any(each.endswith(beside) for each in found):
                found[usual] = None
    return tuple(found)


def included_by(path: Path, text: bytes) -> Iterator[Path]:
    """Yield the headers of its package that a source includes itself."""
    folder = os.path.dirname(os.path.abspath(path))  # noqa: PTH100,PTH120 (never raises)
    roots = _roots(folder)
    for include in _includes(text):
        place = _place(include, folder, roots)
        if place is not None:
            yield Path(place)


def _gather(
    text: bytes,
    folder: str,
    roots: tuple[str, ...],
    main: str,
    stem: str,
    found: dict[str, None],
    left: list[int],
    depth: int,
) -> None:
    inner: list[tuple[bytes, str]] = []
    for include in _includes(text):
        if len(found) >= MOST_HEADERS:
            return
        place = _place(include, folder, roots)
        if place is None:
            continue
        name = _relative(place, main, stem)
        if name is None or name in found or name.startswith("{}.c"):
            continue
        with suppress(OSError, ValueError):
            held = read_once(place, _LARGEST)
            if len(held) > left[0]:
                continue
            left[0] -= len(held)
            found[name] = None
            inner.append((held, os.path.dirname(place)))  # noqa: PTH120
    if depth < _MOST_DEEP:
        for held, where in inner:
            _gather(held, where, roots, main, stem, found, left, depth + 1)


@lru_cache(_MOST_TEXTS)
def _includes(text: bytes) -> tuple[str, ...]:
    return tuple(_included(text))


def _included(text: bytes) -> Iterator[str]:
    for at, include in enumerate(_INCLUDE.finditer(text)):
        if at >= _MOST_INCLUDES:
            return
        name = (include[1] or include[2]).decode("utf-8", "replace").strip()
        is_plain = "{" not in name and "\0" not in name and not name.startswith("/")
        # The standard library's headers have neither folder nor suffix.
        if is_plain and (include[2] or "/" in name or "." in name):
            yield name


@asked_once
def _place(include: str, folder: str, roots: tuple[str, ...]) -> str | None:
    """Return the file of the package that an include names, None for one of another package."""
    for root in (folder, *roots):
        place = os.path.normpath(os.path.join(root, include))  # noqa: PTH118
        if is_file(place):
            return place
    return None


def _relative(place: str, main: str, stem: str) -> str | None:
    with suppress(ValueError):
        name = Path(os.path.relpath(place, main)).as_posix()
        outer, slash, last = name.rpartition("/")
        own, dot, suffix = last.rpartition(".")
        if own == stem:
            last = "{}" + dot + suffix
        elif "{" in last:
            return None
        return outer + slash + last
    return None


def _roots(folder: str) -> tuple[str, ...]:
    """Return the folders that the headers of a package are looked for in."""
    roots, package = _near(folder)
    if package is None:
        return roots
    # They are of one target or another: what is near comes first.
    return tuple(dict.fromkeys((*roots, *_added(package))))


@asked_once
def _near(folder: str) -> tuple[tuple[str, ...], str | None]:
    """Return the folders where headers are by habit, and that of the package, None for none."""
    above = [folder]
    for _ in range(_MOST_ABOVE):
        outer = os.path.dirname(above[-1])  # noqa: PTH120
        if outer == above[-1]:
            break
        above.append(outer)
    package = next(
        (at for at, each in enumerate(above) if is_file(os.path.join(each, "package.xml"))),  # noqa: PTH118
        None,
    )
    chain = above[: package + 1] if package is not None else above[:3]
    roots = []
    for each in chain[-1:] if package is not None else ():
        # What the package installs: `include/NAME`.
        with suppress(OSError), os.scandir(os.path.join(each, "include")) as inner:  # noqa: PTH118
            folders = sorted(entry.path for entry in inner if entry.is_dir())
            roots += folders[:_MOST_ABOVE]
    for each in chain:
        roots += [os.path.join(each, "include"), os.path.join(each, "src"), each]  # noqa: PTH118
    return tuple(roots), None if package is None else chain[-1]


def _added(package: str) -> list[str]:
    """Return the folders of a package that its CMakeLists.txt has headers looked for in."""
    # It is asked of for each file: who notes what is read for one has to hear of it.
    with suppress(OSError, ValueError):
        text = read_once(os.path.join(package, "CMakeLists.txt"), _LARGEST)  # noqa: PTH118
        return [os.path.join(package, folder) for folder in _added_by(text)]  # noqa: PTH118
    return []


@lru_cache(_MOST_TEXTS)
def _added_by(text: bytes) -> tuple[str, ...]:
    found: dict[str, None] = {}
    for command in _ADDED.finditer(text):
        for word in command[1].decode("utf-8", "replace").split():
            folder = os.path.normpath(_OWN_FOLDER.sub("", word.strip('"')).rstrip(">"))
            if not folder.startswith(("/", "..", "$")) and "{" not in folder:
                found[folder] = None
    return tuple(found)[:_MOST_FOLDERS]


def _sources_of(path: Path, folder: str) -> Iterator[str]:
    """Yield the source file that defines what a header declares."""
    main = os.path.abspath(path)  # noqa: PTH100 (never raises)
    places = ["", "../src/", "../../src/", "src/"]
    root, found, inner = main.rpartition(f"{os.sep}include{os.sep}")
    if found:
        # What is in include/NAME/part is often in src/part, or in src/NAME/part.
        parts = Path(inner).parts[:-1]
        for below in (parts[1:], parts):
            source = os.path.join(root, "src", *below)  # noqa: PTH118
            places.append(f"{Path(os.path.relpath(source, folder)).as_posix()}/")
    for outer in places:
        for suffix in _SOURCES:
            name = f"{outer}{{}}{suffix}"
            place = os.path.join(folder, name.replace("{}", path.stem))  # noqa: PTH118
            if is_file(place):
                yield name
                return
    if found:
        yield from _only_source(os.path.join(root, "src"), folder, path.stem)  # noqa: PTH118


def _declaring(path: Path) -> Iterator[str]:
    """Yield the header that declares the templates which `NAME_impl.hpp` beside it defines."""
    for ending in ("_impl", "-impl", "_inl"):
        if path.stem.endswith(ending):
            for suffix in (path.suffix, *_HEADERS):
                name = path.stem.removesuffix(ending) + suffix
                if path.with_name(name).is_file():
                    yield name
                    return


def _only_source(root: str, folder: str, stem: str) -> Iterator[str]:
    """Yield the one source of a name below a folder."""
    found = []
    for at, (place, _, files) in enumerate(os.walk(root)):
        if at >= _MOST_FOLDERS:
            return
        found += [(place, name) for name in files if name in {stem + each for each in _SOURCES}]
    if len(found) == 1:
        place, name = found[0]
        outer = Path(os.path.relpath(place, folder)).as_posix()
        yield f"{outer}/{{}}{name[len(stem) :]}"
