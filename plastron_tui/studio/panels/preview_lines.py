"""Which line of a file the statements of a node become."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import FileSet
from plastron_tui.model.workspace import Node

_LARGEST = 100_000
"""Bytes of files that are read again with each change of the program."""


def lines_of_statements(path: Path, files: FileSet, node: Node) -> Mapping[str, dict[Span, int]]:
    """Return the line, from 1, that each statement of a node becomes, by the file's name.

    Args:
        path: the main file.
        files: what would be written.
        node: the node that they are of.
    """
    from plastron_tui.project.loader import read_node

    found: dict[str, dict[Span, int]] = {name: {} for name in files.names}
    if sum(len(text) for _, text in files.texts) > _LARGEST:
        return found
    unit = read_node(path, files).source
    if unit is None:
        return found
    main = files.names[0]
    for each in unit.nodes:
        if each.span is not None and len(unit.nodes) == 1:
            found[main][node.span] = files.main.count(b"\n", 0, each.span.start) + 1
        written = {
            (kind, name): (endpoint.file or main, endpoint.line)
            for kind in node.by_kind
            for endpoint in each.of_kind(kind)
            for name in (endpoint.label, endpoint.name, endpoint.default)
            if name
        }
        for key, span in _statements(node):
            if key in written:
                file, line = written[key]
                found.setdefault(file, {}).setdefault(span, line)
    return found


def _statements(node: Node) -> Iterator[tuple[tuple[object, str], Span]]:
    """Yield the kind and the name of each endpoint, and the statement that made it."""
    for kind, endpoints in node.by_kind.items():
        for name, endpoint in endpoints.items():
            span = getattr(endpoint, "span", None)
            if isinstance(span, Span):
                yield (kind, name), span
