"""Taking an endpoint out of a file: its statements, its stub callback, its type's import."""

from __future__ import annotations

from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind, Remove

from .generated import is_calling_function, is_own_call, is_publishing_function, is_stub
from .imports import unused_imports
from .references import (
    Reference,
    Use,
    Variable,
    identifiers,
    is_member,
    references,
    statement_of,
    variable_of,
)
from .scopes import BindingKind, Scope
from .sites import Analysis, Site, callback_target
from .splices import Splice, delete_item, delete_statements

_USED_AT_ONCE = {
    EndpointKind.PUBLISHER: frozenset({"publish"}),
}
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


def find_sites(analysis: Analysis, change: Remove) -> list[Site]:
    """Return the call sites of the endpoint that a change names."""
    of_kind = [site for site in analysis.sites if site.endpoint.kind is change.kind]
    named = [site for site in of_kind if site.endpoint.name == change.name]
    return named or [site for site in of_kind if site.endpoint.default == change.name]


def plan_removal(analysis: Analysis, sites: list[Site]) -> Removal:
    """Plan what taking some call sites of one endpoint out of a file deletes."""
    removal = Removal(sites=list(sites))
    variables: dict[Variable, None] = {}
    for site in sites:
        for variable in _remove_creation(analysis, site, removal):
            variables[variable] = None
    for variable in variables:
        _remove_uses(analysis, variable, sites, removal)
    if removal.lines:
        return removal
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    callbacks = _stub_callbacks(analysis, removal.sites, gone)
    removal.statements += callbacks
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    removal.splices = gone + unused_imports(analysis, gone)
    removal.statements = []
    return removal


def _line(node: Node) -> int:
    return int(node.start_point.row) + 1


def _remove_creation(analysis: Analysis, site: Site, removal: Removal) -> list[Variable]:
    """Remove the statement that creates an endpoint; return the variables that hold it."""
    value, parent = site.call, site.call.parent
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
    removal.lines.add(_line(site.call))
    return []


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
            removal.lines.add(_line(assignment))
            return []
        found.append(variable)
        if outermost.parent is not None and outermost.parent.type == "expression_statement":
            removal.statements.append(outermost.parent)
            return found
        outermost = outermost.parent
    removal.lines.add(_line(assignment))
    return []


def _remove_element(
    analysis: Analysis, value: Node, sequence: Node, removal: Removal
) -> list[Variable]:
    """Remove one of several values that a statement assigns to as many targets."""
    assignment = sequence.parent
    target = assignment.child_by_field_name("left") if assignment is not None else None
    text = analysis.syntax.text
    if assignment is None or target is None or assignment.type != "assignment":
        removal.lines.add(_line(value))
        return []
    values = [child for child in sequence.named_children if child.type != "comment"]
    if target.type not in _SEQUENCES:
        return _remove_from_list(analysis, value, values, target, removal)
    targets = [child for child in target.named_children if child.type != "comment"]
    index = next(i for i, other in enumerate(values) if other.id == value.id)
    variable = variable_of(targets[index], analysis) if len(targets) == len(values) else None
    is_plain = len(values) > 1 and _brackets(text, target) == _brackets(text, sequence)
    is_alone = assignment.parent is not None and assignment.parent.type == "expression_statement"
    if variable is None or not is_plain or not is_alone:
        removal.lines.add(_line(value))
        return []
    siblings = [site.call.id for site in removal.sites]
    if all(other.id in siblings for other in values):
        removal.statements.append(assignment.parent)  # type: ignore[arg-type]
    else:
        removal.splices.append(delete_item(text, targets, targets[index]))
        removal.splices.append(delete_item(text, values, value))
    return [variable]


def _brackets(text: bytes, node: Node) -> bytes:
    first = text[node.start_byte : node.start_byte + 1]
    has_brackets = node.type not in ("pattern_list", "expression_list")
    return first if has_brackets else b""


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
        removal.lines.add(_line(value))
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
        removal.lines.add(_line(arguments))
        return []
    others = [
        reference
        for reference in references(variable, analysis)
        if reference.use is Use.OTHER and not _is_append_reference(analysis, reference)
    ]
    if others:
        removal.lines.update(_line(reference.node) for reference in others)
    removal.statements.append(statement)
    return []


def _is_append_reference(analysis: Analysis, reference: Reference) -> bool:
    attribute = reference.node.parent
    call = attribute.parent if attribute is not None else None
    arguments = call.child_by_field_name("arguments") if call is not None else None
    return arguments is not None and _is_append(analysis, arguments)


def _remove_uses(
    analysis: Analysis, variable: Variable, sites: list[Site], removal: Removal
) -> None:
    """Remove what only publishes on a variable; note the lines of every other use."""
    created = {statement.id for statement in removal.statements}
    cut = [splice for splice in removal.splices if not splice.text]
    publishing: list[Reference] = []
    rebound: set[int] = set()
    uses = references(variable, analysis)
    if sites[0].endpoint.kind is EndpointKind.CLIENT:
        uses = _remove_calling(analysis, uses, removal)
    for reference in uses:
        if reference.statement.id in created or any(
            splice.start <= reference.node.start_byte < splice.end for splice in cut
        ):
            continue
        if reference.use is Use.PUBLISH:
            publishing.append(reference)
        elif reference.use is Use.BARE or is_own_call(analysis, reference):
            removal.statements.append(reference.statement)
        elif reference.use is Use.BINDING:
            rebound.add(_line(reference.node))
        elif reference.use is not Use.NOTHING:
            removal.lines.add(_line(reference.node))
    # What the variable holds besides matters only where something is done with it.
    removal.lines |= rebound if publishing or removal.lines else set()
    calls = {site.call.id for site in sites}
    for reference in publishing:
        inside = [
            site
            for site in analysis.sites
            if site.call.id not in calls
            and reference.statement.start_byte
            <= site.call.start_byte
            < reference.statement.end_byte
        ]
        if inside:
            removal.lines.add(_line(reference.node))
    _remove_publishing(analysis, variable, publishing, removal)


def _remove_calling(analysis: Analysis, uses: list[Reference], removal: Removal) -> list[Reference]:
    """Remove the functions that Plastron wrote to call a service; return the other uses."""
    functions: dict[int, Scope] = {}
    for reference in uses:
        function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
        if function is not None and is_calling_function(analysis, function):
            functions[function.node.id] = function
    for function in list(functions.values()):
        timers = _timers_of(analysis, function)
        statement = statement_of(timers[0].call) if len(timers) == 1 else None
        mentions = function_uses(analysis, function)
        if statement is None or len(mentions) != 1:
            del functions[function.node.id]
            continue
        removal.sites += timers
        removal.statements += [statement, definition(function)]
    gone = [function.node for function in functions.values()]
    return [
        reference
        for reference in uses
        if not any(node.start_byte <= reference.node.start_byte < node.end_byte for node in gone)
    ]


def _timers_of(analysis: Analysis, function: Scope) -> list[Site]:
    return [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.TIMER and callback_scope(analysis, site) is function
    ]


def _remove_publishing(
    analysis: Analysis, variable: Variable, publishing: list[Reference], removal: Removal
) -> None:
    """Remove publishing statements, and the timers that Plastron made for nothing else."""
    whole: dict[int, Scope] = {}
    for reference in publishing:
        function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
        if function is not None and is_publishing_function(analysis, function, publishing):
            whole[function.node.id] = function
        else:
            removal.statements.append(reference.statement)
    for function in whole.values():
        timers = _timers_of(analysis, function)
        statements = [site.call.parent for site in timers]
        uses = function_uses(analysis, function)
        is_own = (
            len(timers) == 1
            and statements[0] is not None
            and statements[0].type == "expression_statement"
            and len(uses) == 1
        )
        if is_own and statements[0] is not None:
            removal.sites += timers
            removal.statements += [statements[0], definition(function)]
        else:
            removal.statements += [
                reference.statement
                for reference in publishing
                if analysis.scopes.at(reference.node.start_byte).is_within(function)
            ]


def definition(function: Scope) -> Node:
    """Return the statement that defines a function, with its decorators."""
    parent = function.node.parent
    is_decorated = parent is not None and parent.type == "decorated_definition"
    return parent if is_decorated and parent is not None else function.node


def callback_scope(analysis: Analysis, site: Site) -> Scope | None:
    """Return the function of the file that a call site's callback is."""
    if site.shape.callback is None:
        return None
    node = callback_target(site.arguments.get(site.shape.callback), site.scope, analysis)
    if node is None:
        return None
    bindings = []
    if node.type == "identifier":
        found = site.scope.lookup(analysis.syntax.slice(node))
        bindings = found[1] if found is not None else []
    elif node.type == "attribute":
        bindings = analysis.resolver.attribute_bindings(node, site.scope)
    if len(bindings) != 1 or bindings[0].kind is not BindingKind.FUNCTION:
        return None
    return bindings[0].owner


def function_uses(analysis: Analysis, function: Scope) -> list[Node]:
    """Return the places that mention a function, its definition aside."""
    is_method = function.parent is not None and function.parent.kind == "class"
    found = []
    for node in identifiers(function.name, analysis):
        name = function.node.child_by_field_name("name")
        if name is not None and node.id == name.id:
            continue
        parent = node.parent
        if parent is not None and parent.type == "keyword_argument" and is_member(node):
            continue
        if not is_method and is_member(node):
            continue
        found.append(node)
    return found


def _stub_callbacks(analysis: Analysis, sites: list[Site], gone: list[Splice]) -> list[Node]:
    """Return the stubs that nothing refers to once the call sites are gone."""
    found = []
    for site in sites:
        function = callback_scope(analysis, site)
        if function is None or not is_stub(analysis, function, site):
            continue
        uses = function_uses(analysis, function)
        inside = all(
            any(splice.start <= node.start_byte < splice.end for splice in gone) for node in uses
        )
        if inside and not _is_last_in_class(function):
            found.append(definition(function))
    return found


def _is_last_in_class(function: Scope) -> bool:
    """Whether a decorator may give the function to others, or a class has nothing else."""
    return definition(function).type == "decorated_definition"
