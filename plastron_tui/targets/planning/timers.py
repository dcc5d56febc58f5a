"""Functions that a node repeats."""

from __future__ import annotations

from plastron_tui.model.kinds import Timer
from plastron_tui.sources import naming

from .periods import planned_timer
from .plan import NodePlan
from .writing import Writing


def add_timers(writing: Writing, plan: NodePlan) -> None:
    """Plan what a node repeats."""
    for timer in writing.node.of(Timer).values():
        assert timer.rate is not None  # statements give one
        planned = planned_timer(writing, timer.rate, timer.name, f"{timer.name}_timer")
        label = naming.label(timer.name, "it")
        plan.timers.append(planned._replace(label=label, is_function=True))
