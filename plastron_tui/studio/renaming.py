"""Renaming a node, a message, a parameter, or what nodes meet at, everywhere in a program."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

from tree_sitter import Query, QueryCursor

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.language import DECLARATIONS, Document, Program, SlotKind
from plastron_tui.language.declaration import Statement
from plastron_tui.language.grammar import LANGUAGE
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import (
    CreateLaunch,
    CreateMessage,
    CreateNode,
    CreatePackage,
    CreateRobot,
    Publish,
    Rename,
)
from plastron_tui.model.kinds import INTERFACES, Endpoint, EndpointKind, Parameter
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import (
    check_node_name,
    check_parameter_name,
    check_service_name,
    check_topic_name,
    parameter_name,
    resolved_name,
    spelled,
)
from plastron_tui.targets import ros_version

from .analysis import Analysis
from .editor.names import wrong_name as wrong_variable
from .editor.robot_parts import Part, find_part, kept_name, wrong_part_name, wrong_robot_name
from .insertion_point import placed
from .panels.entry import Entry, Subject
from .panels.entry_signs import HUBS

_SLOTS = {
    InterfaceKind.MESSAGE: (SlotKind.TOPIC, SlotKind.TRIGGER),
    InterfaceKind.SERVICE: (SlotKind.SERVICE,),
    InterfaceKind.ACTION: (SlotKind.ACTION,),
}
"""The slots that have the name of what nodes meet at."""

_MADE = (Subject.PACKAGE, Subject.LAUNCH, Subject.ROBOT)
"""What has both a name and a variable, as nodes have."""

_MAKING = (CreatePackage, CreateLaunch, CreateRobot)


def _interface_of(entry: Entry) -> InterfaceKind:
    """Return the kind of interface of what an entry about a meeting is about."""
    subject = entry.subject
    if isinstance(subject, EndpointKind):
        assert subject.facts.interface is not None
        return subject.facts.interface
    return next(interface for interface, each in HUBS.items() if each is subject)


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
    if entry.subject in _MADE:
        return _made_name(workspace, entry)
    return entry.name or ""


def _made_name(workspace: Workspace, entry: Entry) -> str:
    """Return the name of a package, a launch file or a robot; of a loaded one its variable."""
    variable = entry.name or ""
    kinds = (workspace.packages, workspace.launches, workspace.robots)
    found = next((each[variable] for each in kinds if variable in each), None)
    if found is None or getattr(found, "source", None) is not None:
        return variable
    return found.name


def renamed(analysis: Analysis, entry: Entry, new: str) -> Renamed:
    """Return what gives the thing that an entry is about another name."""
    workspace, program = analysis.workspace, analysis.program
    old = old_name(entry, workspace)
    if entry.subject is Subject.NODE:
        node = workspace.nodes[entry.node or ""]
        return Renamed(tuple(_node(analysis, node, new)))
    if entry.subject is Subject.MESSAGE:
        return Renamed(tuple(_variable(program, old, new)))
    if entry.subject in _MADE:
        return Renamed(tuple(_made(analysis, entry, new)))
    part = _part_of(entry)
    if part is not None:
        found = find_part(analysis.ground.document, part)
        return Renamed(tuple(Edit(place, new) for place in found.places))
    if entry.subject is Subject.TYPE:
        return Renamed(tuple(_own_type(program, old, new)))
    if entry.subject is EndpointKind.PARAMETER:
        return Renamed(tuple(_parameter(analysis, entry.node or "", old, new)))
    interface = _interface_of(entry)
    edits = tuple(_written(program, entry, interface, old, new))
    more, files = _in_files(analysis, interface, old, entry.node, new)
    return Renamed((*edits, *more), files)


def _part_of(entry: Entry) -> Part | None:
    """Return the link or the joint that an entry is about, None for any other entry."""
    if entry.subject not in (Subject.LINK, Subject.JOINT):
        return None
    return Part(entry.robot or "", entry.subject.word, entry.text)


def _node(analysis: Analysis, node: Node, new: str) -> Iterator[Edit]:
    """Rename a node, and its variable where that is the same word; of a file's the variable."""
    if node.source is None:
        for statement in analysis.program.statements:
            if isinstance(statement, CreateNode) and statement.variable == node.variable:
                yield Edit(statement.span_of("name"), f"'{new}'")
        if node.name != node.variable or _wrong_variable(analysis, new) is not None:
            return
    yield from _variable(analysis.program, node.variable, new)


def _made(analysis: Analysis, entry: Entry, new: str) -> Iterator[Edit]:
    """Rename a package, a launch file or a robot, and its variable if that is the same word."""
    variable = entry.name or ""
    old = _made_name(analysis.workspace, entry)
    is_created = False
    for statement in analysis.program.statements:
        if isinstance(statement, _MAKING) and statement.variable == variable:
            is_created = True
            yield Edit(statement.span_of("name"), f"'{new}'")
    if is_created and (old != variable or _wrong_variable(analysis, new) is not None):
        return
    yield from _variable(analysis.program, variable, new)


_TYPES = frozenset({*INTERFACES, SlotKind.TYPE_NAME, SlotKind.NEW_TYPE, SlotKind.OWN_TYPE})


def _own_type(program: Program, old: str, new: str) -> Iterator[Edit]:
    """Rename a type of the program, wherever it is named."""
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            held = getattr(statement, slot.name)
            if slot.kind in _TYPES and held == old:
                yield Edit(statement.span_of(slot.name), new)
            elif slot.kind is SlotKind.FIELDS:
                for field in held:
                    for node in QueryCursor(_type_names()).captures(field.syntax).get("type", []):
                        if node.text == old.encode():
                            span = Span(node.start_byte, node.end_byte)
                            yield Edit(span.moved(statement.shift), new)


@cache
def _type_names() -> Query:
    return Query(LANGUAGE, "(definition type: (definition_type (type) @type))")


def _variable(program: Program, old: str, new: str) -> Iterator[Edit]:
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind.is_variable and getattr(statement, slot.name) == old:
                yield Edit(statement.span_of(slot.name), new)


def _parameter(analysis: Analysis, variable: str, old: str, new: str) -> Iterator[Edit]:
    """Rename a parameter of a node, and of those that send the same messages with it."""
    program, workspace = analysis.program, analysis.workspace
    nodes, messages = _sharing(program, variable, old)
    for each in nodes:
        node = workspace.nodes.get(each)
        found = None if node is None else node.of(Parameter).get(_own_name(analysis, node, old))
        if node is not None and found is not None and found.span is None:
            # Its file has it.
            renames = DECLARATIONS[Rename]
            texts = {"node": each, "what": "parameter", "old": old, "new": new}
            yield placed(analysis.ground, each, [sentence(renames, texts)]).edit
    for statement in program.statements:
        is_own = getattr(statement, "node", None) in nodes
        if is_own or (isinstance(statement, CreateMessage) and statement.variable in messages):
            yield from (Edit(span, f"'{new}'") for span in _parameter_spans(statement, old))


def _own_name(analysis: Analysis, node: Node, name: str) -> str:
    return parameter_name(name, ros_version(node.library or analysis.session.library))


def _sharing(program: Program, variable: str, name: str) -> tuple[set[str], set[str]]:
    """Return the nodes that have a parameter by one name, and the messages that say it."""
    using = {
        each.variable
        for each in program.statements
        if isinstance(each, CreateMessage) and any(_parameter_spans(each, name))
    }
    sent = [
        (each.node, each.message)
        for each in program.statements
        if isinstance(each, Publish) and each.message in using
    ]
    nodes, messages, count = {variable}, set[str](), 0
    while count < len(nodes):
        count = len(nodes)
        messages |= {message for node, message in sent if node in nodes}
        nodes |= {node for node, message in sent if message in messages}
    return nodes, messages


@cache
def _parameters() -> Query:
    return Query(LANGUAGE, "(parameter name: (_) @name)")


def _parameter_spans(statement: Statement, name: str) -> Iterator[Span]:
    """Yield where a statement has the name of a parameter: as a slot, and in values."""
    type_: Any = type(statement)  # which mypy takes for not hashable
    for slot in DECLARATIONS[type_].slots:
        if slot.kind is SlotKind.PARAMETER and getattr(statement, slot.name) == name:
            yield statement.span_of(slot.name)
    for node in QueryCursor(_parameters()).captures(statement.syntax).get("name", []):
        if node.text == f"'{name}'".encode():
            yield Span(node.start_byte, node.end_byte).moved(statement.shift)


def _written(
    program: Program, entry: Entry, interface: InterfaceKind, old: str, new: str
) -> Iterator[Edit]:
    """Rename what nodes meet at: by its full name, and by its name as it is written."""
    kinds = _SLOTS[interface]
    same = {old, old.lstrip("/"), resolved_name(entry.node or "", old)}
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            name = getattr(statement, slot.name) if slot.kind in kinds else None
            if name is not None and spelled(name) in same:
                yield Edit(statement.span_of(slot.name), f"'{new}'")


def _in_files(
    analysis: Analysis, interface: InterfaceKind, old: str, of: str | None, new: str
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
            if endpoint.span is not None or kind.facts.interface is not interface:
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
    if workspace.what(new) is not None:
        return f"`{new}` is a variable already"
    return wrong_variable(Document(b""), new)


def _wrong_made(analysis: Analysis, entry: Entry, new: str) -> str | None:
    """Return why a package, a launch file or a robot cannot have a name, None when it can."""
    workspace = analysis.workspace
    found = workspace.packages.get(entry.name or "") or workspace.robots.get(entry.name or "")
    if found is not None and found.source is not None:
        return _wrong_variable(analysis, new)
    if _made_name(workspace, entry) == entry.name and workspace.what(new) is not None:
        return f"`{new}` is a variable already"
    if new in _made_names(workspace, entry.subject):
        return f"a {entry.subject.word} `{new}` exists already"
    if entry.subject is Subject.ROBOT:
        return wrong_robot_name(new)
    return "a name has no single quote" if "'" in new else None


def _made_names(workspace: Workspace, subject: Subject | EndpointKind) -> set[str]:
    """Return the names of all packages, launch files or robots."""
    if subject is Subject.PACKAGE:
        return {each.name for each in workspace.packages.values()}
    if subject is Subject.LAUNCH:
        return {each.name for each in workspace.launches.values()}
    return {each.name for each in workspace.robots.values()}


def fixed_name(analysis: Analysis, entry: Entry) -> str | None:
    """Return why something keeps the name that it has, None when it can have another one."""
    part = _part_of(entry)
    return None if part is None else kept_name(part, analysis.workspace.robots.get(part.robot))


def wrong_name(analysis: Analysis, entry: Entry, new: str) -> str | None:
    """Return why something cannot have a name, None when it can."""
    nodes = analysis.workspace.nodes
    node = nodes.get(entry.node or "")
    if entry.subject in _MADE:
        return _wrong_made(analysis, entry, new)
    part = _part_of(entry)
    if part is not None:
        robot = analysis.workspace.robots.get(part.robot)
        return wrong_part_name(analysis.ground.document, part, new, robot)
    if entry.subject is Subject.TYPE:
        is_name = all(part.isascii() and part.isidentifier() for part in new.split("/"))
        if new in analysis.workspace.types:
            return f"a type `{new}` exists already"
        return None if is_name else "a type has letters and digits, and a capital first"
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
    elif entry.subject is EndpointKind.PARAMETER:
        if node is not None and parameter_name(new, version) in node.of(Parameter):
            return f"`{entry.node}` has a parameter `{new}` already"
        problem = check_parameter_name(new, version)
    else:
        is_topic = _interface_of(entry) is InterfaceKind.MESSAGE
        problem = (check_topic_name if is_topic else check_service_name)(new, version)
    return None if problem is None else problem.message
