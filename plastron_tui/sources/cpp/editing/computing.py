"""What computes values in an edit, and notes what must hold for them."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.ranges import Interval

from ..computed import Functions
from ..guarded import Conditions, GuardedComputing
from .adding import Addition
from .parameters import read_parameter


def computing_for(added: Addition, span: Span | None) -> tuple[GuardedComputing, Conditions]:
    """Return what writes computed values, with the conditions that it notes."""

    def value(name: str) -> tuple[str, Interval | None]:
        read = read_parameter(added, name, in_method=added.owner is not None)
        return read.text, read.range

    # What is asked of an endpoint of the file has no place; the statement was checked before.
    span = Span(0, 0) if span is None else span
    conditions = Conditions()
    catalog, version = added.interfaces.catalog, added.analysis.ros_version
    return GuardedComputing(catalog, version, span, value, Functions(), conditions), conditions
