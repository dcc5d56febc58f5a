"""The analysis of the unit that was read last, for who asks more about it right after.

`plastron lint` asks what the code of a unit does as soon as it is read. One analysis is kept, no
more: that of a large unit is a hundred times its text.
"""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.model.source import SourceNode, SourceUnit
from plastron_tui.sources.text_memo import MEMO, MOST_BYTES

from .analysis import Analysis

_KEY = "the C++ unit that was read last"


class _Last(NamedTuple):
    nodes: tuple[SourceNode, ...]
    analysis: Analysis


def keep_analysis(source: SourceUnit, analysis: Analysis) -> None:
    """Keep the analysis that a unit was read by, in the place of the one before."""
    size = sum(len(text) for _, text in source.files.texts)
    # A large unit is kept as well: there is only one.
    size = min(size, MOST_BYTES // 2)
    MEMO.keep(_KEY, _Last(source.nodes, analysis), size)


def last_analysis(source: SourceUnit) -> Analysis | None:
    """Return the analysis that a unit was read by, None where another one was read since."""
    last: _Last | None = MEMO.get(_KEY)
    # The nodes are those of one reading: equal texts may be of other folders, or headers.
    return last.analysis if last is not None and last.nodes is source.nodes else None
