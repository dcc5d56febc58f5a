"""What gives a function, a parameter, or what nodes meet at another name: edits of a program."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from tree_sitter import Query, QueryCursor

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.language import DECLARATIONS, Program, SlotKind
from plastron_tui.language.declaration import Statement
from plastron_tui.language.grammar import LANGUAGE
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import CreateMessage, Publish, Rename
from plastron_tui.model.kinds import EndpointKind, Parameter
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import parameter_name, resolved_name, spelled
from plastron_tui.targets import ros_version

from .analysis import Analysis
from .panels.entry import Entry

_SLOTS = {
    InterfaceKind.MESSAGE: (SlotKind.TOPIC, SlotKind.TRIGGER),
    InterfaceKind.SERVICE: (SlotKind.SERVICE,),
    InterfaceKind.ACTION: (SlotKind.ACTION,),
}
"""The slots that have the name of what nodes meet at."""

_CALLED = frozenset({SlotKind.FUNCTION, SlotKind.TIMER})


def function_edits(program: Program, variable: str, old: str, new: str) -> Iterator[Edit]:
    """Rename a function of a node, wherever statements have it called."""
    for statement in program.statements:
        if getattr(statement, "node", None) != variable:
            continue
        for slot in DECLARATIONS[type(statement)].slots:
            if slot.kind in _CALLED and getattr(statement, slot.name) == old:
                yield Edit(statement.span_of(slot.name), new)


def parameter_edits(analysis: Analysis, variable: str, old: str, new: str) -> Iterator[Edit]:
    """Rename a parameter of a node, and of those that send the same messages with it."""
    program, workspace = analysis.program, analysis.workspace
    nodes, messages = _sharing(program, variable, old)
    for each in nodes:
        node = workspace.nodes.get(each)
        name = "" if node is None else _own_name(analysis, node, old)
        found = None if node is None else node.of(Parameter).get(name)
        if node is not None and found is not None and found.span is None:
            # Its file has it.
            yield _renaming(analysis, node, (EndpointKind.PARAMETER, name), old, new)
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


def written_edits(
    program: Program, entry: Entry, interface: InterfaceKind, old: str, new: str
) -> Iterator[Edit]:
    """Rename what nodes meet at: by its full name, and by its name as it is written."""
    kinds = _SLOTS[interface]
    same = {old, old.lstrip("/"), resolved_name(entry.node or "", old)}
    is_private = spelled(old).startswith("~")
    for statement in program.statements:
        for slot in DECLARATIONS[type(statement)].slots:
            if is_private and getattr(statement, "node", None) != entry.node:
                continue
            name = getattr(statement, slot.name) if slot.kind in kinds else None
            if name is not None and spelled(name) in same:
                yield Edit(statement.span_of(slot.name), f"'{new}'")


def edits_of_files(
    analysis: Analysis, interface: InterfaceKind, old: str, of: str, new: str
) -> tuple[list[Edit], tuple[str, ...]]:
    """Rename what loaded files have: by the statement that renames it already, or by a new one.

    A private name is that of the node `of`, by its name in ROS.
    """
    full = resolved_name(of, old)
    edits: dict[Edit, None] = {}
    files: dict[str, None] = {}
    for node in analysis.workspace.nodes.values():
        if node.source is None:
            continue
        for (kind, name), endpoint in node.endpoints.items():
            if endpoint.span is not None or kind.facts.interface is not interface:
                continue
            if resolved_name(node.name, name) != full:
                continue
            if "'" in name:
                files[node.source.path.name] = None
            else:
                edits[_renaming(analysis, node, (kind, name), name, new)] = None
    return list(edits), tuple(files)


def _renaming(
    analysis: Analysis, node: Node, key: tuple[EndpointKind, str], old: str, new: str
) -> Edit:
    """Return what gives something of a loaded file another name.

    Args:
        analysis: the program.
        node: the node that was loaded.
        key: its kind and name.
        old: the name as a program writes it.
        new: the name that it gets.
    """
    kind, _ = key
    before = node.renamed.get(key)
    if before is not None:
        statement = next(
            each
            for each in analysis.program.statements
            if isinstance(each, Rename) and each.span == before.span
        )
        return Edit(statement.span_of("new"), f"'{new}'")
    what = "parameter" if kind is EndpointKind.PARAMETER else kind.facts.named or ""
    texts = {"node": node.variable, "what": what, "old": old, "new": new}
    return _below(analysis, node.span, sentence(DECLARATIONS[Rename], texts))


def _below(analysis: Analysis, span: Span, line: str) -> Edit:
    """Return what writes a line below a statement: all that follows finds the new name."""
    text = analysis.ground.document.text
    end = text.find(b"\n", span.end)
    end = len(text) if end < 0 else end
    end -= text[:end].endswith(b"\r")
    return Edit(Span(end, end), f"\n{line}")
