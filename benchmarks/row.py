from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import dataclass
from statistics import median
from time import perf_counter


@dataclass(frozen=True)
class Row:
    """One line of the table: what was measured, and the most that it may be."""

    name: str
    value: float
    bound: float
    unit: str = "x"
    detail: str = ""

    @property
    def holds(self) -> bool:
        return self.value <= self.bound


def seconds(work: Callable[[], object]) -> float:
    """Time one call, with the collector's debts of earlier calls paid before."""
    gc.collect()
    start = perf_counter()
    result = work()
    spent = perf_counter() - start
    del result
    return spent


def paired(first: Callable[[], object], second: Callable[[], object], runs: int) -> list[float]:
    """Run two things in turn; return the median seconds of each and of their ratio.

    A machine's speed drifts: the ratio is taken run by run.
    """
    first(), second()
    pairs = [(seconds(first), seconds(second)) for _ in range(runs)]
    return [
        median(a for a, _ in pairs),
        median(b for _, b in pairs),
        median(a / b for a, b in pairs),
    ]
