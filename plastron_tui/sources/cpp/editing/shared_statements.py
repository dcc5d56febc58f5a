"""Statements that create several endpoints, of which one is to go."""

from __future__ import annotations

from collections.abc import Collection

from plastron_tui.diagnostics import listed
from plastron_tui.model.source import EndpointKind, Remove

from ..analysis import Analysis, Site
from .deletions import Deletions
from .refusals import RefusedError, refuse_parts

_READING = frozenset(
    {"param", "getParam", "getParamCached", "get", "getCached"}
    | {"get_parameter", "get_parameter_or"}
)


class SharedStatements:
    """What else the statements create that go.

    Args:
        analysis: the files.
        change: what is asked for.
        going: the call sites that go in any case.
        gone: what goes.
    """

    def __init__(
        self, analysis: Analysis, change: Remove, going: Collection[Site], gone: Deletions
    ) -> None:
        self._analysis = analysis
        self._change = change
        self._going = going
        self._gone = gone

    def created_with(self, site: Site) -> list[Site]:
        """Return what else a call creates, which goes too.

        Raises:
            RefusedError: it stays.
        """
        found = [each for each in self._analysis.sites if each.call is site.call]
        found = [each for each in found if each is not site]
        if any(each not in self._going for each in found):
            refuse_parts(self._change, [site])
        self._check(site, [each for each in found if each not in self._going])
        return found

    def gone_with(self, site: Site, lost: Collection[Site]) -> list[Site]:
        """Return what goes with a statement that creates an endpoint.

        A parameter that such a statement reads, and that another one declares or reads, stays.

        Args:
            site: the endpoint.
            lost: the call sites that are known to go.

        Raises:
            RefusedError: something of it is to stay.
        """
        found = [
            each
            for each in self._analysis.sites
            if each not in lost and self._gone.covers(each.file, each.call.node.start_byte)
        ]
        found = [each for each in found if each.endpoint.name is None or not self._is_asked(each)]
        self._check(
            site,
            [each for each in found if each not in self._going and not self._stays(each)],
        )
        return found

    def _is_asked(self, site: Site) -> bool:
        """Tell whether a call site is of what is asked to go, and is taken out by itself."""
        endpoint, change = site.endpoint, self._change
        return endpoint.kind is change.kind and endpoint.label == change.name

    def _stays(self, site: Site) -> bool:
        """Tell whether a parameter is in the files without one call that reads it."""
        endpoint = site.endpoint
        if endpoint.kind is not EndpointKind.PARAMETER or site.call.name not in _READING:
            return False
        return endpoint.name is not None and any(
            each.endpoint.kind is EndpointKind.PARAMETER
            and each.endpoint.name == endpoint.name
            and not self._gone.covers(each.file, each.call.node.start_byte)
            for each in self._analysis.sites
        )

    def _check(self, site: Site, others: Collection[Site]) -> None:
        if not others:
            return
        names = dict.fromkeys(
            f"the {each.endpoint.kind.word} `{each.endpoint.label or each.endpoint.expression}`"
            for each in others
        )
        change, line = self._change, site.endpoint.line
        what = f"the {change.kind.word} `{change.kind.written(change.name)}`"
        message = f"line {line} creates {what} with {listed(names)}"
        remedy = "take what it creates out together, or change the line by hand"
        raise RefusedError(message, change.span, remedy)
