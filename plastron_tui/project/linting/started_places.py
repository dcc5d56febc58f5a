"""Where launch files name what they start, to tell what nobody has."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

from plastron_tui.diagnostics import Span
from plastron_tui.lint.tree import LaunchFacts, PackageFacts, StartedPlace
from plastron_tui.ros.launch_started import Started


def started_places(
    launches: Iterable[LaunchFacts],
    unstarted: Iterable[Started],
    packages: Mapping[str, PackageFacts],
) -> Iterator[tuple[StartedPlace, Span]]:
    """Yield where launch files name packages and programs that the workspace does not have.

    What is put together, or written with references or escapes, has no place.

    Args:
        launches: the launch files, with what they start.
        unstarted: what they start where their arguments are others.
        packages: the packages of the workspace, by name.
    """
    started_at_once = (each for launch in launches for each in launch.resolved.started)
    for started in chain(started_at_once, unstarted):
        package = packages.get(started.package)
        if package is not None and started.executable in package.executables:
            continue
        span = started.package_span if package is None else started.executable_span
        if started.file is not None and started.place is not None and span is not None:
            word = started.package if package is None else started.executable
            yield StartedPlace(started.file, started.place.start, word), span
