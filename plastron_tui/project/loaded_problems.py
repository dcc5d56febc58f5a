"""What breaks rules in the files that a program loads."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Diagnostic
    from plastron_tui.lint.tree import UnitFacts
    from plastron_tui.model.source import SourceUnit
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.project.settings import Project
    from plastron_tui.ros.catalog import Catalog

_MOST_KNOWN = 64
"""How many files' facts are kept: a program loads a few, and is looked at after every key."""


class Loader(Protocol):
    """A program that loads files, as a session has it."""

    @property
    def workspace(self) -> Workspace:
        """What it builds."""

    @property
    def project(self) -> Project:
        """What the project file says."""

    def catalog(self, ros_version: int) -> Catalog:
        """Return the interface types of a generation of ROS."""


def loaded_problems(program: Loader) -> tuple[Diagnostic, ...]:
    """Return what breaks rules in the files that a program loads, by the project's settings.

    Files that stand for something else than what is on the disk are not looked at.
    """
    sources = {
        node.source.path: node.source
        for node in program.workspace.nodes.values()
        if node.source is not None and _is_on_disk(node.source)
    }
    if not sources:
        return ()
    # A program that loads nothing needs none of it.
    from plastron_tui.lint.one_unit import lint_unit
    from plastron_tui.lint.selection import Selection

    settings, file = program.project.lint, program.project.file
    selection = Selection(settings.select, settings.ignore, settings.per_file)
    root = None if file is None else file.parent
    found: list[Diagnostic] = []
    for source in sources.values():
        facts = _facts.of(source)
        if facts is not None:
            catalogs = {facts.ros_version: program.catalog(facts.ros_version)}
            found += lint_unit(source, facts, catalogs, selection, root)
    return tuple(found)


def _is_on_disk(source: SourceUnit) -> bool:
    if source.origin is None:
        return True
    from plastron_tui.model.source import LARGEST_FILE, place_of
    from plastron_tui.regular_files import read_regular

    with suppress(OSError, ValueError):
        return all(
            read_regular(place_of(source.path, name), LARGEST_FILE) == text
            for name, text in source.files.texts
        )
    return False


class _FactMemo:
    """The facts of files that were read last; of two threads each may read a file itself."""

    def __init__(self) -> None:
        self._known: dict[object, UnitFacts | None] = {}

    def of(self, source: SourceUnit) -> UnitFacts | None:
        """Return what the rules look at of files, None where nobody reads their language."""
        key = source.path, source.files, source.library
        if key in self._known:
            return self._known[key]
        found = _read(source)
        if len(self._known) >= _MOST_KNOWN:
            self._known = {}
        self._known[key] = found
        return found


def _read(source: SourceUnit) -> UnitFacts | None:
    from plastron_tui.lint.one_unit import facts_of
    from plastron_tui.targets import language_of, ros_version

    language = language_of(source.path)
    if language is None:
        return None
    return facts_of(source, ros_version(source.library), language.code_facts(source))


_facts = _FactMemo()
