"""Values that are computed in somebody's C++, and what must hold for them."""

from __future__ import annotations

import pytest
from calculations import HEARD

from plastron_tui.diagnostics import Span
from plastron_tui.model.values import Computed, OfReceived, Operand
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType
from plastron_tui.sources.cpp.computed import Functions
from plastron_tui.sources.cpp.guarded import Conditions, GuardedComputing

LONG, LONGS = OfReceived(("int64",)), OfReceived(("int64s",), 2)
SHORT, LAST = OfReceived(("int16",)), OfReceived(("int64s",), 4)
REAL = OfReceived(("float64",))

CASES: dict[str, tuple[Operand, tuple[tuple[str, Operand], ...], str, str, list[str]]] = {
    "of 64 bits": (LONG, (("+", LONGS), ("*", 3)), "int64",
        "msg.int64 + msg.int64s[2] * 3", ["msg.int64s.size() > 2"]),
    "of too many": (OfReceived(("uint64",)), (("-", LONG),), "int64",
        "static_cast<int64_t>(static_cast<long double>(msg.uint64)"
        " - static_cast<long double>(msg.int64))", []),
    "of few bits": (SHORT, (("-", SHORT),), "uint16",
        "static_cast<uint16_t>(static_cast<int64_t>(msg.int16) - static_cast<int64_t>(msg.int16))",
        ["static_cast<int64_t>(msg.int16) - static_cast<int64_t>(msg.int16) >= 0"]),
    "divided": (LAST, (("/", LONGS), ("+", REAL)), "float64",
        "static_cast<double>(msg.int64s[4]) / static_cast<double>(msg.int64s[2]) + msg.float64",
        ["msg.int64s.size() > 4", "static_cast<double>(msg.int64s[2]) != 0"]),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_what_is_written_and_required(case: str) -> None:
    source, steps, type_, written, required = CASES[case]
    assert isinstance(source, OfReceived)
    conditions = Conditions()
    given = Catalog("jazzy"), 2, Span(0, 0), lambda name: (name, None), Functions()
    value = Computed(source, steps, FieldType(type_), any(sign == "/" for sign, _ in steps))
    lines = GuardedComputing(*given, conditions).set("out.data", value, "msg.", HEARD)
    assert lines == [f"out.data = {written};"]
    assert [*conditions.required][: len(required)] == required
    assert len(conditions.required) == len(required) + (case == "of few bits")
