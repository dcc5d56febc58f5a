"""What a project sets for `plastron lint`."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from plastron_tui.diagnostics import Span

_KEYS = ("select", "ignore", "per_file_ignores", "baseline", "exclude")
_NULL = "tag:yaml.org,2002:null"

_Node = Any
"""A node of PyYAML's tree."""


class Reader(Protocol):
    """Reads values of the project file, and remembers what is wrong with them."""

    def pairs(self, root: _Node | None, keys: Collection[str], of: str) -> dict[str, _Node]:
        """Return the nodes of the keys that there are."""

    def folder(self, key: str, node: _Node | None, *, what: str) -> Path | None:
        """Return the path of a folder, or of a file."""

    def report(self, node: _Node, message: str) -> None:
        """Report a node that is wrong."""

    def span(self, node: _Node) -> Span:
        """Return the bytes of a node."""


class LintSettings(NamedTuple):
    """What stands below `lint:` in the project file.

    Attributes:
        select: the rules that are followed, none for those that are by themselves.
        ignore: those of them that are not.
        per_file: patterns of paths from the project file, and what is not told of such files.
        baseline: the file with what was found before, and is left.
        exclude: patterns of paths from the project file that are not looked at.
        places: where each word that is to mean rules stands in the project file.
    """

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    per_file: Mapping[str, tuple[str, ...]] = {}
    baseline: Path | None = None
    exclude: tuple[str, ...] = ()
    places: Mapping[str, Span] = {}


def read_lint(reader: Reader, node: _Node | None) -> LintSettings:
    """Return what is set below `lint:`; which words mean rules the linter knows itself."""
    values = reader.pairs(node, _KEYS, "`lint`")
    places: dict[str, Span] = {}

    def words(key: str) -> tuple[str, ...]:
        return tuple(_words(reader, key, values.get(key), places))

    per_file = {
        pattern.value: tuple(_words(reader, "per_file_ignores", meant, places))
        for pattern, meant in _mapping(reader, values.get("per_file_ignores"))
    }
    baseline = reader.folder("baseline", values.get("baseline"), what="file")
    exclude = tuple(_words(reader, "exclude", values.get("exclude"), {}))
    return LintSettings(words("select"), words("ignore"), per_file, baseline, exclude, places)


def _mapping(reader: Reader, node: _Node | None) -> Iterator[tuple[_Node, _Node]]:
    if node is None or node.tag == _NULL:
        return
    if node.id != "mapping":
        reader.report(node, "`per_file_ignores` is a list of `pattern: codes` lines")
        return
    for pattern, meant in node.value:
        if pattern.id == "scalar":
            yield pattern, meant
        else:
            reader.report(pattern, "a pattern is a text, such as `test/*`")


def _words(reader: Reader, key: str, node: _Node | None, places: dict[str, Span]) -> Iterator[str]:
    """Yield the words of a list, or of a single entry, and note where they stand."""
    if node is None or node.tag == _NULL:
        return
    for entry in node.value if node.id == "sequence" else [node]:
        if entry.id != "scalar":
            reader.report(entry, f"`{key}` is a list of words")
            continue
        for word in filter(None, map(str.strip, str(entry.value).split(","))):
            places.setdefault(word, reader.span(entry))
            yield word
