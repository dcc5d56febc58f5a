"""The uses of an endpoint that is taken out of a file, and the functions that they are in."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind, Remove, Rename, Update
from plastron_tui.ros.names import name_as_read

from .analysis import Analysis, Site
from .arguments import Arguments
from .calls import Argument
from .constants import Known
from .creation import Removal, line_of
from .emptied_blocks import emptied_blocks
from .functions import callback_scope, definition, function_uses, timers_of
from .generated import (
    is_asking_function,
    is_calling_function,
    is_own_call,
    is_publishing_function,
    repeated_task,
    sent_once,
    serves,
)
from .rates import is_once
from .references import (
    Reference,
    Use,
    Variable,
    identifiers,
    references,
    statement_of,
    variable_of,
)
from .scopes import Scope
from .syntax import parts_of
from .written_functions import EXECUTING, HELPERS, SENDING, is_one_of

_GOAL = re.compile(r"\.(\w+) = goal_handle\b")
# What ends an endpoint: its own methods, and those of an rclpy node.
_ENDING = frozenset({"destroy", "shutdown", "unregister"})
# What makes an action ready, and is of no use without it.
_READYING = {
    EndpointKind.ACTION_SERVER: "start",
    EndpointKind.ACTION_CLIENT: "wait_for_server",
}
_DESTROYING = frozenset(
    {"destroy_client", "destroy_publisher", "destroy_service", "destroy_subscription"}
    | {"destroy_lifecycle_publisher", "destroy_timer"}
)

# The first value of the attribute that holds a repeated call, and its two places in the function.
_PLACES_OF_TASK = 3


def find_sites(analysis: Analysis, change: Remove | Update | Rename) -> list[Site]:
    """Return the call sites of the endpoint that a change names."""
    of_kind = [site for site in analysis.sites if site.endpoint.kind is change.kind]
    if change.kind is EndpointKind.TIMER:
        return [each for each in of_kind if _is_repeating(analysis, each, change.name)]
    named = [site for site in of_kind if site.endpoint.name == change.name]
    return named or [site for site in of_kind if site.endpoint.default == change.name]


def _is_repeating(analysis: Analysis, site: Site, function: str) -> bool:
    """Whether a timer repeats a function, for no other endpoint."""
    if site.endpoint.callback != function or is_once(site):
        return False
    return not serves(analysis, callback_scope(analysis, site))


def waits(analysis: Analysis, sites: Iterable[Site]) -> dict[str | None, list[tuple[Node, Node]]]:
    """Return the statements that wait for clients' services, each with the argument that names it.

    Where the service is not there they would keep the node waiting for ever.
    """
    names = {site.endpoint.name for site in sites if site.endpoint.kind is EndpointKind.CLIENT}
    found: dict[str | None, list[tuple[Node, Node]]] = {}
    for call in analysis.captures.get("call", []) if names else []:
        statement = call.parent
        if statement is None or statement.type != "expression_statement":
            continue
        scope = analysis.scopes.at(call.start_byte)
        callee = call.child_by_field_name("function")
        if "rospy.wait_for_service" not in analysis.resolver.qualified(callee, scope):
            continue
        given = Arguments.of(call, analysis.syntax).get(Argument(0, "service"))
        folded = analysis.resolver.fold(given, scope)
        value = folded.value if isinstance(folded, Known) else None
        if given is None or not isinstance(value, str):
            continue
        name = name_as_read(value, analysis.library.ros_version)
        if name in names:
            found.setdefault(name, []).append((statement, given))
    return found


def remove_uses(
    analysis: Analysis, variable: Variable, sites: list[Site], removal: Removal
) -> None:
    """Remove what only publishes on a variable; note the lines of every other use."""
    gone = [(each.start_byte, each.end_byte) for each in removal.statements]
    cut = [splice for splice in removal.splices if not splice.text]
    publishing: list[Reference] = []
    guards: list[Reference] = []
    rebound: set[int] = set()
    uses = references(variable, analysis)
    if sites[0].endpoint.kind in (EndpointKind.CLIENT, EndpointKind.ACTION_CLIENT):
        uses = _remove_calling(analysis, uses, removal)
    elif sites[0].endpoint.kind is EndpointKind.PUBLISHER:
        uses = _remove_once(analysis, uses, removal)
    for reference in uses:
        start = reference.node.start_byte
        if any(first <= start < last for first, last in gone) or any(
            splice.start <= reference.node.start_byte < splice.end for splice in cut
        ):
            continue
        if reference.use is Use.PUBLISH:
            publishing.append(reference)
        elif (
            reference.use is Use.BARE
            or _readies(analysis, reference, sites[0].endpoint.kind)
            or is_own_call(analysis, reference)
            or _ends_endpoint(analysis, reference)
        ):
            removal.statements.append(reference.statement)
        elif reference.use is Use.BINDING:
            rebound.add(line_of(reference.node))
        elif _is_guard(analysis, reference):
            guards.append(reference)
        elif reference.use is not Use.NOTHING:
            removal.lines.add(line_of(reference.node))
    # What the variable holds besides matters only where something is done with it.
    removal.lines |= rebound if publishing or removal.lines else set()
    calls = {site.call.id for site in sites}
    for reference in publishing:
        inside = [
            site
            for site in analysis.sites
            if site.call.id not in calls
            and site.endpoint.kind is not EndpointKind.PARAMETER
            and reference.statement.start_byte
            <= site.call.start_byte
            < reference.statement.end_byte
        ]
        if inside:
            removal.lines.add(line_of(reference.node))
    _remove_publishing(analysis, variable, publishing, removal)
    if guards:
        emptied = {each.id for each in emptied_blocks(analysis, removal.statements)}
        kept = [each for each in guards if each.statement.id not in emptied]
        removal.lines |= {line_of(each.node) for each in kept}


def _is_guard(analysis: Analysis, reference: Reference) -> bool:
    """Whether a use only asks if there is an endpoint: `if self.pub is not None:`.

    A client or a server of an action is also asked for in `self.waitables`.
    """
    condition, asked = reference.statement.child_by_field_name("condition"), reference.node
    if reference.statement.type != "if_statement" or condition is None:
        return False
    if condition.type == "comparison_operator":
        parts = parts_of(condition)
        if len(parts) != 2 or parts[0].id != asked.id:
            return False
        return parts[1].type == "none" or analysis.syntax.slice(parts[1]).endswith(".waitables")
    return condition.id == asked.id


def _readies(analysis: Analysis, reference: Reference, kind: EndpointKind) -> bool:
    """Whether a statement does nothing but make an endpoint ready: it starts it, or waits."""
    parent = reference.node.parent
    call = parent.parent if parent is not None else None
    if parent is None or call is None or call.type != "call" or len(parts_of(call.parent)) != 1:
        return False
    name = parent.child_by_field_name("attribute")
    is_statement = call.parent is not None and call.parent.id == reference.statement.id
    return is_statement and name is not None and analysis.syntax.slice(name) == _READYING.get(kind)


def _ends_endpoint(analysis: Analysis, reference: Reference) -> bool:
    """Whether a statement does nothing but end an endpoint, which is no more."""
    parent = reference.node.parent
    call = reference.statement.named_children[0] if reference.statement.named_children else None
    if parent is None or call is None or call.type != "call" or len(parts_of(call.parent)) != 1:
        return False
    callee, arguments = (call.child_by_field_name(each) for each in ("function", "arguments"))
    name = callee.child_by_field_name("attribute") if callee is not None else None
    if callee is None or arguments is None or name is None:
        return False
    ending = analysis.syntax.slice(name)
    if parent.id == callee.id:
        return ending in _ENDING and not parts_of(arguments)
    return ending in _DESTROYING and [part.id for part in parts_of(arguments)] == [
        reference.node.id
    ]


def _remove_calling(analysis: Analysis, uses: list[Reference], removal: Removal) -> list[Reference]:
    """Remove the functions that Plastron wrote to ask a server; return the other uses."""
    functions: dict[int, Scope] = {}
    for reference in uses:
        function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
        if function is None:
            continue
        if (
            is_calling_function(analysis, function)
            or is_asking_function(analysis, function)
            or is_one_of(analysis, function, SENDING)
        ):
            functions[function.node.id] = function
    for function in list(functions.values()):
        if is_asking_function(analysis, function):
            if not _remove_asking(analysis, function, removal):
                del functions[function.node.id]
            continue
        timers = timers_of(analysis, function)
        statement = statement_of(timers[0].call) if len(timers) == 1 else None
        mentions = function_uses(analysis, function)
        if statement is None or len(mentions) != 1:
            del functions[function.node.id]
            continue
        removal.sites += timers
        removal.statements += [statement, definition(function)]
        removal.statements += destroying(analysis, timers[0]) or []
    gone = [function.node for function in functions.values()]
    return [
        reference
        for reference in uses
        if not any(node.start_byte <= reference.node.start_byte < node.end_byte for node in gone)
    ]


def _remove_once(analysis: Analysis, uses: list[Reference], removal: Removal) -> list[Reference]:
    """Remove the functions that Plastron wrote to send something once; return the other uses."""
    gone: list[Scope] = []
    for reference in uses:
        function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
        if function is None or any(each is function for each in gone):
            continue
        found, timers = sent_once(analysis, function), timers_of(analysis, function)
        if found is None or len(timers) != 1 or len(function_uses(analysis, function)) != 1:
            continue
        name = found["heard"].rpartition(".")[2]
        outside = [
            statement_of(each)
            for each in identifiers(name, analysis)
            if not analysis.scopes.at(each.start_byte).is_within(function)
        ]
        if destroying(analysis, timers[0]) is None or len(outside) != 1:
            continue
        gone.append(function)
        removal.sites += timers
        removal.statements += [statement_of(timers[0].call), definition(function), *outside]
        removal.statements += destroying(analysis, timers[0]) or []
    return [
        each
        for each in uses
        if not any(analysis.scopes.at(each.node.start_byte).is_within(scope) for scope in gone)
    ]


def _remove_asking(analysis: Analysis, function: Scope, removal: Removal) -> bool:
    """Remove a method that asks a server, and what starts it; tell whether that is all of it."""
    mentions = function_uses(analysis, function)
    statement = statement_of(mentions[0]) if len(mentions) == 1 else None
    if statement is None or statement.type != "expression_statement":
        return False
    repeating = analysis.scopes.at(statement.start_byte).enclosing("function")
    if repeating is not None and _remove_repeating(analysis, repeating, removal):
        removal.statements.append(definition(function))
        return True
    if parts_of(statement)[0].type == "assignment":
        return False
    removal.statements += [statement, definition(function)]
    return True


def _remove_repeating(analysis: Analysis, function: Scope, removal: Removal) -> bool:
    """Remove a function that repeats a call, and what holds the two; False for others."""
    timers = timers_of(analysis, function)
    task, owner = repeated_task(analysis, function), function.parent
    if task is None or owner is None or len(timers) != 1:
        return False
    ends = destroying(analysis, timers[0])
    if ends is None or len(function_uses(analysis, function)) != 1:
        return False
    removal.sites += timers
    removal.statements += [statement_of(timers[0].call), definition(function), *ends]
    if len(list(identifiers(task, analysis))) == _PLACES_OF_TASK:
        bindings = owner.attributes.get(task, [])
        first = [each for each in bindings if each.scope is not function]
        removal.statements += [statement_of(each.node) for each in first]
    return True


def executing(analysis: Analysis, sites: Iterable[Site]) -> list[Node]:
    """Return the functions that Plastron wrote to work on goals of action servers that go."""
    found = []
    for site in sites:
        function = callback_scope(analysis, site)
        if site.endpoint.kind is not EndpointKind.ACTION_SERVER or function is None:
            continue
        if is_one_of(analysis, function, EXECUTING) and len(function_uses(analysis, function)) == 1:
            found += [definition(function), *_first_goal(analysis, function)]
    return found


def _first_goal(analysis: Analysis, function: Scope) -> list[Node]:
    """Return `self.goal = None`, where such a function alone has to do with the attribute."""
    held = _GOAL.search(analysis.syntax.slice(function.node))
    node = function.node
    others = [
        statement_of(each)
        for each in (identifiers(held[1], analysis) if held is not None else ())
        if not node.start_byte <= each.start_byte < node.end_byte
    ]
    is_none = len(others) == 1 and analysis.syntax.slice(others[0]).endswith("= None")
    return others if is_none else []


def unused_helpers(analysis: Analysis, removal: Removal) -> list[Node]:
    """Return the functions that Plastron wrote for those that go, and that nothing else uses."""
    found: list[Node] = []
    helpers = [
        scope
        for scope in analysis.scopes.all
        if scope.kind == "function" and is_one_of(analysis, scope, HELPERS)
    ]
    for helper in helpers:
        gone = [(each.start_byte, each.end_byte) for each in removal.statements]
        uses = [each.start_byte for each in function_uses(analysis, helper)]
        if uses and all(any(start <= use < end for start, end in gone) for use in uses):
            found.append(definition(helper))
    return found


def destroying(analysis: Analysis, timer: Site) -> list[Node] | None:
    """Return the statements that destroy a timer, None where something else is done with it."""
    parent = timer.call.parent
    if parent is not None and parent.type == "expression_statement":
        return []
    target = parent.child_by_field_name("left") if parent and parent.type == "assignment" else None
    variable = variable_of(target, analysis) if target is not None else None
    if variable is None:
        return None
    uses = references(variable, analysis)
    uses = [each for each in uses if each.use not in (Use.BINDING, Use.NOTHING)]
    ends = [each.statement for each in uses if _ends_endpoint(analysis, each)]
    function = callback_scope(analysis, timer)
    inside = [
        each
        for each in uses
        if function is not None and analysis.scopes.at(each.node.start_byte).is_within(function)
    ]
    return ends if len(ends) + len(inside) == len(uses) else None


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
        timers = timers_of(analysis, function)
        ends = destroying(analysis, timers[0]) if len(timers) == 1 else None
        if ends is not None and len(function_uses(analysis, function)) == 1:
            removal.sites += timers
            removal.statements += [statement_of(timers[0].call), definition(function)]
            removal.statements += ends
        else:
            removal.statements += [
                reference.statement
                for reference in publishing
                if analysis.scopes.at(reference.node.start_byte).is_within(function)
            ]
