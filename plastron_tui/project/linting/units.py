"""Reading the files of a node, as a worker does it: what comes back is small."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from plastron_tui.lint.one_unit import facts_of
from plastron_tui.lint.tree import UnitFacts
from plastron_tui.model.source import LARGEST_FILE, place_of
from plastron_tui.project.loader import with_others
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.text_memo import sharing
from plastron_tui.targets import language_of, read_source, ros_version

from .cache import packed
from .fingerprints import Reads, noted


class UnitRead(NamedTuple):
    """What was read of files.

    Attributes:
        facts: what they say.
        parts: the other files that were read with the main one.
    """

    facts: UnitFacts
    parts: tuple[str, ...] = ()


class UnitAnswer(NamedTuple):
    """What a worker has read.

    Attributes:
        path: the main file.
        reads: all that was read for it.
        data: a `UnitRead` as bytes, or None where the files have no node.
        problem: why it could not be read, "" where it could.
    """

    path: str
    reads: Reads
    data: bytes
    problem: str = ""


def read_unit(name: str) -> UnitAnswer:
    """Read a file with those that belong to it; it never fails."""
    reads = Reads({}, {})
    problem = ""
    read = None
    try:
        with noted(reads), sharing():
            read = _read(Path(name), reads)
    except Exception as error:
        problem = failure(error)
    return UnitAnswer(name, reads, packed(read), problem)


def failure(error: Exception) -> str:
    """Return why a file is not read that nobody has thought of: the others still are."""
    if isinstance(error, RecursionError):
        return "it is nested too deep"
    if isinstance(error, MemoryError):
        return "it takes too much memory"
    return f"plastron fails at it ({type(error).__name__}: {error})"


def _read(path: Path, reads: Reads) -> UnitRead | None:
    try:
        text = read_regular(os.fspath(path), LARGEST_FILE)
    except (OSError, ValueError):
        return None
    language = language_of(path, text)
    if language is None or language.mentioned_library(text) is None:
        return None
    files = with_others(path, text)
    source, _, beside = read_source(path, files)
    for other in map(os.fspath, beside):
        if other not in reads.digests:
            # What is remembered of a text may be known without a look at it (`shared_analysis`).
            with suppress(OSError, ValueError):
                read_regular(other, LARGEST_FILE)
    if source is None:
        return None
    facts = facts_of(source, ros_version(source.library), language.code_facts(source))
    return UnitRead(facts, tuple(str(place_of(path, each)) for each in files.names[1:]))
