"""Expanding the macros of a robot that a program loads, where the user trusts the project."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.regular_files import Stamp, stamp_of

from .robot_reader import Expansion

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary
    from plastron_tui.sources.urdf.reach import Reach
    from plastron_tui.sources.xml.document import XmlDocument

_MOST = 16
"""How many expansions are remembered; a program loads one or two robots."""

_MOST_MISTAKES = 3
"""How many mistakes of the expanded file are told: it has no lines that anybody could look at."""


class _Known(NamedTuple):
    """What came of expanding a text, and what the files were that it depends on."""

    expansion: Expansion
    stamps: Mapping[Path, Stamp | None]

    def is_current(self) -> bool:
        """Tell whether it would be the same now."""
        return all(stamp_of(path) == stamp for path, stamp in self.stamps.items())


KnownExpansions: TypeAlias = dict[tuple[Path, bytes], _Known]
"""What came of expanding texts, by their paths and digests: a process each time takes too long."""


class RobotExpander:
    """Expands the macros of files; without the user's trust it says what is to be done."""

    def __init__(
        self, boundary: Boundary, environ: Mapping[str, str], known: KnownExpansions
    ) -> None:
        """Set how far files may lead.

        Args:
            boundary: the project.
            environ: the environment variables that say which ROS is sourced.
            known: what earlier ones have expanded.
        """
        self._boundary = boundary
        self._environ = environ
        self._known = known

    def __call__(self, path: Path, text: bytes, document: XmlDocument) -> Expansion:
        """Return what the macros of a file make of it, or say why they are not expanded."""
        if not self._boundary.is_trusted:
            message = "the macros are not expanded, as the project is not trusted"
            remedy_ = self._boundary.remedy
            found = Diagnostic(codes.UNTRUSTED_MACROS, message, help=remedy_)
            return Expansion(None, (found,))
        from plastron_tui.runtime.xacro import find_xacro, remedy

        modules = find_xacro(self._environ)
        if modules is None:
            message = "the macros are not expanded, as the package `xacro` is not installed"
            return _refused(message, remedy(self._environ))
        key = path, sha256(text).digest()
        known = self._known.get(key)
        if known is not None and known.is_current():
            return known.expansion
        from plastron_tui.sources.urdf.includes import check_includes
        from plastron_tui.sources.urdf.reach import find_reach

        path = path.absolute()
        reach = find_reach(self._boundary, path, self._environ)
        checked = check_includes(document, path, reach)
        if checked.diagnostics:
            # No process, and so not remembered: what is missing may be there the next time.
            return Expansion(None, checked.diagnostics)
        known = _expanded(path, text, (reach, modules), checked.files)
        if len(self._known) >= _MOST:
            self._known.clear()
        self._known[key] = known
        return known.expansion


def _expanded(path: Path, text: bytes, how: tuple[Reach, Path], files: Iterable[Path]) -> _Known:
    from plastron_tui.runtime.xacro import expand

    expanded = expand(path, text, *how)
    stamps = {each: stamp_of(each) for each in (*files, *expanded.files)}
    if expanded.text is None:
        message = f"the macros are not expanded: {expanded.reason}"
        return _Known(_refused(message), stamps)
    return _Known(_read(expanded.text), stamps)


def _read(text: bytes) -> Expansion:
    """Read a file whose macros are expanded."""
    from plastron_tui.sources.urdf.reader import read_urdf

    read = read_urdf(text)
    found = dict.fromkeys(
        each._replace(
            message=f"in the expanded file, {each.message}",
            span=None,
            labels=(),
            fix=None,
            severity=Severity.WARNING,
        )
        for each in read.diagnostics
    )
    return Expansion(read.description, tuple(found)[:_MOST_MISTAKES])


def _refused(message: str, remedy: str | None = None) -> Expansion:
    return Expansion(None, (Diagnostic(codes.NOT_EXPANDED, message, help=remedy),))
