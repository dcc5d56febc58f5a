"""Where launch files name what they start, to tell what nobody has."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping

from plastron_tui.diagnostics import Span
from plastron_tui.lint.tree import LaunchFacts, PackageFacts, StartedPlace

_KEYS = {
    "package": rb"pkg|package|node_package",
    "executable": rb"exec|executable|node_executable|type|plugin|node_plugin",
}
_VALUE = rb"(?<![\w-])(?:%b)[\"']?\s*[=:]\s*[\"']?(%b)(?=[\"'\s,)/>\]}]|$)"


def started_places(
    launches: Iterable[LaunchFacts],
    packages: Mapping[str, PackageFacts],
    text_of: Callable[[str], bytes | None],
) -> Iterator[tuple[StartedPlace, Span]]:
    """Yield where launch files name packages and programs that the workspace does not have.

    What is written otherwise, or several times within one node, has no place.
    """
    for launch in launches:
        for started in launch.resolved.started:
            package = packages.get(started.package)
            if package is not None and started.executable in package.executables:
                continue
            if started.file is None or started.place is None:
                continue
            key = "package" if package is None else "executable"
            word = started.package if package is None else started.executable
            text = text_of(started.file)
            if text is None:
                continue
            pattern = re.compile(_VALUE % (_KEYS[key], re.escape(word.encode())))
            found = list(pattern.finditer(text, started.place.start, started.place.end))
            if len(found) == 1:
                place = StartedPlace(started.file, started.place.start, word)
                yield place, Span(*found[0].span(1))
