"""The further places of a finding, of which people are shown a few."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from plastron_tui.diagnostics import Label, Span

_MOST = 3


def first_labels(places: Sequence[tuple[Path, Span]], text: str) -> Iterator[Label]:
    """Yield labels at the first of some places; the last says in how many files more are left.

    Args:
        places: a place in each file.
        text: what is there.
    """
    left = len(places) - _MOST
    for at, (file, span) in enumerate(places[:_MOST], 1):
        more = f", and in {left} more file{'s' * (left > 1)}" if left > 0 and at == _MOST else ""
        yield Label(span, f"{text}{more}", file)
