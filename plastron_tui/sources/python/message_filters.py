"""Where messages go that no callback of the call takes: through `message_filters`, or by waiting.

A subscriber of `message_filters` hands them to the filters that are made of it, the last of which
gives them to the functions of its `registerCallback` (`message_filters.SimpleFilter`).
"""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .callbacks import callback_target
from .references import Use, references, variable_of
from .syntax import parts_of

_HOLDING = frozenset(
    {"list", "tuple", "list_splat", "parenthesized_expression", "keyword_argument"}
)
# A filter is made of another one, which is made of a third; more are not read.
_MOST_FILTERS = 4


def takers(analysis: Analysis, site: Site) -> list[str]:
    """Return the functions that take what a subscription without a callback hears."""
    found = dict.fromkeys(_functions(analysis, site.call, _MOST_FILTERS))
    return [f"`{name}`" for name in found]


def hands_on(site: Site) -> bool:
    """Whether a call takes no callback, and what it hears goes on all the same."""
    parent = site.call.parent
    if site.endpoint.kind is not EndpointKind.SUBSCRIPTION or site.shape.callback is not None:
        return False
    return parent is not None and parent.type != "expression_statement"


def _functions(analysis: Analysis, filter_: Node, depth: int) -> Iterator[str]:
    """Yield the functions that are registered with a filter, or with one that is made of it."""
    parent = filter_.parent
    if parent is None or depth == 0:
        return
    if parent.type == "attribute":
        yield from _registered(analysis, parent)
    elif parent.type == "assignment":
        target = parent.child_by_field_name("left")
        variable = variable_of(target, analysis) if target is not None else None
        for reference in references(variable, analysis) if variable is not None else ():
            if reference.use is Use.OTHER:
                yield from _functions(analysis, reference.node, depth - 1)
    elif parent.type in _HOLDING:
        yield from _functions(analysis, parent, depth)
    elif parent.type == "argument_list" and parent.parent is not None:
        yield from _functions(analysis, parent.parent, depth - 1)


def _registered(analysis: Analysis, attribute: Node) -> Iterator[str]:
    """Yield the function of `filter.registerCallback(function)`."""
    name, call = attribute.child_by_field_name("attribute"), attribute.parent
    if name is None or call is None or call.type != "call":
        return
    given = parts_of(call.child_by_field_name("arguments"))[:1]
    if analysis.syntax.slice(name) != "registerCallback" or not given:
        return
    function = callback_target(given[0], analysis.scopes.at(call.start_byte), analysis)
    if function is not None and function.type in ("identifier", "attribute"):
        yield analysis.syntax.slice(function).rpartition(".")[2]
