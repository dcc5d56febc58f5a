"""The functions that Plastron wrote for an endpoint, which go with it."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .creation import Removal
from .endings import destroying
from .functions import callback_scope, definition, function_uses, timers_of
from .generated import body_of, is_asking_function, is_calling_function, repeated_task, sent_once
from .references import Reference, identifiers, statement_of
from .scopes import Scope
from .splices import delete_item
from .syntax import parts_of
from .written_functions import (
    ENDING,
    EXECUTING,
    HELPERS,
    QUIET_THREADS,
    SENDING,
    WARN_UNHEARD,
    is_one_of,
)

_GOAL = re.compile(r"\.(\w+) = goal_handle\b")
# The first value of the attribute that holds a repeated call, and its two places in the function.
_PLACES_OF_TASK = 3


def remove_calling(analysis: Analysis, uses: list[Reference], removal: Removal) -> list[Reference]:
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


def remove_once(analysis: Analysis, uses: list[Reference], removal: Removal) -> list[Reference]:
    """Remove the functions that Plastron wrote to send something once; return the other uses."""
    gone: list[Scope] = []
    for reference in uses:
        function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
        if function is None or any(each is function for each in gone):
            continue
        outside, timers = _outside(analysis, function), timers_of(analysis, function)
        if outside is None or len(timers) != 1 or len(function_uses(analysis, function)) != 1:
            continue
        if destroying(analysis, timers[0]) is None:
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


def _outside(analysis: Analysis, function: Scope) -> list[Node] | None:
    """Return what stands outside of a function that sends once, or warns that nobody hears it.

    None for another function.
    """
    if is_one_of(analysis, function, (WARN_UNHEARD,)):
        return []
    found = sent_once(analysis, function)
    if found is None:
        return None
    outside = [
        statement_of(each)
        for each in identifiers(found["heard"].rpartition(".")[2], analysis)
        if not analysis.scopes.at(each.start_byte).is_within(function)
    ]
    return outside if len(outside) == 1 else None


def remove_ending(analysis: Analysis, reference: Reference, removal: Removal) -> bool:
    """Remove a server of actions from those whose goals end with the node; False elsewhere."""
    function = analysis.scopes.at(reference.node.start_byte).enclosing("function")
    servers = reference.node.parent
    if servers is not None and servers.type == "attribute":
        servers = servers.parent
    if function is None or servers is None or servers.type != "list":
        return False
    if not is_one_of(analysis, function, ENDING):
        return False
    items = parts_of(servers)
    if len(items) > 1:
        start = reference.node.start_byte
        (item,) = (each for each in items if each.start_byte <= start < each.end_byte)
        removal.splices.append(delete_item(analysis.syntax.text, items, item))
        return True
    uses = function_uses(analysis, function)
    removal.statements += [definition(function), *map(statement_of, uses)]
    return True


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


def quieted_threads(analysis: Analysis, removal: Removal) -> list[Node]:
    """Return what Plastron wrote to keep timers quiet at Ctrl-C, where no timer is left."""
    gone = [(each.start_byte, each.end_byte) for each in removal.statements]
    timers = [site for site in analysis.sites if site.endpoint.kind is EndpointKind.TIMER]
    has_gone = [
        site in removal.sites or any(start <= site.call.start_byte < end for start, end in gone)
        for site in timers
    ]
    if not timers or not all(has_gone):
        return []
    functions = [scope for scope in analysis.scopes.all if scope.kind == "function"]
    statements = [statement for scope in functions for statement in body_of(scope)]
    return [each for each in statements if analysis.syntax.slice(each) == QUIET_THREADS]
