"""What the files say of their endpoints beside name, type and callback."""

from __future__ import annotations

from plastron_tui.model.source import SourceEndpoint

from .analysis import Analysis, Site


class Details:
    """What the files of one unit say."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis

    def of(self, site: Site) -> SourceEndpoint:
        """Return the endpoint of a call site with all that is known of it."""
        return site.endpoint
