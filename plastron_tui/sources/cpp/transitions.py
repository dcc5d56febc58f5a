"""In which transitions of a managed node its endpoints are made.

Source: https://design.ros2.org/articles/node_lifecycle.html, `rclcpp_lifecycle` of Jazzy.
"""

from __future__ import annotations

from .analysis import Analysis, Site
from .receivers import MANAGED_CLASSES
from .scopes import Function

TRANSITIONS = frozenset(
    {"on_configure", "on_cleanup", "on_shutdown", "on_activate", "on_deactivate", "on_error"}
)
"""The methods that a transition calls."""

# A method of more calls is no helper of one transition.
_MOST_CALLS = 16


class Transitions:
    """The transitions of the managed nodes of a unit, by what they call."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._found: dict[Function, frozenset[str]] = {}

    def of(self, site: Site) -> str | None:
        """Return the transition in which a call is made: None for none, and for several."""
        around = site.call.scope.enclosing("function", "lambda")
        if around is None or around.kind == "lambda" or around.function is None:
            return None
        found = self._of_function(around.function)
        return next(iter(found)) or None if len(found) == 1 else None

    def _of_function(self, function: Function) -> frozenset[str]:
        """Return the transitions that run a function, "" among them where something else may."""
        if function not in self._found:
            # What calls itself is run by what else calls it.
            self._found[function] = frozenset()
            self._found[function] = self._find(function)
        return self._found[function]

    def _find(self, function: Function) -> frozenset[str]:
        analysis = self._analysis
        owner = analysis.unit.class_of_function(function)
        if owner is None or owner.name == function.name:
            return frozenset({""})
        if not analysis.receivers.derives_from(owner, MANAGED_CLASSES):
            return frozenset({""})
        if function.name in TRANSITIONS:
            return frozenset({function.name})
        calls = analysis.callers.of(function)
        if not 0 < len(calls) <= _MOST_CALLS:
            return frozenset({""})
        found: set[str] = set()
        for call in calls:
            around = call.scope.enclosing("function", "lambda")
            if around is None or around.kind == "lambda" or around.function is None:
                return frozenset({""})
            found |= self._of_function(around.function)
        return frozenset(found)
