"""What a program says, as the rules look at it: its nodes, and its own mistakes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, LineIndex
from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.kinds import EDITABLE, EndpointKind, Publisher, Subscription
from plastron_tui.model.source import SourceEndpoint, SourceNode
from plastron_tui.model.workspace import Node

from .tree import PackageFacts, UnitFacts


class ProgramFacts(NamedTuple):
    """What was read of a program.

    Attributes:
        path: its file.
        diagnostics: what is wrong with it.
        units: the nodes that it creates, by their client libraries.
    """

    path: Path
    diagnostics: tuple[Diagnostic, ...] = ()
    units: tuple[UnitFacts, ...] = ()


ReadProgram = Callable[[Path, bytes], ProgramFacts]


def units_of(
    path: Path,
    nodes: Iterable[Node],
    lines: LineIndex,
    library: str,
    ros_version: Callable[[str], int],
) -> Iterator[UnitFacts]:
    """Yield the nodes that a program creates, a unit a client library.

    Nodes that it loads are read from their files.

    Args:
        path: the program.
        nodes: what it has.
        lines: its lines.
        library: the client library of nodes that name none.
        ros_version: tells the generation of ROS of a client library.
    """
    by_library: dict[str, list[SourceNode]] = {}
    for node in nodes:
        if node.source is None:
            made = _node(node, lines)
            by_library.setdefault(node.library or library, []).append(made)
    for name, made_nodes in by_library.items():
        code = CodeFacts(is_closed=True)
        yield UnitFacts(path, name, ros_version(name), tuple(made_nodes), code)


def _node(node: Node, lines: LineIndex) -> SourceNode:
    kinds = (kind for kind in EDITABLE if kind.facts.interface is not None)
    endpoints = (each for kind in kinds for each in _endpoints(node, kind, lines))
    return SourceNode(node.name, node.name, tuple(endpoints), node.span, is_managed=node.is_managed)


def _endpoints(node: Node, kind: EndpointKind, lines: LineIndex) -> Iterator[SourceEndpoint]:
    for endpoint in node.by_kind[kind].values():
        span = endpoint.span or node.span
        qos = endpoint.qos if isinstance(endpoint, Publisher | Subscription) else None
        yield SourceEndpoint(
            kind,
            endpoint.name,
            endpoint.name,
            span,
            lines.line_at(span.start),
            endpoint.type,
            qos=qos,
        )


def unwritten(
    programs: Iterable[ProgramFacts],
    units: Iterable[UnitFacts],
    packages: Iterable[PackageFacts],
) -> Iterator[UnitFacts]:
    """Yield the nodes of programs that are not there as files of the workspace as well.

    Args:
        programs: the programs.
        units: the files of nodes.
        packages: the packages; a program in the folder of one is a part of it.
    """
    written = {node.label for unit in units for node in unit.nodes}
    folders = {each.folder: each.name for each in packages}
    for program in programs:
        package = next((folders[x] for x in program.path.parents if x in folders), "")
        for unit in program.units:
            left = tuple(each for each in unit.nodes if each.label not in written)
            if left:
                yield unit._replace(nodes=left, package=package)
