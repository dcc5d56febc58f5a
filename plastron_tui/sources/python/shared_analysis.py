"""The analysis of a text, made once for all who ask: to read it, to edit it, to merge it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.sources.text_memo import MEMO

from .analysis import Analysis
from .calls import ClientLibrary
from .package import Package, PackageNames
from .sites import complete, outline
from .syntax import parse


def package_names(main: Path, library: ClientLibrary) -> PackageNames:
    """Return what the names stand for that a file imports from its workspace; none is read yet."""
    return Package(main, library, in_workspace=True).names


class _Left(NamedTuple):
    """How much may be done yet to answer questions about a file."""

    steps: int
    passes: int
    steps_of_package: int

    @staticmethod
    def of(analysis: Analysis) -> _Left:
        resolver, package = analysis.resolver, analysis.package
        of_package = 0 if package is None else package.effort.in_all
        return _Left(resolver.effort.in_all, resolver.passes_left, of_package)

    def give(self, analysis: Analysis) -> None:
        """Let nobody get less because others have asked before."""
        resolver = analysis.resolver
        resolver.effort.in_all, resolver.passes_left = self.steps, self.passes
        if analysis.package is not None:
            analysis.package.effort.in_all = self.steps_of_package


class _Known(NamedTuple):
    """What is known of a text, and how much could yet be asked about it then."""

    analysis: Analysis
    left: _Left


def analyze(text: bytes, library: ClientLibrary, package: PackageNames | None = None) -> Analysis:
    """Find the call sites of a file that create endpoints of a client library.

    Args:
        text: what the file holds.
        library: the client library.
        package: what the names stand for that it imports from its package, None to leave them.
    """
    key = analyze, text, library.module, None if package is None else package.path
    known: _Known | None = MEMO.get(key)
    if known is not None and _holds(known.analysis.package, package):
        known.left.give(known.analysis)
        return known.analysis
    analysis = complete(outline(parse(text), library, package))
    size = len(text) + (0 if package is None else package.size)
    MEMO.keep(key, _Known(analysis, _Left.of(analysis)), size)
    return analysis


def _holds(before: PackageNames | None, package: PackageNames | None) -> bool:
    """Tell whether the disk answers each question about a package as it did before.

    A text has a package of its own: what another one has asked of it takes nothing from its budget.
    """
    if before is None or package is None:
        return before is package
    return before.is_current(package)


def analyze_again(before: Analysis, text: bytes) -> Analysis:
    """Find the call sites of what a file holds by now."""
    return analyze(text, before.library, before.package)
