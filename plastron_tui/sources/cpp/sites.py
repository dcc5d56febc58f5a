"""Where the files of a unit create endpoints."""

from __future__ import annotations

from collections.abc import Iterator

from .analysis import Analysis, Site
from .created import created_by
from .finder import Finder
from .found import Found
from .scopes import Variable, last_name
from .transforms import transforms

MOST_SITES = 4_000
"""A file with more calls that create endpoints was generated, and is not read."""


def find_sites(analysis: Analysis) -> None:
    """Find the calls that create endpoints; none where there are more than `MOST_SITES`."""
    finder = Finder(analysis)
    order = {id(file): at for at, file in enumerate(analysis.unit.files)}
    is_run = analysis.callers.is_run
    found = [
        each
        for each in finder.found()
        if not each.call.scope.file.is_beside and is_run(each.call.scope)
    ]
    analysis.calls_found = len(found)
    found.sort(key=lambda each: (order[id(each.call.scope.file)], each.call.node.start_byte))
    if len(found) > MOST_SITES:
        return
    for each in found:
        analysis.sites.extend(_sites(analysis, each))
    analysis.sites.extend(transforms(analysis))
    analysis.sites.sort(key=lambda each: (order[id(each.file)], each.endpoint.span.start))


def _sites(analysis: Analysis, found: Found) -> Iterator[Site]:
    variable = _variable(analysis, found)
    for endpoint, callback, bindings in created_by(analysis, found):
        yield Site(
            endpoint,
            found.call,
            found.shape,
            found.arguments,
            found.owner,
            variable,
            callback,
            bindings,
            found.options,
        )


def _variable(analysis: Analysis, found: Found) -> Variable | None:
    if found.handle is None:
        return None
    name = last_name(found.handle, found.scope)
    return analysis.unit.lookup(name, found.scope, found.handle.start_byte) if name else None
