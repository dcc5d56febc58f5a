"""Functions that an edit writes for what a node sends, and the timers that have them called."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.model.kinds import Rate
from plastron_tui.model.source import EndpointKind

from .addition import Addition
from .conventions import variable_naming
from .function_place import function_place, method_place
from .functions import callback_scope
from .repeating import holds_timers, period_of, timer_call
from .signatures import parameter_names, signatures_of


def timer_variable(added: Addition) -> str:
    """Return the attribute of the node, or the variable, that a timer is held by."""
    wanted = variable_naming(added.analysis, EndpointKind.TIMER).name(added.name)
    holder, dot, _ = added.variable.rpartition(".")
    name = added.free_name(wanted if dot else wanted.lstrip("_"))
    return f"{holder}{dot}{name}"


def start_timer(added: Addition, rate: Rate, callback: str, method: str) -> list[str]:
    """Return the statement that has a function called at a rate."""
    timer = timer_call(added, period_of(added, rate), callback, method)
    return [f"{timer_variable(added)} = {timer}" if holds_timers(added) else timer]


def function_source(added: Addition, name: str) -> str:
    """Return the source of a function that `write_function` writes."""
    is_method = added.is_method_place and "." in added.variable
    return f"{added.place.self_name}.{name}" if is_method else name


def write_function(
    added: Addition,
    name: str,
    summary: str,
    body: Sequence[str],
    taken: Sequence[tuple[str, str]] | None = None,
) -> tuple[str, list[str]]:
    """Write a method, or return the lines of a function that sees the local variables.

    Args:
        added: the endpoint that the function is for.
        name: the function's name.
        summary: what it does, "" for a file that does not say it.
        body: its statements.
        taken: what it takes besides the object; each with its type; by default what
            timers call functions with.

    Returns:
        The source of the function, and the lines that define it where it is a local one.
    """
    self_name = added.place.self_name
    manner = signatures_of(added.analysis, EndpointKind.TIMER)
    if taken is None:
        names = parameter_names(added.analysis, EndpointKind.TIMER, ["event"])
        taken = [] if added.is_rclpy else [(each, "") for each in names]
    if summary:
        body = [f'"""{summary}"""', *body]
    source = function_source(added, name)
    if source != name:
        head = manner.head(name, [(self_name, ""), *taken], "None")
        lines = [head, *("\t" + line for line in body)]
        senders = [
            scope
            for site in added.analysis.sites
            if site.endpoint.kind is EndpointKind.TIMER
            and (scope := callback_scope(added.analysis, site)) is not None
        ]
        added.writer.function(method_place(added.analysis, added.place, senders), lines)
        return source, []
    lines = [manner.head(name, taken, "None"), *("\t" + line for line in body)]
    if added.place.scope.parent is None:
        gap = added.writer.conventions.blank_lines
        added.writer.function(function_place(added.analysis, added.place, (), gap), lines)
        return name, []
    return name, ["", *lines, ""]
