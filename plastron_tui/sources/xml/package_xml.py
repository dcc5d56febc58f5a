"""Read a package.xml, and check it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.sources.text_memo import MEMO

from .document import read_xml
from .package_data import PackageXml, parse_package
from .package_rules import check


class PackageResult(NamedTuple):
    """A package.xml, or why there is none; there may be errors in one that is read."""

    package: PackageXml | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_package(text: bytes, file: Path | None = None) -> PackageResult:
    """Read a package.xml, and check it as the build tools do.

    Args:
        text: what the file holds.
        file: the file, for diagnostics.
    """
    key = read_package, text, file
    found: PackageResult | None = MEMO.get(key)
    if found is None:
        found = _read(text, file)
        MEMO.keep(key, found, len(text))
    return found


def _read(text: bytes, file: Path | None) -> PackageResult:
    document, diagnostics = read_xml(text, file)
    if document is None:
        return PackageResult(None, diagnostics)
    package = parse_package(document)
    if isinstance(package, Diagnostic):
        return PackageResult(None, (package,))
    return PackageResult(package, tuple(check(package)))
