"""Reads the facts of a package that is changed, from texts alone."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from packages import CATKIN, CMAKE, PYTHON

from plastron_tui.model.package_facts import BuildFacts
from plastron_tui.sources.packages.facts import build_facts
from plastron_tui.sources.packages.files import BUILD_FILES
from plastron_tui.sources.packages.reading import PackageFiles, read_package_files

_OWN = {"rover": CMAKE, "wheels": PYTHON, "old": CATKIN}
_PROGRAMS = frozenset({"scripts/mover.py"})

Change = Mapping[str, str | None]
"""The texts of files, or a replacement in one: `OLD -> NEW`; None where a file is taken away."""


def facts_of(package: str, change: Change, programs: frozenset[str] = _PROGRAMS) -> BuildFacts:
    """Return the facts of a package with a change."""
    files = {file.partition("/")[2]: text for file, text in _OWN[package].items()}
    for file, text in change.items():
        if text is None:
            del files[file]
            continue
        old, sign, new = text.partition(" -> ")
        if sign:
            assert old in files[file], old
            text = files[file].replace(old, new)
        files[file] = text
    texts = {file: text.encode() for file, text in files.items()}
    known = {file: texts[file] for file in BUILD_FILES if file in texts}
    source, _ = read_package_files(PackageFiles(Path("/ws", package), frozenset(texts), known), 2)
    assert source is not None
    found = build_facts(source, texts.get, programs)
    assert found is not None
    return found
