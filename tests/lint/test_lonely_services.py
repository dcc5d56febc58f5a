"""Services that nobody provides, and types that have moved, in workspaces of several packages."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph_packages import (
    LISTENER,
    TALKER,
    alone,
    code_of,
    found_in,
    in_python,
    node_of,
    package_of,
)

NAME = "self.get_parameter('name').value"
LONELY_CLIENTS = {
    "of_a_name_of_its_own": ("'camera/status'", "", ["RG109"]),
    "of_a_name_that_each_node_has": ("'camera/get_loggers'", "", []),
    "of_what_the_package_may_provide": (
        "'camera/status'",
        f"self.create_service(Trigger, {NAME}, print)",
        [],
    ),
    "where_another_type_is_provided": (
        "'camera/status'",
        f"self.create_service(SetBool, {NAME}, print)",
        ["RG109"],
    ),
    "where_another_one_calls": (
        "'camera/status'",
        f"self.create_client(Trigger, {NAME})",
        ["RG109"],
    ),
    "where_a_topic_has_the_name": (
        "'camera/status'",
        f"self.create_subscription(Trigger, {NAME}, print, 10)",
        ["RG109"],
    ),
}


@pytest.mark.parametrize(("name", "more", "told"), LONELY_CLIENTS.values(), ids=LONELY_CLIENTS)
def test_a_service_that_nobody_provides_is_told_where_it_is_asked_for(
    tmp_path: Path, name: str, more: str, told: list[str]
) -> None:
    types = "from std_srvs.srv import SetBool, Trigger\n"
    listener = types + code_of(LISTENER, before=f"self.create_client(Trigger, {name})")
    files = package_of(types + code_of(TALKER, more=more or "pass"), listener)
    assert [code for code, _, _ in found_in(tmp_path, files, "RG109")] == told
    elsewhere = alone("other", "rclpy", types + code_of(TALKER, more=more or "pass"))
    files = package_of(listener=listener) | elsewhere
    is_own = name.endswith("loggers'")
    found = found_in(tmp_path / "2", files, "RG109")
    assert [code for code, _, _ in found] == ([] if is_own else ["RG109"])


def test_a_service_whose_name_is_known_but_for_remaps_is_no_other_one(tmp_path: Path) -> None:
    types = "from std_srvs.srv import Trigger\n"
    talker = types + code_of(TALKER, more="self.create_service(Trigger, 'other', print)")
    listener = types + code_of(LISTENER, before="self.create_client(Trigger, 'camera')")
    remapped = node_of("talker", "remappings=[('other', LaunchConfiguration('to'))]")
    files = package_of(talker, listener, all_py=in_python(remapped))
    assert [code for code, _, _ in found_in(tmp_path, files, "RG109")] == ["RG109"]


MOVED = {
    "of_one_name": ("GoalStatusArray", "GoalStatusArray", 0),
    "of_two_names": ("GoalID", "GoalInfo", 1),
}


@pytest.mark.parametrize(("old", "new", "count"), MOVED.values(), ids=MOVED)
def test_a_type_that_may_have_moved_to_another_package(
    tmp_path: Path, old: str, new: str, count: int
) -> None:
    talker = f"from actionlib_msgs.msg import {old}\n" + code_of(TALKER, type=old)
    listener = f"from action_msgs.msg import {new}\n" + code_of(LISTENER, type=new)
    files = {**alone("talks", "rclpy", talker), **alone("hears", "talks", listener)}
    assert len(found_in(tmp_path, files, "RG101")) == count
    nodes = in_python(node_of("talker"), node_of("listener"))
    files = package_of(talker, listener, all_py=nodes)
    assert len(found_in(tmp_path / "2", files, "RG101")) == 1
