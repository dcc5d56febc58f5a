"""What the callbacks of `message_filters` get: a message of each subscriber, in their order.

Source: `message_filters.SimpleFilter` and `TimeSynchronizer` of Noetic and Jazzy.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.references import function_of
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

_SYNCHRONIZERS = frozenset(
    {
        f"message_filters.{name}"
        for name in ("TimeSynchronizer", "ApproximateTimeSynchronizer", "ExactTimeSynchronizer")
    }
)


def synchronized(
    analysis: Analysis, sites: Mapping[int, Site]
) -> Iterator[tuple[Scope, int, Site | None]]:
    """Yield the functions that filters call, with the subscriber of each of their parameters.

    A subscriber that is not known is None.
    """
    for call in analysis.resolver.calls_of("registerCallback"):
        arguments = Arguments.of(call, analysis.syntax)
        given = arguments.get(Argument(0, "cb"))
        function = function_of(given, analysis) if given is not None else None
        if function is None or len(arguments.positional) > 1 or arguments.is_open:
            continue
        receiver = call.child_by_field_name("function")
        holder = receiver.child_by_field_name("object") if receiver is not None else None
        for position, site in enumerate(_subscribers(analysis, sites, holder)):
            yield function, position, site


def _subscribers(
    analysis: Analysis, sites: Mapping[int, Site], filter_: Node | None
) -> list[Site | None]:
    """Return the subscribers that a filter brings together, or the one that it is."""
    made = made_by(analysis, filter_)
    if made is None:
        return []
    if made.id in sites:
        return [sites[made.id]]
    callee = made.child_by_field_name("function")
    names = analysis.resolver.qualified(callee, analysis.scopes.at(made.start_byte))
    if not names or not _SYNCHRONIZERS.issuperset(names):
        return []
    listed = Arguments.of(made, analysis.syntax).get(Argument(0, "fs"))
    if listed is None or listed.type not in ("list", "tuple"):
        return []
    subscribers = [made_by(analysis, each) for each in parts_of(listed)]
    return [sites.get(each.id) if each is not None else None for each in subscribers]


def made_by(analysis: Analysis, node: Node | None) -> Node | None:
    """Return the one call that makes what a name or an attribute is."""
    if node is None or node.type == "call":
        return node
    scope = analysis.scopes.at(node.start_byte)
    if node.type == "identifier":
        found = scope.lookup(analysis.syntax.slice(node))
        bindings = found[1] if found is not None else []
    else:
        bindings = analysis.resolver.attribute_bindings(node, scope)
    known = without_none(bindings)
    value = known[0].value if len(known) == 1 else None
    return value if value is not None and value.type == "call" else None
