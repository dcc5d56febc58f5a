"""A robot that drives as long as its way is free stops whenever that is not sure."""

from __future__ import annotations

import ast
import math
import re
from types import SimpleNamespace

import pytest

from plastron_tui.session import Options, Session

HEAD = """\
create_node 'driver' as driver
subscribe driver to 'scan' of message_type sensor_msgs/TYPE
create_message go of message_type Twist and input linear.x=0.2
create_message halt of message_type Twist and input none
"""
SENT = "driver publish {} to 'cmd_vel' of message_type Twist for_each 'scan' when {}\n"
GO, HALT = "all received.ranges > 0.5", "any received.ranges < 0.5"
FAR, NEAR = "received.range > 0.5", "received.range < 0.5"


def conditions(type_: str, sent: list[tuple[str, str]], library: str) -> list[str]:
    """Return the conditions under which messages are sent in a new node, in their order."""
    lines = "".join(SENT.format(*each) for each in sent)
    program = f"{HEAD.replace('TYPE', type_)}{lines}generate_node driver\n"
    plan, found = Session(program.encode(), None, Options(library), environ={}).plan()
    assert not found
    text = next(each.text for each in plan.files if each.name.endswith((".py", ".cpp"))).decode()
    if library.endswith("cpp"):
        return re.findall(r"if \((.+?)\) \{ geometry_msgs", " ".join(text.split()))
    tests = (each.test for each in ast.walk(ast.parse(text)) if isinstance(each, ast.If))
    return [found for each in tests if "0.5" in (found := ast.unparse(each)) or "0.6" in found]


RANGES = [
    ([2.0, 3.0], True), ([2.0, 0.3], False), ([0.5], False), ([2.0, 0.5], False), ([], False),
    ([math.nan], False), ([2.0, math.nan], False), ([math.inf], True), ([-math.inf], False),
]  # fmt: skip


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
@pytest.mark.parametrize("sent", [[("go", GO), ("halt", HALT)], [("halt", HALT), ("go", GO)]])
def test_a_scan_lets_a_robot_either_drive_or_stop(
    library: str, sent: list[tuple[str, str]]
) -> None:
    found = dict(
        zip([name for name, _ in sent], conditions("LaserScan", sent, library), strict=True)
    )
    for ranges, is_free in RANGES:
        names = {"received": SimpleNamespace(ranges=ranges)}
        said = {name: eval(condition, dict(names)) for name, condition in found.items()}
        assert said == {"go": is_free, "halt": not is_free}, ranges


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
@pytest.mark.parametrize(("distance", "is_free"), [(1.0, True), (0.5, False), (math.nan, False)])
def test_so_does_a_single_distance(library: str, distance: float, is_free: bool) -> None:
    go, halt = conditions("Range", [("go", FAR), ("halt", NEAR)], library)
    names = {"received": SimpleNamespace(range=distance)}
    assert (eval(go, dict(names)), eval(halt, dict(names))) == (is_free, not is_free)


@pytest.mark.parametrize("library", ["rclcpp", "roscpp"])
def test_in_cpp_it_is_the_same(library: str) -> None:
    go, halt = conditions("LaserScan", [("go", GO), ("halt", HALT)], library)
    assert "!received.ranges.empty() && std::all_of(" in go and "return each > 0.5;" in go
    assert halt.replace(" ", "") == f"!({go.replace(' ', '')})"


@pytest.mark.parametrize(
    "sent",
    [[("halt", HALT)], [("go", GO), ("go", HALT)], [("halt", GO), ("halt", HALT)],
     [("go", "all received.ranges > 0.6"), ("halt", HALT)],
     [("go", "all received.intensities > 0.5"), ("halt", HALT)]],
)  # fmt: skip
def test_what_is_no_stop_of_that_is_sent_as_it_says(sent: list[tuple[str, str]]) -> None:
    assert not any(each.startswith("not") for each in conditions("LaserScan", sent, "rclpy"))
