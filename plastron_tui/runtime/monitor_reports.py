"""What a monitor has said and nobody has taken yet, in as much memory as its last state takes."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Mapping
from typing import Any

_MOST_ANSWERS = 2000
"""So many answers are kept; each was asked for, and so this is far more than there can be."""

Report = Mapping[str, Any]


class Reports:
    """Reports by what they are about; a newer one takes the place of what it replaces.

    A monitor says each thing once, when it changes, and a studio that is suspended takes nothing
    for as long as it likes: nothing may be dropped but what is out of date. One thread adds while
    another one takes.
    """

    def __init__(self) -> None:
        """Start with none."""
        self._lock = threading.Lock()
        self._clear()

    def _clear(self) -> None:
        self._graph: list[Report] = []
        self._rows: dict[str, Any] = {}
        self._parameters: dict[str, Report] = {}
        self._sendings: dict[str, Report] = {}
        self._goals: dict[int, Report] = {}
        self._answers: deque[Report] = deque(maxlen=_MOST_ANSWERS)

    def add(self, report: Report) -> bool:
        """Keep a report; False where nobody needs to take it, as a `beat`."""
        with self._lock:
            match report:
                case {"tell": "graph"}:
                    self._graph = [report]
                case {"tell": "problem"}:
                    # It says nothing of the graph, which is known up to then.
                    self._graph = [*(e for e in self._graph if e["tell"] == "graph"), report]
                case {"tell": "topics", "rows": dict(rows)}:
                    self._rows |= rows
                case {"tell": "parameters", "node": str(node)}:
                    self._parameters[node] = report
                case {"tell": "sending", "name": str(name)}:
                    self._sendings[name] = report
                case {"tell": "goal", "id": int(number)}:
                    self._goals[number] = report
                case {"tell": "answer"}:
                    self._answers.append(report)
                case _:
                    return False
        return True

    def take(self) -> list[Report]:
        """Return what was added since this was called last, the graph before what is in it."""
        with self._lock:
            rows: list[Report] = [{"tell": "topics", "rows": self._rows}] if self._rows else []
            kept = (self._parameters, self._sendings, self._goals)
            last = [report for each in kept for report in each.values()]
            found = [*self._graph, *rows, *last, *self._answers]
            self._clear()
        return found
