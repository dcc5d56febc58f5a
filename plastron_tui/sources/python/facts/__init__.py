"""What a Python file does besides creating endpoints, each kind of fact in a file of its own."""

from __future__ import annotations

from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import SourceUnit
from plastron_tui.sources.python.calls import LIBRARIES
from plastron_tui.sources.python.shared_analysis import analyze, package_names

from .callback_facts import callback_facts
from .closed import is_closed
from .messages import message_facts
from .parameters import allows_undeclared, parameter_facts
from .python2 import has_float, is_python2
from .queues import without_queue


def code_facts(source: SourceUnit) -> CodeFacts:
    """Return what the main file of a set does besides creating endpoints."""
    library = LIBRARIES[source.library]
    analysis = analyze(source.files.main, library, package_names(source.path, library))
    callbacks = callback_facts(analysis)
    messages = message_facts(analysis, {each.definition for each in callbacks.arities})
    values = messages.values
    if library.ros_version == 1 and is_python2(analysis):
        values = tuple(each for each in values if not has_float(each))
    return CodeFacts(
        is_closed=is_closed(analysis),
        blocking=callbacks.blocking,
        arities=callbacks.arities,
        repeated=callbacks.repeated,
        early=callbacks.early,
        idle=callbacks.idle,
        no_queue=tuple(without_queue(analysis)),
        parameters=tuple(parameter_facts(analysis)),
        allows_undeclared=allows_undeclared(analysis),
        fields=messages.fields,
        values=values,
        built=messages.built,
        sent=messages.sent,
    )
