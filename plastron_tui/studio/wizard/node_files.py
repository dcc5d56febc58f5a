"""A file that holds nodes, and which of them is meant."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from plastron_tui.language import SlotKind
from plastron_tui.language.sentence import is_module
from plastron_tui.model.context import LoadRequest
from plastron_tui.model.source import LARGEST_FILE, SourceUnit, place_of
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.base import Language
from plastron_tui.targets import languages

from ..folder_files import MOST_ENTRIES, MOST_FILES, files_of, path_text
from .ask import Ask, Choice
from .form import Cell
from .kind import OF_THE_LIST, Kind
from .variable_kinds import NewVariableKind


class FileKind(Kind):
    """A file that holds a node."""

    def suggest(self, ask: Ask) -> str:
        """Return the first file that is not loaded yet, or else the first one that is."""
        # Only of a file that is loaded already something is said.
        choices = sorted(self.choices(ask, ""), key=lambda each: bool(each.about))
        for choice in choices:
            if ask.try_out(choice.text, frozenset()).reason is None:
                return choice.text
        return ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the node files of the program's folder and of the output folder."""
        session = ask.scene.session
        loaded = {
            node.source.path: variable
            for variable, node in ask.scene.workspace.nodes.items()
            if node.source is not None and node.source.label is None
        }
        around = ask.scene.surroundings
        if around.files is None:
            around.files = tuple(
                dict(
                    each
                    for folder in dict.fromkeys((session.folder, session.output))
                    for each in _node_files(folder)
                ).items()
            )
        return [
            Choice(
                path_text(path, session.folder),
                library,
                _goes_on(loaded[path]) if path in loaded else "",
            )
            for path, library in around.files
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no path that a program can hold."""
        if not text:
            return "no file of a node is beside the program: write the path of one"
        if "'" in text:
            return "a path in a program has no single quote"
        return None


class NodeOfFileKind(Kind):
    """The name of a node of a file that holds several."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Leave it out for a file of one node."""
        source = _source(ask)
        is_one = source is None or len(source.nodes) < 2
        return Cell("", "the file holds one node") if is_one else None

    def suggest(self, ask: Ask) -> str:
        """Return the first node that is not loaded yet, or else the first one that is."""
        # Only of a node that is loaded already something is said.
        choices = sorted(self.choices(ask, ""), key=lambda each: bool(each.about))
        return next((each.text for each in choices), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the nodes of the file."""
        source = _source(ask)
        if source is None:
            return []
        loaded = {
            node.source.label: variable
            for variable, node in ask.scene.workspace.nodes.items()
            if node.source is not None and node.source.path == source.path
        }
        return [
            Choice(label, about=_goes_on(loaded[label]) if label in loaded else "")
            for label in _labels(source)
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text names no node of the file."""
        source = _source(ask)
        if source is not None and text in _labels(source):
            return None
        return f"the file has no node `{text}`: {OF_THE_LIST}"


class NewNodeKind(NewVariableKind):
    """What the program calls a node that it makes, or reads from a file."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return what the node of a file is called that is read already: it goes on with that."""
        variable = _loaded_as(ask)
        return None if variable is None else Cell(variable, "loaded already: it goes on with this")


def _goes_on(variable: str) -> str:
    return f"loaded already: it goes on with `{variable}`"


def _loaded_as(ask: Ask) -> str | None:
    """Return the variable of the node that the form would read once more, None for a new one."""
    if ask.form.slot_of(SlotKind.FILE) is None or not ask.text(SlotKind.FILE):
        return None
    nodes = {
        variable: node.source
        for variable, node in ask.scene.workspace.nodes.items()
        if node.source is not None
    }
    source = _source(ask) if nodes else None
    if source is None:
        return None
    label = ask.text(SlotKind.NODE_OF_FILE) or None
    same = (name for name, each in nodes.items() if (each.path, each.label) == (source.path, label))
    return next(same, None)


def _source(ask: Ask) -> SourceUnit | None:
    """Return the file that the form names, None where it cannot be read."""
    file = ask.text(SlotKind.FILE)
    generated = tuple(ask.scene.workspace.generations)
    return ask.scene.session.setting.read(LoadRequest(file, not is_module(file), generated)).source


def _labels(source: SourceUnit) -> list[str]:
    """Return what the nodes of a file are called, where they have a name."""
    return list(dict.fromkeys(node.label for node in source.nodes if node.label))


def _node_files(folder: Path) -> Iterator[tuple[Path, str]]:
    """Yield the files below a folder that name a client library, with its name.

    One that is read with another, as a header is with its source, is left out.
    """
    found = list(islice(_marked(folder), MOST_FILES))
    covered: set[Path] = set()
    # Those that a new node's file would end in come first: the others belong to them.
    for path, language, text, _ in sorted(found, key=lambda each: _rank(each.path, each.language)):
        if path not in covered:
            beside = (place_of(path, name) for name in language.others(path, text))
            covered.update(each for each in beside if _rank(path, language) < _rank(each, language))
    return ((each.path, each.library) for each in found if each.path not in covered)


def _rank(path: Path, language: Language) -> int:
    return language.suffixes.index(path.suffix) if path.suffix in language.suffixes else 0


class _Marked(NamedTuple):
    """A file that names a client library."""

    path: Path
    language: Language
    text: bytes
    library: str


def _marked(folder: Path) -> Iterator[_Marked]:
    known = {suffix: each for each in languages() for suffix in each.suffixes}
    for path in islice(files_of(frozenset(known), folder), MOST_ENTRIES):
        with suppress(OSError):
            language, text = known[path.suffix], read_regular(path, LARGEST_FILE)
            library = language.mentioned_library(text)
            if library is not None:
                yield _Marked(path, language, text, library)
