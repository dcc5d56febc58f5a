"""Where something of a program is in code: in the files that it loads, and in those it becomes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.source import FileSet, SourceNode, SourceUnit, place_of
from plastron_tui.model.workspace import Generation, Node
from plastron_tui.regular_files import read_regular
from plastron_tui.sources import find_language

from .analysis import Analysis, analyse
from .function_lines import answer_line, function_lines
from .panels.entry import Entry, Subject
from .panels.entry_signs import HUBS
from .panels.nodes import make as node_entries
from .panels.preview import files_meant

if TYPE_CHECKING:
    from plastron_tui.session import Session

_ANSWERING = frozenset({EndpointKind.SERVICE, EndpointKind.ACTION_SERVER})
"""Whose function is where somebody writes what a node is for."""

LARGEST = 16 * 1024**2
"""The largest file that is shown, in bytes."""


@dataclass(frozen=True, slots=True)
class Place:
    """A line of a file.

    Attributes:
        path: the file.
        line: the line, from 1.
        what: what is there, such as `publisher chatter`.
        text: what generating would write; None where the file itself is meant.
    """

    path: Path
    line: int
    what: str
    text: bytes | None = None


@dataclass(frozen=True, slots=True)
class Found:
    """The places of something, the first one first; where there is none, why."""

    places: tuple[Place, ...]
    reason: str = ""


def find_code(session: Session, asked: Entry | int) -> Found:
    """Find what an entry of a panel, or the statement at an offset, is in code.

    It reads files and may take as long as an analysis: it is to be called in a thread, with a
    session that is that thread's alone.
    """
    finder = _Finder(analyse(session, lambda: None))
    entry = finder.entry_at(asked) if isinstance(asked, int) else asked
    if entry is None:
        return Found((), "the cursor is on no statement that becomes code")
    places = tuple(dict.fromkeys(finder.places(entry)))
    if not places and isinstance(asked, Entry) and asked.span is not None:
        there = finder.entry_at(asked.span.start)
        places = () if there is None else tuple(dict.fromkeys(finder.places(there)))
    reason = finder.problems[0].message if finder.problems else f"{entry.text} is in no file"
    return Found(places, reason)


class _Finder:
    """Finds places; what keeps a file from being made is among its problems."""

    def __init__(self, analysis: Analysis) -> None:
        self.problems: list[Diagnostic] = []
        self._analysis = analysis
        self._session = analysis.session
        self._workspace = analysis.workspace

    def entry_at(self, offset: int) -> Entry | None:
        """Return what the statement at an offset is about."""
        found = node_entries(self._analysis, None).at(offset)
        if found is not None:
            return found
        name = self._analysis.written_at(offset)
        if name is None:
            return None
        node = self._workspace.nodes.get(name)
        if node is not None:
            return Entry("", node.name, subject=Subject.NODE, node=name, name=name)
        return Entry("", name, subject=Subject.OTHER, name=name)

    def places(self, entry: Entry) -> Iterator[Place]:
        """Yield the places of an entry."""
        subject, name = entry.subject, entry.name or ""
        if entry.file is not None:
            yield Place(entry.file, max(1, entry.line), entry.text)
        elif isinstance(subject, EndpointKind):
            yield from self._of_node(entry.node or "", (subject, name))
        elif subject is Subject.NODE:
            yield from self._of_node(entry.node or "", None)
        elif subject in HUBS.values():
            yield from self._of_hub(subject, name)
        elif subject in (Subject.LINK, Subject.JOINT):
            yield from self._of_written(entry.robot or "", (subject.word, name))
        else:
            yield from self._of_written(name, None)

    def _of_hub(self, subject: Subject | EndpointKind, name: str) -> Iterator[Place]:
        """Yield the places of all that meet at a topic, service or action."""
        for hub in self._analysis.graph.hubs:
            if HUBS[hub.interface] is subject and hub.name == name:
                for end in hub.ends:
                    yield from self._of_node(end.node.variable, (end.kind, end.written))

    def _of_written(self, variable: str, part: tuple[str, str] | None) -> Iterator[Place]:
        """Yield the files of a package, launch file, robot or type, or the line of a robot's part.

        The file that was loaded comes after those that are written.
        """
        is_meant = files_meant(self._workspace, variable)
        if is_meant is not None:
            from pathlib import PurePosixPath

            plan, problems = self._session.plan(has_copies=False)
            self.problems += problems
            for file in plan.files:
                if is_meant(PurePosixPath(file.name)):
                    text = file.text if file.before is None else file.before
                    line, what = _line_of_part(text, part), _words(part) or file.name
                    yield Place(file.path, line, what, None if file.before is not None else text)
        yield from self._of_loaded(variable, part)

    def _of_loaded(self, variable: str, part: tuple[str, str] | None) -> Iterator[Place]:
        known = self._workspace
        kinds: tuple[Mapping[str, object], ...] = (known.robots, known.launches, known.types)
        for kind in kinds:
            path = getattr(getattr(kind.get(variable), "source", None), "path", None)
            if isinstance(path, Path):
                text = _read(path)
                line = 1 if text is None else _line_of_part(text, part)
                yield Place(path, line, _words(part) or path.name)

    def _of_node(self, variable: str, key: tuple[EndpointKind, str] | None) -> Iterator[Place]:
        """Yield where a node, or an endpoint of it, is: what it becomes, then what it was."""
        node = self._workspace.nodes.get(variable)
        if node is None:
            return
        for generation in self._generations(node):
            yield from self._of_generation(generation, key)
        if node.source is not None:
            unit = _unit(node.source.path)
            if unit is not None:
                unit = unit.only(node.source.label)
                yield from _in_unit(unit, frozenset(unit.files.names), node.name, key)

    def _generations(self, node: Node) -> list[Generation]:
        """Return how a node is generated, by each library; of one that is not, how it would be."""
        asked = {
            made.library: made
            for made in self._workspace.generations
            if made.node.variable == node.variable
        }
        if asked or node.source is not None:
            return list(asked.values())
        return [Generation(node, node.library or self._session.library, node.span)]

    def _of_generation(
        self, generation: Generation, key: tuple[EndpointKind, str] | None
    ) -> Iterator[Place]:
        made = self._session.generate(generation)
        if made.files is None:
            self.problems += made.diagnostics
            return
        plan, problems = self._session.plan_of([made], is_preview=True)
        self.problems += problems
        files = list(zip(plan.files, made.files.files.names, strict=False))
        if not files:
            return
        texts = [(name, file.text if file.before is None else file.before) for file, name in files]
        on_disk = frozenset(name for file, name in files if file.before is not None)
        unit = _read_unit(files[0][0].path, FileSet(tuple(texts)))
        yield from _in_unit(unit, on_disk, generation.node.name, key)


def _unit(path: Path) -> SourceUnit | None:
    """Return what the files of a node say that are on the disk now."""
    from plastron_tui.project.loader import with_others

    text = _read(path)
    return None if text is None else _read_unit(path, with_others(path, text))


def _read_unit(path: Path, files: FileSet) -> SourceUnit:
    from plastron_tui.project.loader import read_node

    return read_node(path, files).source or SourceUnit(path, files, "", ())


def _read(path: Path) -> bytes | None:
    try:
        return read_regular(path, LARGEST)
    except (OSError, ValueError):
        return None


def _in_unit(
    unit: SourceUnit,
    on_disk: frozenset[str],
    node: str,
    key: tuple[EndpointKind, str] | None,
) -> Iterator[Place]:
    """Yield the places in the files of a node: of the node itself, or of an endpoint of it.

    Args:
        unit: the files, read.
        on_disk: the names of those that are on the disk.
        node: the node's name.
        key: the kind and the name of the endpoint.
    """

    def place(name: str, line: int, what: str) -> Place:
        text = None if name in on_disk else unit.files.get(name)
        return Place(place_of(unit.path, name), line, what, text)

    main = unit.files.names[0]
    found = _nodes_called(unit, node)
    if key is None:
        for each in found[:1]:
            start = 0 if each.span is None else each.span.start
            yield place(main, unit.files.main.count(b"\n", 0, start) + 1, f"node {node}")
        for name in unit.files.names[bool(found) :]:
            yield place(name, 1, place_of(unit.path, name).name)
        return
    kind, written = key
    for each in found:
        for endpoint in each.of_kind(kind):
            if written not in (endpoint.label, endpoint.name, endpoint.default,
                               endpoint.expression):  # fmt: skip
                continue
            there = place(endpoint.file or main, endpoint.line, f"{kind.word} {written}")
            what = f"function {endpoint.callback}"
            if kind in _ANSWERING:
                answers = _answers(unit.path, unit.files, endpoint.callback)
                yield from (place(name, line, what) for name, line in answers)
                yield there
                continue
            yield there
            functions = _functions(unit.path, unit.files, endpoint.callback)
            yield from (place(name, line, what) for name, line in functions)


def _nodes_called(unit: SourceUnit, name: str) -> tuple[SourceNode, ...]:
    """Return the nodes of a file that have a name; all where none has it."""
    named = tuple(node for node in unit.nodes if name in (node.name, node.label))
    return named or unit.nodes


def _functions(path: Path, files: FileSet, function: str | None) -> Iterator[tuple[str, int]]:
    """Yield where the files of a set define or declare a function: the file and the line."""
    for file, text in files.texts if function else ():
        for line in function_lines(text, function or "", is_python=_is_python(path, file)):
            yield file, line


def _answers(path: Path, files: FileSet, function: str | None) -> Iterator[tuple[str, int]]:
    """Yield where a function that is defined there says what it gives back."""
    for file, line in _functions(path, files, function):
        text = files.get(file) or b""
        found = answer_line(text, line, is_python=_is_python(path, file))
        if found is not None:
            yield file, found


def _is_python(path: Path, file: str) -> bool:
    # A script may have no suffix; C++ without one is nothing that a compiler takes.
    return place_of(path, file).suffix in ("", *find_language("python").suffixes)


def _line_of_part(text: bytes, part: tuple[str, str] | None) -> int:
    """Return the line of a link or a joint of a robot's file, 1 where it is not said outright."""
    if part is None:
        return 1
    word, name = (re.escape(each.encode()) for each in part)
    pattern = rb"""<%b\s(?:[^<>]*\s)?name\s*=\s*["']%b["']""" % (word, name)
    match = re.search(pattern, text)
    return 1 if match is None else text.count(b"\n", 0, match.start()) + 1


def _words(part: tuple[str, str] | None) -> str:
    return "" if part is None else " ".join(part)
