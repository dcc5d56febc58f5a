"""Launch files: what starts nodes together."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from plastron_tui.diagnostics import Span


@dataclass(slots=True)
class Launch:
    """A launch file, as the program has it so far."""

    name: str
    variable: str
    span: Span
    starts: dict[str, object] = field(default_factory=dict)


class LaunchGeneration(NamedTuple):
    """A `generate_launch`: the launch file as it was then."""

    launch: Launch
    span: Span
