"""A managed node's file that was changed by hand gets what the program changes, and stays one."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from merging_driver import INT, KEEP, KEPT, PUBLISH, STRING, Folder, check, check_again

from plastron_tui.model.source import SourceNode
from plastron_tui.targets import find_target

BEFORE = (KEEP, f"{PUBLISH} at 2 hz")
AFTER = (
    *BEFORE,
    "n publish five to 'b' of message_type Int32 at 4 hz",
    "subscribe n to 'c' of message_type String",
)
THERE = [*KEPT, ("publishers", "a", STRING)]


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    return Folder(tmp_path, "rclpy")


def node_of(folder: Folder) -> SourceNode:
    """Return the node that the file holds."""
    target = find_target("rclpy")
    assert target is not None
    source = target.read(folder.file(), one(folder.file().read_bytes())).source
    assert source is not None
    [node] = source.nodes
    return node


def test_what_is_added_is_made_and_destroyed_by_transitions(folder: Folder) -> None:
    folder.is_managed = True
    folder.generate(*BEFORE)
    mine = folder.fill()
    assert folder.generate(*AFTER).conflicts == []
    check(folder, mine, [*THERE, ("publishers", "b", INT), ("subscriptions", "c", STRING)])
    made = {each.name: each.transition for each in node_of(folder).endpoints if each.type}
    assert set(made.values()) == {"on_configure"}
    text = folder.file().read_text()
    for name in ("a_publisher", "b_publisher", "c_subscription", "a_timer", "b_timer"):
        assert text.count(f"(self.{name})\n") == 1
    check_again(folder, *AFTER)


@pytest.mark.parametrize("is_managed", [True, False])
def test_a_node_that_nobody_edited_becomes_managed_or_is_no_longer(
    folder: Folder, is_managed: bool
) -> None:
    folder.is_managed = not is_managed
    folder.generate(*BEFORE)
    folder.is_managed = is_managed
    outcome = folder.generate(*BEFORE)
    assert (outcome.warnings, outcome.conflicts) == ([], [])
    assert node_of(folder).is_managed is is_managed
    check_again(folder, *BEFORE)


def test_handwork_comes_along_by_lines(folder: Folder) -> None:
    folder.generate(*BEFORE)
    mine = folder.fill()
    folder.is_managed = True
    assert folder.generate(*AFTER).conflicts == []
    assert node_of(folder).is_managed
    check(folder, mine, [*THERE, ("publishers", "b", INT), ("subscriptions", "c", STRING)])
    check_again(folder, *AFTER)


@pytest.mark.parametrize(("is_managed", "now"), [(True, "managed now"), (False, "no longer")])
def test_handwork_in_the_same_lines_is_a_conflict(
    folder: Folder, is_managed: bool, now: str
) -> None:
    folder.is_managed = not is_managed
    folder.generate(*BEFORE)
    folder.edit('"a", 10)', '"a", 5)')
    before = folder.file().read_text()
    folder.is_managed = is_managed
    [conflict] = folder.generate(*BEFORE).conflicts
    assert conflict.startswith("file-conflict") and now in conflict
    assert folder.file().read_text() == before


ASKING = {
    "once": "n client_requests 'd' of service_type Trigger with input none",
    "again": "n client_requests 'd' of service_type Trigger with input none at 2 hz",
    "goal": "n sends_goal to 'd' of action_type Fibonacci with input order=5",
    "server": "n provides_action 'd' of action_type Fibonacci",
}


@pytest.mark.parametrize("statement", ASKING.values(), ids=ASKING)
def test_what_asks_others_comes_and_goes_beside_handwork(folder: Folder, statement: str) -> None:
    folder.is_managed = True
    folder.generate(*BEFORE)
    logged = '        self.get_logger().info(f"kept: {message}")\n'
    folder.edit(logged, f"{logged}        self.count = 1  # mine\n")
    edited = folder.file().read_text()
    assert folder.generate(*BEFORE, statement).conflicts == []
    assert node_of(folder).is_managed
    assert "self.count = 1  # mine" in folder.file().read_text()
    made = {each.name: each.transition for each in node_of(folder).endpoints if each.type}
    assert made["d"] == "on_configure"
    assert "        self.end_tasks()\n" in folder.file().read_text()
    check_again(folder, *BEFORE, statement)
    assert folder.generate(*BEFORE).conflicts == []
    assert folder.file().read_text() == edited
