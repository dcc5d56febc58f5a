"""What a program means at one moment: the data that the panels show.

It is made by a worker from a snapshot of the session, part by part as panels ask for it, and is
read by everybody afterwards.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import Program
from plastron_tui.model.graph import Graph, graph_of
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import resolved_name
from plastron_tui.session import Session

from .panels import outline
from .panels.entry import Entries
from .placing import Ground

if TYPE_CHECKING:
    from .panels.picture import Picture, Size
    from .preview import Preview


@dataclass(repr=False)
class Analysis:
    """What follows from a text.

    Attributes:
        session: the snapshot that it was made from; only the worker asks it anything.
        text: the program.
        program: its statements.
        workspace: what it builds.
        diagnostics: what is wrong with it.
        counts: how much is in each panel.
        entries: the entries of the panels that are in sight, by the panel's name.
        previews: the files of the nodes that were looked at, by the node's variable.
        drawing: the graph, laid out, and drawn in the sizes that were asked for.
    """

    session: Session
    text: bytes
    program: Program
    workspace: Workspace
    diagnostics: tuple[Diagnostic, ...]
    counts: Mapping[str, int]
    entries: dict[str, Entries] = field(default_factory=dict)
    previews: dict[str, tuple[Preview, ...]] = field(default_factory=dict)
    drawing: Picture | None = None

    @cached_property
    def graph(self) -> Graph:
        """Who meets whom; only the worker asks, for the panels that show it."""
        return graph_of(self.workspace)

    @property
    def ground(self) -> Ground:
        """What statements that are written for somebody go into."""
        return Ground(self.session.document, self.program, self.workspace)

    def node_at(self, offset: int) -> str | None:
        """Return the variable of the node that the statement on an offset's line is about."""
        statements = self.program.statements
        end = self.text.find(b"\n", offset)
        end = len(self.text) if end < 0 else end
        index = bisect_right(statements, end, key=lambda statement: statement.span.start) - 1
        if index < 0 or self.text.find(b"\n", statements[index].span.start, offset) >= 0:
            return None
        statement = statements[index]
        name = getattr(statement, "node", None) or getattr(statement, "variable", None)
        return name if name in self.workspace.nodes else None


def analyse(session: Session, check: Callable[[], None]) -> Analysis:
    """Find out what a program means.

    `check` is called now and then, and raises something when there is a newer text.
    """
    program = session.program
    check()
    session.interpret(check)
    workspace = session.workspace
    diagnostics = session.diagnostics
    check()
    counts = {**_counts(workspace), "problems": len(diagnostics)}
    return Analysis(session, session.document.text, program, workspace, diagnostics, counts)


def _counts(workspace: Workspace) -> dict[str, int]:
    """Return how many nodes, topics, services and messages there are."""
    topics: set[str] = set()
    services: set[str] = set()
    for node in workspace.nodes.values():
        for kind, found in node.by_kind.items():
            known = topics if kind.facts.interface is InterfaceKind.MESSAGE else services
            known.update(resolved_name(node.name, name) for name in found)
    return {
        "nodes": len(workspace.nodes),
        "topics": len(topics),
        "services": len(services),
        "messages": len(workspace.messages),
    }


def add_entries(analysis: Analysis, panel: str) -> None:
    """Make the entries of a panel, once."""
    if panel in analysis.entries:
        return
    session = analysis.session
    match panel:
        case "nodes":
            libraries = outline.libraries_of(analysis.workspace, session.library)
            made = outline.node_entries(analysis.workspace, libraries)
        case "topics":
            made = outline.topic_entries(analysis.graph)
        case "services":
            made = outline.service_entries(analysis.graph)
        case "messages":
            used: dict[str, list[str]] = {}
            for topic in analysis.graph.topics:
                for end in topic.tails:
                    for sending in end.sendings:
                        used.setdefault(sending.message, []).append(topic.name)
            made = outline.message_entries(analysis.workspace.messages, used)
        case "problems":
            made = outline.problem_entries(analysis.diagnostics, session.lines)
        case _:
            raise ValueError(panel)
    analysis.entries[panel] = made


def add_preview(analysis: Analysis, variable: str) -> None:
    """Make the files that a node becomes, once."""
    if variable not in analysis.previews:
        from .preview import previews_of

        analysis.previews[variable] = previews_of(analysis, variable)


def add_drawing(analysis: Analysis, size: Size | None = None) -> None:
    """Lay the graph out, once, and draw it so that it fits, once for each size."""
    if analysis.drawing is None:
        from .panels.picture import picture_of

        analysis.drawing = picture_of(analysis.graph)
    if size is not None:
        analysis.drawing.fitted(size)
