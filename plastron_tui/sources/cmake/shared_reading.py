"""Reading a CMakeLists.txt once for all who ask about the same text."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.sources.text_memo import MEMO

from .reader import ReadCMake, read_cmake


def read_shared(text: bytes, path: Path) -> ReadCMake:
    """Return what a CMakeLists.txt says; nobody changes it, as others may be given the same."""
    key = read_shared, text, path
    found: ReadCMake | None = MEMO.get(key)
    if found is None:
        found = read_cmake(text, path)
        if found.lists is not None:
            MEMO.keep(key, found, len(text))
    return found
