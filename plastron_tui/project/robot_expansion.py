"""Expanding the macros of a robot that a program loads, where the user trusts the project."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.regular_files import Stamp, stamp_of
from plastron_tui.ros.robots.macros import Arguments

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


KnownExpansions: TypeAlias = dict[tuple[Path, bytes, Arguments], _Known]
"""What came of expanding texts, by their paths, their digests, and what they were given.

A process each time takes too long.
"""


def said_by_program(argument: str) -> str:
    """Say how a program gives a robot's file the value of an argument."""
    return f"say it behind the robot's name: `setting '{argument}' = \"…\"`"


def said_by_command(argument: str) -> str:
    """Say how a command gives a robot's file the value of an argument."""
    return f"say it behind the file: `{argument}:=…`"


class RobotExpander:
    """Expands the macros of files; without the user's trust it says what is to be done."""

    def __init__(
        self,
        boundary: Boundary,
        environ: Mapping[str, str],
        known: KnownExpansions,
        say: Callable[[str], str] = said_by_program,
    ) -> None:
        """Set how far files may lead.

        Args:
            boundary: the project.
            environ: the environment variables that say which ROS is sourced.
            known: what earlier ones have expanded.
            say: says how an argument without a value gets one.
        """
        self._boundary = boundary
        self._environ = environ
        self._known = known
        self._say = say

    def __call__(
        self, path: Path, text: bytes, document: XmlDocument, arguments: Arguments
    ) -> Expansion:
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
        key = path, sha256(text).digest(), arguments
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
        known = self._expanded(path, text, arguments, (reach, modules), checked.files)
        if len(self._known) >= _MOST:
            self._known.clear()
        self._known[key] = known
        return known.expansion

    def _expanded(
        self,
        path: Path,
        text: bytes,
        arguments: Arguments,
        how: tuple[Reach, Path],
        files: Iterable[Path],
    ) -> _Known:
        from plastron_tui.runtime.xacro import expand

        expanded = expand(path, text, *how, arguments)
        stamps = {each: stamp_of(each) for each in (*files, *expanded.files)}
        if expanded.text is None:
            remedy = self._say(expanded.missing) if expanded.missing else None
            found = _refused(f"the macros are not expanded: {expanded.reason}", remedy)
        else:
            found = _read(expanded.text)
        return _Known(
            found._replace(asked=expanded.asked, unused=expanded.unused, opened=expanded.files),
            stamps,
        )


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
