"""Calls that wait while the executor's thread, or the group of the callback, waits for them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Blocking, Wait
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.ending import ends_after, is_end, is_pause
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.scopes import Scope

from .call_graph import CallGraph
from .called_back import CalledBack, named, running_scope
from .executors import Execution
from .objects import Objects
from .unconditional import runs_each_time
from .waiting_calls import Waiting, WaitingCalls, may_wait

_SIGNAL = InterfaceName("std_msgs", "Empty")


def blocking(
    analysis: Analysis,
    callbacks: Sequence[CalledBack],
    graph: CallGraph,
    objects: Objects,
    execution: Execution,
) -> Iterator[Blocking]:
    """Yield the calls in callbacks that wait, each for the first callback that does."""
    if not may_wait(analysis):
        return
    waits = WaitingCalls(analysis, objects)
    by_function: dict[Scope, list[Waiting]] = {}
    for each in waits.all():
        by_function.setdefault(running_scope(analysis, each.call), []).append(each)
    if not by_function:
        return
    ending = _ending(analysis)
    found: dict[int, Blocking] = {}
    for callback in callbacks:
        if callback.function is None:
            continue
        if is_pause(callback.function.node):
            continue
        for function, calls in graph.reached(callback.function).items():
            for waiting in by_function.get(function, ()):
                way = (waiting.call, *calls)
                if waiting.wait is Wait.SLEEP and any(ends_after(each, ending) for each in way):
                    # It lets the last messages leave: nothing is called any more.
                    continue
                if analysis.library.module == "rospy" and not _piles_up(callback, way, analysis):
                    continue
                fact = _judged(waiting, callback, execution, analysis)
                before = found.get(waiting.call.id)
                if fact is not None and (before is None or fact.is_endless > before.is_endless):
                    found[waiting.call.id] = fact
    yield from sorted(found.values(), key=lambda each: each.span)


def _ending(analysis: Analysis) -> frozenset[bytes]:
    """Return the names of the functions of a file that end the program."""
    bodies = ((each.name, each.node.child_by_field_name("body")) for each in analysis.scopes.all)
    return frozenset(
        name.encode()
        for name, body in bodies
        if name and body is not None and any(map(is_end, body.named_children))
    )


def _judged(
    waiting: Waiting, callback: CalledBack, execution: Execution, analysis: Analysis
) -> Blocking | None:
    """Return what a wait does in a callback, None where it may be harmless."""
    is_endless = False
    function = running_scope(analysis, waiting.call)
    if analysis.library.module == "rospy":
        # Each connection of a topic has a thread, which calls its callbacks one after the other.
        if waiting.wait is not Wait.SLEEP or callback.kind is not EndpointKind.SUBSCRIPTION:
            return None
    elif waiting.wait is Wait.SLEEP:
        if not _holds_up(waiting, callback, execution):
            return None
        is_endless = waiting.is_rate and execution.is_single
    else:
        # Who spins without end in a callback never comes back from it.
        is_endless = all(_never_comes(waiting, callback, site, execution) for site in waiting.sites)
        if not is_endless or (not waiting.sites and callback.is_task):
            return None
    return Blocking(
        waiting.wait,
        named(callback.value, callback.scope, analysis),
        callback.kind,
        Span(waiting.call.start_byte, waiting.call.end_byte),
        is_endless=is_endless,
        seconds=waiting.seconds,
        created=callback.value.start_byte,
        inside="" if function is callback.function else function.name,
    )


def _piles_up(callback: CalledBack, way: Sequence[Node], analysis: Analysis) -> bool:
    """Tell whether the messages of a topic surely wait for a call in its callback of rospy.

    Only this topic waits. One with a queue of one message, whose callback ends with a sleep or has
    it on a condition, has a pace that is meant, and a signal without content does not grow old.
    """
    site, function = callback.site, callback.function
    if callback.kind is not EndpointKind.SUBSCRIPTION or function is None:
        return False
    if site is not None and site.endpoint.type == _SIGNAL:
        return False
    if b".unregister(" in (function.node.text or b""):
        return False
    said = None if site is None else site.shape.qos
    queue = None if said is None or said.queue_size is None else said.queue_size
    given = None if site is None or queue is None else site.arguments.get(queue)
    is_short = given is not None and given.text == b"1"
    if not is_short:
        return True
    each_time = all(runs_each_time(each, running_scope(analysis, each).node) for each in way)
    return each_time and not all(map(_is_last, way))


def _is_last(call: Node) -> bool:
    """Tell whether nothing comes behind the statement of a call, but for the way out."""
    statement = statement_of(call)
    behind = statement.next_named_sibling
    return behind is None or behind.type == "return_statement"


def _never_comes(waiting: Waiting, callback: CalledBack, site: Site, execution: Execution) -> bool:
    """Tell whether an endpoint cannot bring what is waited for, while the callback waits."""
    if execution.exclude(callback, site):
        return True
    # Who spins in a callback does what the thread would do; others leave it to the thread.
    is_spun = waiting.node is not None
    return not is_spun and execution.is_single and execution.are_of_one_node(callback, site)


def _holds_up(waiting: Waiting, callback: CalledBack, execution: Execution) -> bool:
    """Tell whether other callbacks of the node surely wait while one sleeps."""
    if execution.is_single:
        return True
    if waiting.is_rate or callback.site is None or execution.has_threads:
        return False
    if execution.has_groups:
        # Whoever spins the node may call those of the other groups meanwhile.
        return False
    return execution.exclude(callback, callback.site)
