"""What computes values in an edit, and notes what must hold for them."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.ranges import Interval

from ..computed import Functions
from ..guarded import Conditions, GuardedComputing
from .adding import Addition
from .parameters import read_parameter


def computing_for(added: Addition, span: Span | None) -> tuple[GuardedComputing, Conditions]:
    """Return what writes computed values, with the conditions that it notes.

    Args:
        added: what is added.
        span: the statement that makes the endpoint; None where the file has it, and it gets more.
    """

    def value(name: str) -> tuple[str, Interval | None]:
        read = read_parameter(added, name, in_method=added.owner is not None)
        return read.text, read.range

    conditions = Conditions()
    catalog, version = added.interfaces.catalog, added.analysis.ros_version
    where = span or Span(0, 0)  # what is received is of a known type: nothing is told of it here
    return GuardedComputing(catalog, version, where, value, Functions(), conditions), conditions
