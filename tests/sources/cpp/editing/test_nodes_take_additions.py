"""Each kind of endpoint, added to each hand-written node in C++ of tests/nodes."""

from __future__ import annotations

from pathlib import Path

import pytest
from additions import each_kind
from patches import CATALOGS, LIBRARIES

from plastron_tui.sources.cpp.editing.editor import edit_cpp
from plastron_tui.targets import files_of, read_source

pytestmark = pytest.mark.long

NODES = Path(__file__).parents[3] / "nodes"
SOURCES = sorted(path for library in LIBRARIES for path in (NODES / library).rglob("*.cpp"))
PARTS = {
    "roscpp/tracker/src/callbacks.cpp",
    "nodelet/detector/src/detect.cpp",
    "nodelet/split_setup/src/callbacks.cpp",
    "rclcpp/localizer/src/callbacks.cpp",
    "component/elevation/src/work.cpp",
    "component/split_component/src/station_callbacks.cpp",
}
"""Sources of nodes that another source makes, and creates the endpoints of."""
LATCHED = ("roscpp/functional_style.cpp", "message once")
"""What publishes to the same topic already, and keeps nothing for who listens later."""

BRIEF = "roscpp/parameters.cpp"
"""What ends at once, and calls nothing back."""
CALLED_BACK = {
    "message in the file's loop",
    "message at a rate",
    "subscription",
    "service",
    "service with an answer",
    "timer",
    "action server",
    "goal",
}


def _read(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _reason(name: str, what: str) -> str:
    """Return the start of the message of a refusal that has to be, "" where there is none."""
    if name in PARTS:
        return "the file has no place"
    if name == BRIEF and what in CALLED_BACK:
        return "`main` in line"
    return "the publisher of" if (name, what) == LATCHED else ""


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(NODES)))
def test_a_node_takes_each_kind_or_says_why_not(path: Path) -> None:
    source = read_source(path, files_of(path, path.read_bytes(), _read)).source
    if source is None or not any(True for _ in source.endpoints):
        return
    version = LIBRARIES[source.library]
    name = str(path.relative_to(NODES))
    for node in source.nodes:
        label = node.label if len(source.nodes) > 1 else None
        for what, change in each_kind(version).items():
            done = edit_cpp(source, [change._replace(node=label)], CATALOGS[version])
            wanted = _reason(name, what)
            messages = [each.message for each in done.diagnostics]
            assert (done.files is None) == bool(wanted), (label, what, messages)
            if not wanted:
                continue
            (told,) = done.diagnostics
            assert told.message.startswith(wanted), (what, told.message)
            assert told.help and told.span, what
            assert " line " in told.message or name in PARTS, told.message
