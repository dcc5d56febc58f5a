"""What a file's callbacks do, and what keeps them from being called."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Arity, Blocking, EarlyPublish, Repeated
from plastron_tui.sources.python.analysis import Analysis

from .arity import misfits
from .call_graph import CallGraph
from .called_back import called_back
from .early import early
from .executors import Execution
from .inherited_callbacks import inherited_callbacks
from .objects import Objects
from .repeated import repeated
from .spins import idle
from .waits import blocking


class CallbackFacts(NamedTuple):
    """The facts of `CodeFacts` that have to do with callbacks."""

    blocking: tuple[Blocking, ...] = ()
    arities: tuple[Arity, ...] = ()
    repeated: tuple[Repeated, ...] = ()
    early: tuple[EarlyPublish, ...] = ()
    idle: Span | None = None


def callback_facts(analysis: Analysis) -> CallbackFacts:
    """Return what is sure of the callbacks of a file; nothing is of one that does not parse."""
    if analysis.syntax.errors:
        return CallbackFacts()
    graph = CallGraph(analysis)
    if not (analysis.sites or analysis.nodes):
        return CallbackFacts(idle=idle(analysis, graph))
    objects = Objects(analysis)
    callbacks = [*called_back(analysis, objects), *inherited_callbacks(analysis)]
    execution = Execution(analysis, objects)
    return CallbackFacts(
        blocking=tuple(blocking(analysis, callbacks, graph, objects, execution)),
        arities=tuple(misfits(analysis, callbacks, objects, graph)),
        repeated=tuple(repeated(analysis, callbacks, graph)),
        early=tuple(early(analysis, graph)),
        idle=idle(analysis, graph),
    )
