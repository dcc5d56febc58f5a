"""What a file says of its endpoints beside name, type and callback, for all kinds."""

from __future__ import annotations

from plastron_tui.model.endpoint_details import EndpointDetails
from plastron_tui.model.source import EndpointKind, SourceEndpoint

from .action_callbacks import action_details
from .analysis import Analysis, Site
from .evaluation import Evaluator
from .functions import callback_scope
from .generated import serves
from .parameter_details import parameter_details
from .runs import EVERYWHERE
from .timers import timer_details
from .transitions import Transitions

# The uses of each are looked for in the whole file.
_MOST_ACTIONS = 16


class Details:
    """What one file says; what was found out for an endpoint serves the next one."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._actions = 0
        self._evaluator = Evaluator(analysis)
        self._transitions = Transitions(analysis)

    def of(self, site: Site) -> SourceEndpoint:
        """Return the endpoint of a call site with all that is known of it."""
        world = site.passes[0] if site.passes else EVERYWHERE
        with self._analysis.resolver.during(world):
            details = self._details(site)
        return site.endpoint._replace(details=details, transition=self._transitions.of(site))

    def _details(self, site: Site) -> EndpointDetails | None:
        match site.endpoint.kind:
            case EndpointKind.PARAMETER:
                return parameter_details(self._analysis, site, self._evaluator)
            case EndpointKind.TIMER:
                found = timer_details(self._analysis, site, self._evaluator)
                function = callback_scope(self._analysis, site)
                return found._replace(serves=serves(self._analysis, function))
            case EndpointKind.ACTION_SERVER | EndpointKind.ACTION_CLIENT:
                self._actions += 1
                return action_details(self._analysis, site, self._actions <= _MOST_ACTIONS)
            case _:
                return None
