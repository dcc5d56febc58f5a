"""Which line of a file the statements of a node become."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import FileSet
from plastron_tui.model.workspace import Node

if TYPE_CHECKING:
    from plastron_tui.model.kinds import EndpointKind

    from ..analysis import PartMemo

_LARGEST = 100_000
"""Bytes of files that are read again with each change of the program."""


def lines_of_statements(
    path: Path, files: FileSet, node: Node, memo: PartMemo
) -> Mapping[str, dict[Span, int]]:
    """Return the line, from 1, that each statement of a node becomes, by the file's name.

    Args:
        path: the main file.
        files: what would be written.
        node: the node that they are of.
        memo: knows the lines of files that were read before.
    """
    found: dict[str, dict[Span, int]] = {name: {} for name in files.names}
    if sum(len(text) for _, text in files.texts) > _LARGEST:
        return found
    key = "lines", path, files, tuple(node.by_kind)
    written = memo.once(key, lambda: _read(path, files, tuple(node.by_kind)))
    main = files.names[0]
    for each in written:
        if each.line and len(written) == 1:
            found[main][node.span] = each.line
        for place, span in _statements(node):
            if place in each.endpoints:
                file, line = each.endpoints[place]
                found.setdefault(file or main, {}).setdefault(span, line)
    return found


class _Written(NamedTuple):
    """Where a node and its endpoints are in files; 0 for a node that is nowhere in particular."""

    line: int
    endpoints: Mapping[tuple[object, str], tuple[str, int]]


def _read(path: Path, files: FileSet, kinds: Sequence[EndpointKind]) -> tuple[_Written, ...]:
    from plastron_tui.project.loader import read_node

    unit = read_node(path, files).source
    return () if unit is None else tuple(
        _Written(
            0 if each.span is None else files.main.count(b"\n", 0, each.span.start) + 1,
            {
                (kind, name): (endpoint.file, endpoint.line)
                for kind in kinds
                for endpoint in each.of_kind(kind)
                for name in (endpoint.label, endpoint.name, endpoint.default)
                if name
            },
        )
        for each in unit.nodes
    )  # fmt: skip


def _statements(node: Node) -> Iterator[tuple[tuple[object, str], Span]]:
    """Yield the kind and the name of each endpoint, and the statement that made it."""
    for kind, endpoints in node.by_kind.items():
        for name, endpoint in endpoints.items():
            span = getattr(endpoint, "span", None)
            if isinstance(span, Span):
                yield (kind, name), span
