"""Publishers of rospy that say no `queue_size`."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis

from .unconditional import is_dead


def without_queue(analysis: Analysis) -> Iterator[tuple[str, Span]]:
    """Yield the file, "" for the main one, and the place of each publisher that says none.

    It says none with `None`, too, which is what `rospy.Publisher` takes by itself.
    """
    if analysis.library.module != "rospy":
        return
    for site in analysis.first_sites():
        said = site.shape.qos
        queue_size = None if said is None else said.queue_size
        if site.endpoint.kind is not EndpointKind.PUBLISHER or queue_size is None:
            continue
        if is_dead(site.call):
            continue
        arguments = site.arguments
        given = arguments.get(queue_size)
        if not arguments.is_open and (given is None or given.type == "none"):
            yield site.endpoint.file, site.endpoint.span
