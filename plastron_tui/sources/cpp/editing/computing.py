"""What computes values in an edit, and notes what must hold for them."""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.ranges import Interval
from plastron_tui.ros.catalog import Catalog

from ..computed import Computing, Functions
from ..guarded import Conditions, GuardedComputing
from .adding import Addition
from .parameters import read_parameter


def computing_for(added: Addition, span: Span | None) -> tuple[GuardedComputing, Conditions]:
    """Return what writes computed values, with the conditions that it notes.

    Args:
        added: what is added.
        span: the statement that makes the endpoint; None where the file has it, and it gets more.
    """
    conditions = Conditions()
    return GuardedComputing(*_given(added, span), Functions(), conditions), conditions


def checked_computing(added: Addition, span: Span | None) -> Computing:
    """Return what writes computed values for a place that catches what fits no field.

    The functions that check are those of the files that Plastron writes.
    """
    return Computing(*_given(added, span), Functions())


def _given(
    added: Addition, span: Span | None
) -> tuple[Catalog, int, Span, Callable[[str], tuple[str, Interval | None]]]:
    def value(name: str) -> tuple[str, Interval | None]:
        read = read_parameter(added, name, in_method=added.owner is not None)
        return read.text, read.range

    where = span or Span(0, 0)  # what is received is of a known type: nothing is told of it here
    return added.interfaces.catalog, added.analysis.ros_version, where, value
