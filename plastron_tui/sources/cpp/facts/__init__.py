"""What the C++ files of a unit do besides creating endpoints, each kind of fact in its own file."""

from __future__ import annotations

from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import SourceUnit
from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.last_read import last_analysis
from plastron_tui.sources.cpp.reader import read_cpp

from .arity import misfits
from .called_back import CallbackBodies
from .closed import is_closed
from .dropped import dropped
from .early import early
from .fields import field_uses
from .message_types import MessageTypes
from .parameters import allows_undeclared, parameter_facts
from .repeated import repeated
from .sent import sent_messages
from .spins import idle
from .values import field_values
from .waits import blocking


def code_facts(source: SourceUnit) -> CodeFacts:
    """Return what the files of a unit do besides creating endpoints."""
    analysis = last_analysis(source)
    if analysis is None:
        again = read_cpp(source.path, source.files, source.library).source
        analysis = None if again is None else last_analysis(again)
    return CodeFacts() if analysis is None else facts_of(analysis)


def facts_of(analysis: Analysis) -> CodeFacts:
    """Return what analysed files do besides creating endpoints."""
    types = MessageTypes(analysis)
    bodies = CallbackBodies(analysis)
    return CodeFacts(
        is_closed=is_closed(analysis),
        fields=tuple(field_uses(analysis, types)),
        values=tuple(field_values(analysis, types)),
        parameters=tuple(parameter_facts(analysis)),
        allows_undeclared=allows_undeclared(analysis),
        sent=tuple(sent_messages(analysis, types)),
        blocking=tuple(blocking(analysis, bodies)),
        arities=tuple(misfits(analysis, bodies)),
        repeated=tuple(repeated(analysis, bodies)),
        dropped=tuple(dropped(analysis)),
        early=tuple(early(analysis, types)),
        idle=idle(analysis),
    )
