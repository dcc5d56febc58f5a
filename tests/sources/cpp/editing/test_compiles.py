"""C++ nodes with endpoints of all kinds added, and of other types, compiled without a warning."""

from __future__ import annotations

import pytest
from additions import ACTIONS, each_kind
from cpp_builds import find_rclcpp, find_roscpp
from manners import RCLCPP, ROSCPP, files
from patches import edit, read

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Message, Publication, Publisher, Subscription
from plastron_tui.model.source import EndpointKind, Update, place_of
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

pytestmark = pytest.mark.long(0.5)

AT, INT = Span(0, 0), InterfaceName("std_msgs", "Int32")
FIVE = Publication(Message("m", MessageValue(INT, {"data": 5}), AT), 10.0, AT, True)


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
        sources.append(put(current, folder / name.replace(" ", "_")))
    return sources


def put(current, folder):
    """Write the files of a node, and return the main one."""
    main = folder / "x.cpp"
    main.parent.mkdir(parents=True)
    for file, held in current.texts:
        place_of(main, file).write_bytes(held)
    return main


def of_another_type(endpoint):
    """Return a topic that is published, or heard, with another type."""
    if endpoint.kind is EndpointKind.PUBLISHER:
        return Publisher(endpoint.name, INT, (FIVE,), AT)
    return Subscription(endpoint.name, INT, None, AT)


def retyped(nodes, folder):
    """Write nodes whose topics all have another type, and return their sources."""
    sources = []
    topics = (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
    for name, text in nodes.items():
        current, changed = files(text), 0
        found = [each for each in read(current).endpoints if each.kind in topics and each.name]
        for each in found:
            update = Update(each.kind, each.name, of_another_type(each), AT)
            after, _ = edit(current, update)
            current, changed = (current, changed) if after is None else (after, changed + 1)
        assert changed or not found, name
        sources.append(put(current, folder / name.replace(" ", "_")))
    return sources


def test_roscpp_takes_what_was_added(tmp_path_factory):
    library = find_roscpp(tmp_path_factory)
    library.check(written(ROSCPP, 1, tmp_path_factory.mktemp("added")))


def test_rclcpp_takes_what_was_added(tmp_path_factory):
    library = find_rclcpp(tmp_path_factory)
    library.check(written(RCLCPP, 2, tmp_path_factory.mktemp("added")))


def test_roscpp_takes_other_types(tmp_path_factory):
    library = find_roscpp(tmp_path_factory)
    library.check(retyped(ROSCPP, tmp_path_factory.mktemp("retyped")))


def test_rclcpp_takes_other_types(tmp_path_factory):
    library = find_rclcpp(tmp_path_factory)
    library.check(retyped(RCLCPP, tmp_path_factory.mktemp("retyped")))
