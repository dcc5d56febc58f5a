"""Where launch files name what they start, to tell what nobody has."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from plastron_tui.diagnostics import Span
from plastron_tui.lint.tree import LaunchFacts, PackageFacts, StartedPlace


def started_places(
    launches: Iterable[LaunchFacts], packages: Mapping[str, PackageFacts]
) -> Iterator[tuple[StartedPlace, Span]]:
    """Yield where launch files name packages and programs that the workspace does not have.

    What is put together, or written with references or escapes, has no place.
    """
    for launch in launches:
        for started in launch.resolved.started:
            package = packages.get(started.package)
            if package is not None and started.executable in package.executables:
                continue
            span = started.package_span if package is None else started.executable_span
            if started.file is not None and started.place is not None and span is not None:
                word = started.package if package is None else started.executable
                yield StartedPlace(started.file, started.place.start, word), span
