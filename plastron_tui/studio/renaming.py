"""Renaming a node, a message, a topic or a service everywhere in a program."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from plastron_tui.diagnostics import Edit
from plastron_tui.language import DECLARATIONS, Document, Program, SlotKind
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import CreateNode
from plastron_tui.model.kinds import EDITABLE, Endpoint, EndpointKind
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import (
    check_node_name,
    check_service_name,
    check_topic_name,
    resolved_name,
    spelled,
)
from plastron_tui.targets import ros_version

from .analysis import Analysis
from .editor.names import wrong_name as wrong_variable
from .insertion_point import placed
from .panels.entry import Entry, Subject

_TOPICS = (
    Subject.TOPIC,
    *(kind for kind in EDITABLE if kind.facts.interface is InterfaceKind.MESSAGE),
)


@dataclass(frozen=True, slots=True)
class Renamed:
    """What gives something another name.

    Attributes:
        edits: the edits of the program.
        files: files that keep the old name: no statement can change it there.
    """

    edits: tuple[Edit, ...] = ()
    files: tuple[str, ...] = ()


def old_name(entry: Entry, workspace: Workspace) -> str:
    """Return the name that is changed: of a node that a file names, its variable."""
    node = workspace.nodes.get(entry.node or "")
    if entry.subject is Subject.NODE and node is not None and node.source is None:
        return node.name
    return entry.name or ""


def renamed(analysis: Analysis, entry: Entry, new: str) -> Renamed:
    """Return what gives the thing that an entry is about another name."""
    workspace, program = analysis.workspace, analysis.program
    old = old_name(entry, workspace)
    if entry.subject is Subject.NODE:
        node = workspace.nodes[entry.node or ""]
        return Renamed(tuple(_node(analysis, node, new)))
    if entry.subject is Subject.MESSAGE:
        return Renamed(tuple(_variable(program, old, new)))
    edits = tuple(_written(program, entry, old, new))
    more, files = _in_files(analysis, entry.subject in _TOPICS, old, entry.node, new)
    return Renamed((*edits, *more), files)


def _node(analysis: Analysis, node: Node, new: str) -> Iterator[Edit]:
    """Rename a node, and its variable where that is the same word; of a file's the variable."""
    if node.source is None:
        for statement in analysis.program.statements:
            if isinstance(statement, CreateNode) and statement.variable == node.variable:
                yield Edit(statement.span_of("name"), f"'{new}'")
        if node.name != node.variable or _wrong_variable(analysis, new) is not None:
            return
    yield from _variable(analysis.program, node.variable, new)


def _variable(program: Program, old: str, new: str) -> Iterator[Edit]:
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind.is_variable and getattr(statement, slot.name) == old:
                yield Edit(statement.span_of(slot.name), new)


def _written(program: Program, entry: Entry, old: str, new: str) -> Iterator[Edit]:
    """Rename a topic or a service: by its full name, and by its name as it is written."""
    kind = SlotKind.TOPIC if entry.subject in _TOPICS else SlotKind.SERVICE
    same = {old, old.lstrip("/"), resolved_name(entry.node or "", old)}
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind is kind and spelled(getattr(statement, slot.name)) in same:
                yield Edit(statement.span_of(slot.name), f"'{new}'")


def _in_files(
    analysis: Analysis, is_topic: bool, old: str, of: str | None, new: str
) -> tuple[list[Edit], tuple[str, ...]]:
    """Rename what loaded files have: by a statement that ends it and one that makes it anew."""
    full = resolved_name(of or "", old)
    edits = []
    files: dict[str, None] = {}
    for node in analysis.workspace.nodes.values():
        if node.source is None:
            continue
        lines: list[str] = []
        for (kind, name), endpoint in node.endpoints.items():
            if endpoint.span is not None or (kind in _TOPICS) != is_topic:
                continue
            if resolved_name(node.name, name) != full:
                continue
            # What is sent is in the file's own code, which no statement can carry over.
            if kind.facts.sends or endpoint.type is None or "'" in name:
                files[node.source.path.name] = None
            else:
                lines += _under_another_name(node, kind, endpoint, new)
        if lines:
            edits.append(placed(analysis.ground, node.variable, lines).edit)
    return edits, tuple(files)


def _under_another_name(
    node: Node, kind: EndpointKind, endpoint: Endpoint, new: str
) -> Iterator[str]:
    """Yield the statements that end what a file has under a name, and make it anew."""
    editing = kind.editing
    yield sentence(editing.ending, {"node": node.variable, editing.name_slot: endpoint.name})
    texts = {"node": node.variable, editing.name_slot: new, "type": str(endpoint.type)}
    callback = getattr(endpoint, "callback", None) or ""
    yield sentence(editing.making, {**texts, "function": callback})


def _wrong_variable(analysis: Analysis, new: str) -> str | None:
    workspace = analysis.workspace
    if new in workspace.nodes or new in workspace.messages:
        return f"`{new}` is a variable already"
    return wrong_variable(Document(b""), new)


def wrong_name(analysis: Analysis, entry: Entry, new: str) -> str | None:
    """Return why something cannot have a name, None when it can."""
    nodes = analysis.workspace.nodes
    node = nodes.get(entry.node or "")
    is_variable = entry.subject is Subject.MESSAGE
    if entry.subject is Subject.NODE:
        is_variable = node is not None and node.source is not None
    if is_variable:
        return _wrong_variable(analysis, new)
    library = node.library if node is not None and node.library else analysis.session.library
    version = ros_version(library)
    if entry.subject is Subject.NODE:
        if any(each.name == new for each in nodes.values()):
            return f"a node `{new}` exists already"
        problem = check_node_name(new, version)
    else:
        check = check_topic_name if entry.subject in _TOPICS else check_service_name
        problem = check(new, version)
    return None if problem is None else problem.message
