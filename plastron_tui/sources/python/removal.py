"""The uses of an endpoint that is taken out of a file, and the functions that they are in."""

from __future__ import annotations

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
from .endings import destroying, ends_endpoint
from .functions import callback_scope, definition, function_uses, timers_of
from .generated import (
    is_own_call,
    is_publishing_function,
    serves,
)
from .own_removal import remove_calling, remove_ending, remove_once
from .rates import is_once
from .references import (
    Reference,
    Use,
    Variable,
    references,
    statement_of,
)
from .scopes import Scope
from .syntax import parts_of

# What makes an action ready, and is of no use without it.
_READYING = {
    EndpointKind.ACTION_SERVER: "start",
    EndpointKind.ACTION_CLIENT: "wait_for_server",
}


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
        uses = remove_calling(analysis, uses, removal)
    elif sites[0].endpoint.kind is EndpointKind.PUBLISHER:
        uses = remove_once(analysis, uses, removal)
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
            or ends_endpoint(analysis, reference)
        ):
            removal.statements.append(reference.statement)
        elif reference.use is Use.BINDING:
            rebound.add(line_of(reference.node))
        elif _is_guard(analysis, reference):
            guards.append(reference)
        elif remove_ending(analysis, reference, removal):
            pass
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


def _only_call(analysis: Analysis, function: Scope) -> Node | None:
    """Return the statement that does nothing but call a function, where nothing else names it."""
    uses = function_uses(analysis, function)
    statement = statement_of(uses[0]) if len(uses) == 1 else None
    parts = parts_of(statement) if statement is not None else []
    callee = parts[0].child_by_field_name("function") if len(parts) == 1 else None
    return statement if callee is not None and callee.end_byte == uses[0].end_byte else None


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
        if (call := _only_call(analysis, function)) is not None:
            removal.statements += [call, definition(function)]
            continue
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
