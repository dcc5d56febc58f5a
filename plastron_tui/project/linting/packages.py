"""Reading a package: its build files, and what its other files have to do with them."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.lint.tree import PackageFacts
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.packages.facts import build_facts
from plastron_tui.sources.packages.facts.components import programs_of
from plastron_tui.sources.packages.facts.texts import LARGEST
from plastron_tui.sources.packages.files import BUILD_FILES
from plastron_tui.sources.packages.installed import further_programs
from plastron_tui.sources.packages.reading import SETUP_PY, PackageFiles, read_package_files
from plastron_tui.targets import language_of

from .kept_diagnostics import Kept, kept, unread

_OF_XML = frozenset({codes.BROKEN_XML, codes.UNSUPPORTED_XML, codes.BROKEN_PACKAGE})
_UNREADABLE = frozenset({codes.UNREADABLE_FILE, codes.FILE_TOO_LARGE})


class PackageRead(NamedTuple):
    """What was read of a package.

    Attributes:
        facts: what it says, None where nothing of it counts.
        wrong: why nothing of it counts, where one of its files is to blame.
    """

    facts: PackageFacts | None
    wrong: Kept = ()


_MAY_RUN = stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH


def runnable(folder: str, names: Iterable[str]) -> frozenset[str]:
    """Return the files of a package that may be scripts, and that their mode lets somebody run."""
    found = set()
    for name in names:
        if name.endswith(".py") or "." not in name.rpartition("/")[2]:
            with suppress(OSError):
                if os.stat(f"{folder}/{name}").st_mode & _MAY_RUN:
                    found.add(name)
    return frozenset(found)


def read_package(folder: str, names: frozenset[str], programs: frozenset[str]) -> PackageRead:
    """Return what a package says.

    Args:
        folder: where it is.
        names: its files.
        programs: those that somebody may run.
    """

    def read(name: str) -> bytes | None:
        with suppress(OSError, ValueError):
            return read_regular(Path(folder, name), LARGEST)
        return None

    texts = {name: text for name in BUILD_FILES if (text := read(name)) is not None}
    if "package.xml" not in texts:
        return PackageRead(None)
    files = PackageFiles(Path(folder), names, texts, is_whole=False)
    source, found = read_package_files(files, 2)
    if source is None:
        return PackageRead(None, kept(_left_out(found, texts)))
    further = further_programs(source, read)
    source = replace(source, executables={**further.programs, **source.executables})
    built = programs_of(source)
    facts = PackageFacts(
        source.folder,
        source.name,
        (source.ros_version,),
        built.executables,
        build_facts(source, read, programs, is_whole=further.is_whole),
        built.loaded,
    )
    return PackageRead(facts)


def _left_out(found: Iterable[Diagnostic], texts: Mapping[str, bytes]) -> Iterator[Diagnostic]:
    """Yield why nothing of a package counts: what the build refuses, or cannot be read here."""
    for each in found:
        file = each.file
        text = None if file is None else texts.get(file.name)
        if each.code in _OF_XML:
            yield each
        elif file is None or text is None:
            continue
        elif file.name == SETUP_PY:
            language = language_of(file)
            refused = None if language is None else language.refusal(file, text)
            if refused is not None:
                yield refused
            elif each.code in _UNREADABLE:
                yield unread(each)
        elif each.code in _UNREADABLE or (each.code is codes.BROKEN_BUILD_FILE and each.span):
            yield unread(each)
