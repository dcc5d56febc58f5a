"""Reading the files of a node, as a worker does it: what comes back is small."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.lint.one_unit import facts_of
from plastron_tui.lint.tree import UnitFacts
from plastron_tui.model.source import LARGEST_FILE, place_of
from plastron_tui.project.loader import with_others
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.base import Language
from plastron_tui.sources.not_text import without_nul
from plastron_tui.sources.text_memo import sharing
from plastron_tui.targets import language_of, read_source, ros_version

from .cache import packed
from .fingerprints import Reads, noted
from .kept_diagnostics import Kept, kept, unread


class UnitRead(NamedTuple):
    """What was read of files.

    Attributes:
        facts: what they say, None where they are not read.
        parts: the other files that were read with the main one.
        wrong: why the main one is not read, or not run.
    """

    facts: UnitFacts | None
    parts: tuple[str, ...] = ()
    wrong: Kept = ()


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
    if language is None or language.mentioned_library(without_nul(text)) is None:
        return None
    files = with_others(path, text)
    source, found, beside = read_source(path, files)
    for other in map(os.fspath, beside):
        if other not in reads.digests:
            # What is remembered of a text may be known without a look at it (`shared_analysis`).
            with suppress(OSError, ValueError):
                read_regular(other, LARGEST_FILE)
    if source is None:
        left = kept(_left_out(language, path, text, found))
        return UnitRead(None, wrong=left) if left else None
    version = ros_version(source.library)
    refused = language.refusal(path, text, version)
    facts = facts_of(source, version, language.code_facts(source))
    parts = tuple(str(place_of(path, each)) for each in files.names[1:])
    return UnitRead(facts, parts, kept([] if refused is None else [refused]))


def _left_out(
    language: Language, path: Path, text: bytes, found: Iterable[Diagnostic]
) -> Iterator[Diagnostic]:
    """Yield why a file is not read that has the name of a client library."""
    for each in found:
        if each.code is codes.UNREADABLE_FILE:
            yield language.refusal(path, text) or unread(each)
        elif each.code is codes.FILE_TOO_LARGE:
            yield unread(each)
