"""All panels, in the order of their tabs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .graph_panel import GRAPH
from .live_panel import LIVE
from .messages import MESSAGES
from .nodes import NODES
from .output import OUTPUT
from .packages import PACKAGES
from .preview_panel import PREVIEW
from .problems import PROBLEMS
from .robot_panel import ROBOTS
from .services import SERVICES
from .topics import TOPICS

if TYPE_CHECKING:
    from ..analysis import Analysis
    from .panel import Request

PANELS = (
    NODES, TOPICS, SERVICES, MESSAGES, PREVIEW, GRAPH, PACKAGES, ROBOTS, LIVE, PROBLEMS, OUTPUT,
)  # fmt: skip

BY_NAME = {panel.name: panel for panel in PANELS}


def counts(analysis: Analysis) -> dict[str, int]:
    """Count what is in each panel."""
    return {panel.name: panel.count(analysis) for panel in PANELS if panel.count is not None}


def make(analysis: Analysis, request: Request) -> None:
    """Make what a panel asked for, once."""
    function = BY_NAME[request.panel].make
    assert function is not None
    analysis.once(request, lambda: function(analysis, request.what))
