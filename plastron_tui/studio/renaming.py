"""Renaming a node, a message, a parameter, or what nodes meet at, everywhere in a program."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from tree_sitter import Query, QueryCursor

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.language import DECLARATIONS, Document, Program, SlotKind
from plastron_tui.language.grammar import LANGUAGE
from plastron_tui.language.statements import (
    CreateLaunch,
    CreateNode,
    CreatePackage,
    CreateRobot,
)
from plastron_tui.model.kinds import INTERFACES, EndpointKind, Parameter
from plastron_tui.model.source import place_of
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import (
    check_node_name,
    check_parameter_name,
    check_service_name,
    check_topic_name,
    parameter_name,
)
from plastron_tui.targets import ros_version

from .analysis import Analysis
from .editor.names import wrong_name as wrong_variable
from .editor.robot_parts import Part, find_part, kept_name, wrong_part_name, wrong_robot_name
from .name_edits import edits_of_files, function_edits, parameter_edits, written_edits
from .panels.entry import Entry, Subject
from .panels.entry_signs import HUBS

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
    if entry.subject is Subject.FUNCTION:
        return Renamed(tuple(function_edits(program, entry.node or "", old, new)))
    if entry.subject is EndpointKind.PARAMETER:
        return Renamed(tuple(parameter_edits(analysis, entry.node or "", old, new)))
    interface = _interface_of(entry)
    owner = workspace.nodes.get(entry.node or "")
    of = "" if owner is None else owner.name
    edits = tuple(written_edits(program, entry, interface, old, new))
    more, files = edits_of_files(analysis, interface, old, of, new)
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
    if entry.subject is Subject.FUNCTION:
        return _file_with(analysis.workspace.nodes.get(entry.node or ""), entry.text)
    part = _part_of(entry)
    return None if part is None else kept_name(part, analysis.workspace.robots.get(part.robot))


def _file_with(node: Node | None, function: str) -> str | None:
    """Say that a function is in the file of a node, None where it is not."""
    if node is None or node.source is None:
        return None
    word = re.compile(rb"\b%b\b" % re.escape(function.encode()))
    files = node.source.files.texts
    found = next((name for name, text in files if word.search(text)), None)
    if found is None:
        return None
    file = place_of(node.source.path, found).name
    return f"`{function}` is a function of {file}: rename it there"


def _wrong_function(analysis: Analysis, entry: Entry, new: str) -> str | None:
    """Return why a function cannot have a name, None when it can."""
    if not (new.isascii() and new.isidentifier()):
        return f"`{new}` is no function: it has letters, digits and `_`, a letter first"
    if any(True for _ in function_edits(analysis.program, entry.node or "", new, new)):
        return f"`{entry.node}` has a function `{new}` already"
    return None


def wrong_name(analysis: Analysis, entry: Entry, new: str) -> str | None:
    """Return why something cannot have a name, None when it can."""
    nodes = analysis.workspace.nodes
    node = nodes.get(entry.node or "")
    if entry.subject in _MADE:
        return _wrong_made(analysis, entry, new)
    if entry.subject is Subject.FUNCTION:
        return _wrong_function(analysis, entry, new)
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
