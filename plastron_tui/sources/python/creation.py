"""The statements that create an endpoint, in all the manners of holding one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .parameter_calls import VALUE_FIELDS, item_of
from .references import Reference, Use, Variable, references, statement_of, variable_of
from .splices import Splice, delete_item
from .syntax import parts_of

_USED_AT_ONCE = {
    EndpointKind.PUBLISHER: frozenset({"publish"}),
}
# What reads the value of a parameter of rclpy.
_READ = frozenset({"value", "get_parameter_value", *VALUE_FIELDS})
_SEQUENCES = frozenset({"pattern_list", "tuple_pattern", "list_pattern"})


@dataclass(slots=True)
class Removal:
    """What a removal deletes, or the lines that stand in its way.

    Attributes:
        statements: the statements that go.
        splices: what goes besides.
        sites: the call sites that go; with those asked for, timers of Plastron's own.
        lines: the lines that use the endpoint in a way that a removal cannot mend.
    """

    statements: list[Node] = field(default_factory=list)
    splices: list[Splice] = field(default_factory=list)
    sites: list[Site] = field(default_factory=list)
    lines: set[int] = field(default_factory=set)


def line_of(node: Node) -> int:
    """Return the line of a node, counted from 1."""
    return int(node.start_point.row) + 1


def parameters_in(analysis: Analysis, gone: Iterable[Splice]) -> list[Site]:
    """Return the parameters that are read in what is deleted: that is done no more."""
    return [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.PARAMETER
        and any(each.start <= site.call.start_byte < each.end for each in gone)
    ]


def remove_creation(analysis: Analysis, site: Site, removal: Removal) -> list[Variable]:
    """Remove the statement that creates an endpoint; return the variables that hold it."""
    if any(each.start_byte <= site.call.start_byte < each.end_byte for each in removal.statements):
        # As `set_param('~x', get_param('~x', 1))`.
        return []
    value, parent = site.call, site.call.parent
    if site.endpoint.kind is EndpointKind.PARAMETER:
        if (listed := item_of(analysis, site)) is not None:
            return _remove_listed(analysis, listed, removal)
        value = _value_read(analysis, site.call)
        parent = value.parent
    while parent is not None and parent.type == "parenthesized_expression":
        value, parent = parent, parent.parent
    if parent is None:
        return []
    if parent.type == "expression_statement" and parent.named_child_count == 1:
        removal.statements.append(parent)
        return []
    if parent.type == "attribute" and (chain := _chain(analysis, site, parent)) is not None:
        removal.statements.append(chain)
        return []
    if parent.type == "assignment":
        return _remove_assignment(analysis, parent, removal)
    if parent.type in ("expression_list", "tuple", "list"):
        return _remove_element(analysis, value, parent, removal)
    if parent.type == "argument_list" and _is_append(analysis, parent):
        return _remove_append(analysis, parent, removal)
    removal.lines.add(line_of(site.call))
    return []


def _remove_listed(analysis: Analysis, item: Node, removal: Removal) -> list[Variable]:
    """Remove one parameter of a list that is declared at once, or the call of the last."""
    assert item.parent is not None
    items = parts_of(item.parent)
    if len(items) > 1:
        removal.splices.append(delete_item(analysis.syntax.text, items, item))
        return []
    statement = statement_of(item)
    if statement.type == "expression_statement":
        removal.statements.append(statement)
    else:
        removal.lines.add(line_of(item))
    return []


def _value_read(analysis: Analysis, call: Node) -> Node:
    """Return the expression that is the value of a parameter: `get_parameter('x').value`."""
    value = call
    while (parent := value.parent) is not None:
        if parent.type == "attribute":
            name = parent.child_by_field_name("attribute")
            if name is None or analysis.syntax.slice(name) not in _READ:
                return value
        elif parent.type == "call":
            callee = parent.child_by_field_name("function")
            if callee is None or callee.id != value.id:
                return value
        else:
            return value
        value = parent
    return value


def _chain(analysis: Analysis, site: Site, attribute: Node) -> Node | None:
    """Return the statement of `Publisher(…).publish(…)`."""
    name = attribute.child_by_field_name("attribute")
    call = attribute.parent
    statement = call.parent if call is not None else None
    is_use = name is not None and analysis.syntax.slice(name) in _USED_AT_ONCE.get(
        site.endpoint.kind, ()
    )
    is_statement = (
        statement is not None
        and statement.type == "expression_statement"
        and statement.named_child_count == 1
        and call is not None
        and call.type == "call"
    )
    return statement if is_use and is_statement else None


def _remove_assignment(analysis: Analysis, assignment: Node, removal: Removal) -> list[Variable]:
    found = []
    outermost: Node | None = assignment
    while outermost is not None and outermost.type == "assignment":
        target = outermost.child_by_field_name("left")
        variable = variable_of(target, analysis) if target is not None else None
        if variable is None:
            removal.lines.add(line_of(assignment))
            return []
        found.append(variable)
        if outermost.parent is not None and outermost.parent.type == "expression_statement":
            removal.statements.append(outermost.parent)
            return found
        outermost = outermost.parent
    removal.lines.add(line_of(assignment))
    return []


def _remove_element(
    analysis: Analysis, value: Node, sequence: Node, removal: Removal
) -> list[Variable]:
    """Remove one of several values that a statement assigns to as many targets."""
    assignment = sequence.parent
    target = assignment.child_by_field_name("left") if assignment is not None else None
    text = analysis.syntax.text
    if assignment is None or target is None or assignment.type != "assignment":
        removal.lines.add(line_of(value))
        return []
    values = parts_of(sequence)
    if target.type not in _SEQUENCES:
        return _remove_from_list(analysis, value, values, target, removal)
    targets = parts_of(target)
    index = next(i for i, other in enumerate(values) if other.id == value.id)
    variable = variable_of(targets[index], analysis) if len(targets) == len(values) else None
    is_plain = len(values) > 1 and _unpack_alike(text, target, sequence, len(values))
    is_alone = assignment.parent is not None and assignment.parent.type == "expression_statement"
    if variable is None or not is_plain or not is_alone:
        removal.lines.add(line_of(value))
        return []
    siblings = [site.call.id for site in removal.sites]
    if all(other.id in siblings for other in values):
        removal.statements.append(assignment.parent)  # type: ignore[arg-type]
    else:
        removal.splices.append(delete_item(text, targets, targets[index]))
        removal.splices.append(delete_item(text, values, value))
    return [variable]


def _unpack_alike(text: bytes, target: Node, sequence: Node, count: int) -> bool:
    """Whether one target less and one value less still fit: of two, a single one is left."""
    if count > 2:
        return True
    is_list = [node.type in ("list", "list_pattern") for node in (target, sequence)]
    has_comma = [
        text[node.named_children[-1].end_byte : node.end_byte].lstrip().startswith(b",")
        for node in (target, sequence)
    ]
    return is_list[0] == is_list[1] and (is_list[0] or has_comma[0] == has_comma[1])


def _remove_from_list(
    analysis: Analysis, value: Node, values: list[Node], target: Node, removal: Removal
) -> list[Variable]:
    """Remove an item of a list that only keeps its items alive."""
    variable = variable_of(target, analysis)
    is_kept = variable is not None and all(
        reference.use in (Use.BINDING, Use.NOTHING) for reference in references(variable, analysis)
    )
    is_tuple = value.parent is not None and value.parent.type != "list"
    if not is_kept or (is_tuple and len(values) < 3):
        removal.lines.add(line_of(value))
        return []
    removal.splices.append(delete_item(analysis.syntax.text, values, value))
    return []


def _is_append(analysis: Analysis, arguments: Node) -> bool:
    call = arguments.parent
    callee = call.child_by_field_name("function") if call is not None else None
    name = callee.child_by_field_name("attribute") if callee is not None else None
    return (
        name is not None
        and analysis.syntax.slice(name) == "append"
        and arguments.named_child_count == 1
        and call is not None
        and call.parent is not None
        and call.parent.type == "expression_statement"
    )


def _remove_append(analysis: Analysis, arguments: Node, removal: Removal) -> list[Variable]:
    """Remove `items.append(…)` where no item is taken from the list by its place."""
    statement = statement_of(arguments)
    callee = arguments.parent.child_by_field_name("function") if arguments.parent else None
    holder = callee.child_by_field_name("object") if callee is not None else None
    variable = variable_of(holder, analysis) if holder is not None else None
    if variable is None:
        removal.lines.add(line_of(arguments))
        return []
    others = [
        reference
        for reference in references(variable, analysis)
        if reference.use is Use.OTHER and not _is_append_reference(analysis, reference)
    ]
    if others:
        removal.lines.update(line_of(reference.node) for reference in others)
    removal.statements.append(statement)
    return []


def _is_append_reference(analysis: Analysis, reference: Reference) -> bool:
    attribute = reference.node.parent
    call = attribute.parent if attribute is not None else None
    arguments = call.child_by_field_name("arguments") if call is not None else None
    return arguments is not None and _is_append(analysis, arguments)
