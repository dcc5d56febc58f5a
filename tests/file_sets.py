"""Sets of one file, which is what every Python node is."""

from __future__ import annotations

from plastron_tui.model.source import FileSet


def one(text: bytes, suffix: str = ".py") -> FileSet:
    """Return the set of one file."""
    return FileSet.single(suffix, text)
