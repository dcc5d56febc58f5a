"""What the files of a unit say of its endpoints beside name, type and callback."""

from __future__ import annotations

from plastron_tui.model.endpoint_details import EndpointDetails
from plastron_tui.model.source import EndpointKind, SourceEndpoint

from .action_details import action_details
from .analysis import Analysis, Site
from .parameter_details import parameter_details
from .timers import timer_details
from .transitions import Transitions

# The uses of each are looked for in all files.
_MOST_ACTIONS = 16


class Details:
    """What the files of one unit say."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._actions = 0
        self._transitions = Transitions(analysis)

    def of(self, site: Site) -> SourceEndpoint:
        """Return the endpoint of a call site with all that is known of it."""
        unit = self._analysis.unit
        unit.bindings = {function: (call, {}) for function, call in site.bindings}
        found = site.endpoint._replace(
            details=self._details(site), transition=self._transitions.of(site)
        )
        unit.bindings = {}
        return found

    def _details(self, site: Site) -> EndpointDetails | None:
        match site.endpoint.kind:
            case EndpointKind.PARAMETER:
                return parameter_details(self._analysis, site)
            case EndpointKind.TIMER:
                return timer_details(self._analysis, site)
            case EndpointKind.ACTION_SERVER | EndpointKind.ACTION_CLIENT:
                self._actions += 1
                return (
                    action_details(self._analysis, site) if self._actions < _MOST_ACTIONS else None
                )
            case _:
                return None
