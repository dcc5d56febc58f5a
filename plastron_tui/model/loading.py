"""From what a reader found in a file to a node of the workspace."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes, guess, write
from plastron_tui.diagnostics.wording import listed
from plastron_tui.language.statements import Load
from plastron_tui.ros.parameters import ParameterType, as_setting
from plastron_tui.ros.qos import common

from .endpoint_details import ParameterDetails, TimerDetails
from .kinds import EndpointKind, Parameter, Publisher, Rate, Subscription, Timer
from .source import SourceEndpoint, SourceUnit
from .workspace import Node


def node_in(source: SourceUnit, statement: Load) -> SourceUnit | Diagnostic:
    """Return a file with the one node that a statement means, or say which there are.

    A file that makes no node is taken as it is: its call sites are of a node that another makes.
    """
    if statement.name is None and len(source.nodes) < 2:
        return source
    labels = list(dict.fromkeys(node.label for node in source.nodes if node.label))
    shown = listed(f"`{label}`" for label in labels)
    if statement.name is None:
        where = statement.span_of("source")
        example = f"node '{labels[0]}' " if labels else ""
        return Diagnostic(
            codes.SEVERAL_NODES,
            f"`{source.path.name}` holds {len(source.nodes)} nodes: {shown}",
            where,
            help=f"say which one: `load … {example}as {statement.variable}`",
        )
    if [node.label for node in source.nodes].count(statement.name) > 1:
        return Diagnostic(
            codes.SEVERAL_NODES,
            f"`{source.path.name}` holds several nodes that are called `{statement.name}`",
            statement.span_of("name"),
            help="give each a name of its own in the file",
        )
    if statement.name not in labels:
        where = statement.span_of("name")
        remedy, fix = guess(statement.name, labels, where, is_quoted=True)
        if fix is None and len(labels) == 1:
            fix = write(f"'{labels[0]}'", where)
        return Diagnostic(
            codes.NODE_NOT_FOUND,
            f"`{source.path.name}` has no node `{statement.name}`",
            where,
            help=remedy or (f"there are {shown}" if labels else "the file names none"),
            fix=fix,
        )
    return source.only(statement.name)


def loaded_node(source: SourceUnit, statement: Load) -> Node:
    """Make a node of a file's endpoints; those whose name the file does not say stay unseen."""
    name = next((node.name for node in source.nodes if node.name is not None), source.path.stem)
    is_managed = any(node.is_managed for node in source.nodes)
    loaded = Node(
        name,
        statement.variable,
        statement.span,
        source.library,
        source,
        is_managed=is_managed,
    )
    for endpoint in source.endpoints:
        if endpoint.label is not None:
            add_found(loaded, endpoint, endpoint.label)
    return loaded


def add_found(node: Node, found: SourceEndpoint, name: str) -> None:
    """Add what a file has to a node; what the node has already stays, with what is true of both."""
    editing = found.kind.facts.editing
    if editing is None:
        return
    there = node.by_kind[found.kind].get(name)
    if there is not None:
        if isinstance(there, Publisher | Subscription):
            node.put(there._replace(qos=common((there.qos, found.qos))))
        elif isinstance(there, Parameter) and isinstance(found.details, ParameterDetails):
            node.put(_agreed(there, _parameter(name, found.details)))
        return
    match found.details:
        case ParameterDetails() as details:
            node.put(_parameter(name, details))
            return
        case TimerDetails(period=period):
            node.put(Timer(name, None, Rate(1 / period) if period else None))
            return
    if found.kind in (EndpointKind.PARAMETER, EndpointKind.TIMER):
        node.put(editing.endpoint(name))
        return
    given: dict[str, object] = {"callback": found.callback} if found.kind.facts.calls_back else {}
    if found.qos is not None:
        given["qos"] = found.qos
    node.put(editing.endpoint(name, found.type, **given))


def _parameter(name: str, details: ParameterDetails) -> Parameter:
    types = {each.value: each for each in ParameterType}
    type_ = types.get(details.type or "")
    default = None if type_ is None else as_setting(type_, details.default)
    low, high = (None, None) if details.range is None else details.range[:2]
    return Parameter(name, None, type_, default, low, high, details.description or "")


def _agreed(one: Parameter, other: Parameter) -> Parameter:
    """Return what two calls say of a parameter, and nothing of what they disagree about."""
    pairs = zip(one, other, strict=True)
    found = (a if b in (None, "") else b if a in (None, "", b) else None for a, b in pairs)
    agreed = Parameter._make(found)
    return agreed._replace(description=agreed.description or "")
