"""Diagnostics about files that are not read, or not run, as the cache keeps them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Severity, codes

Kept = tuple[tuple[Any, ...], ...]
"""Diagnostics, their codes as plain texts."""


def kept(found: Iterable[Diagnostic]) -> Kept:
    """Return diagnostics as plain data."""
    return tuple((str(each.code), *each[1:]) for each in found)


def diagnostics_of(found: Kept) -> Iterator[Diagnostic]:
    """Yield the diagnostics that plain data stands for."""
    for code, *parts in found:
        yield Diagnostic(codes.CODES[code], *parts)


def unread(found: Diagnostic) -> Diagnostic:
    """Return why a file is not read here, which others may well read."""
    help_text = found.help or "nothing of the file is looked at"
    return found._replace(help=help_text, severity=Severity.WARNING)


def is_template(path: Path) -> bool:
    """Tell whether a file lies among templates, which a tool fills in."""
    folders = (each.lower() for each in path.parts[:-1])
    return any(each.endswith(("template", "templates")) for each in folders)
