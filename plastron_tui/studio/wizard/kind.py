"""What every kind of slot can be asked."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.ros.names import NameProblem

from .ask import Ask, Choice
from .form import Cell
from .part_rows import Part

OF_THE_LIST = "choose one with ↓"
"""What to do where only what is offered will do."""


class Kind:
    """A kind of slot."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return what stands in the slot, where other slots leave no choice."""
        return None

    def suggest(self, ask: Ask) -> str:
        """Return what is in the slot as long as nothing was entered."""
        return ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what can be taken; `query` is what was written."""
        return []

    def parts(self, ask: Ask) -> Sequence[Part] | None:
        """Return what each row of the slot is for; None for a slot of one row."""
        return None

    def meant(self, ask: Ask, text: str) -> str:
        """Return what is taken for what somebody entered."""
        return text

    def written(self, ask: Ask, text: str) -> str:
        """Return a text as the program has it, without the quotes of a name."""
        return text

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand in the slot, as far as the slot itself knows."""
        return None


def name_problem(problem: NameProblem | None) -> str | None:
    """Say what is wrong with a name of ROS, and which one would do."""
    if problem is None:
        return None
    better = f": write {problem.suggestion}" if problem.suggestion else ""
    return problem.message + better
