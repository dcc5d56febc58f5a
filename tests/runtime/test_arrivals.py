"""How many messages a second come, as `plastron run --watch` and the studio say it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

import plastron_tui.runtime.observers as observers

FAST = [number / 100 for number in range(101)]


@pytest.mark.parametrize(
    ("times", "now", "rate"),
    [
        ([], 1.0, 0),
        ([1.0], 1.0, 0),
        ([1.0, 1.0], 1.0, 0),
        ([1.0, 1.5], 1.5, 2),
        # What comes fast is silent after a second and a half; what is slow, after three periods.
        (FAST, 2.4, 100),
        (FAST, 2.6, 0),
        ([0, 10, 20], 49.0, 0.1),
        ([0, 10, 20], 51.0, 0),
        # Only what came of late counts, but three of them at least.
        ([*(number / 10 for number in range(30)), *(3 + number / 30 for number in range(61))], 5.0,
         30),
        ([0, 1, 2, 12, 22], 22.0, 0.1),
        ([number / 1000 for number in range(3000)], 3.0, 1000),
    ],
)  # fmt: skip
def test_the_rate_is_that_of_late(
    monkeypatch: pytest.MonkeyPatch, times: Sequence[float], now: float, rate: float
) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    from arrivals import Arrivals

    arrivals = Arrivals()
    for at in times:
        arrivals.note(at)
    assert arrivals.count == len(times)
    assert arrivals.rate(now) == pytest.approx(rate)
