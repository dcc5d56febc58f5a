"""C++ nodes with all kinds of endpoints added, compiled without a warning."""

from __future__ import annotations

import pytest
from additions import ACTIONS, each_kind
from cpp_builds import find_rclcpp, find_roscpp
from manners import RCLCPP, ROSCPP, files
from patches import edit

from plastron_tui.model.source import place_of

pytestmark = pytest.mark.long(0.5)


def written(nodes, version, folder):
    """Write nodes with all that can be added to them, and return their sources."""
    sources = []
    for name, text in nodes.items():
        current = files(text)
        for change in each_kind(version).values():
            # The stand-in of rclcpp, and the interface packages of the wheels, have no actions.
            is_action = str(change.endpoint.type) == ACTIONS[version][0]
            changed = None if is_action and version == 2 else edit(current, change)[0]
            current = current if changed is None else changed
        main = folder / name.replace(" ", "_") / "x.cpp"
        main.parent.mkdir(parents=True)
        for file, held in current.texts:
            place_of(main, file).write_bytes(held)
        sources.append(main)
    return sources


def test_roscpp_takes_what_was_added(tmp_path_factory):
    library = find_roscpp(tmp_path_factory)
    library.check(written(ROSCPP, 1, tmp_path_factory.mktemp("added")))


def test_rclcpp_takes_what_was_added(tmp_path_factory):
    library = find_rclcpp(tmp_path_factory)
    library.check(written(RCLCPP, 2, tmp_path_factory.mktemp("added")))
