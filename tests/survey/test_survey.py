"""The survey of real nodes on those of this machine, and its checks on edits gone wrong."""

from __future__ import annotations

import shutil
import sys
from collections import Counter
from pathlib import Path

import machine
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts"))

import survey_checks
import survey_nodes
from file_sets import one

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Add, EndpointKind, Remove
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.targets import read_source

NODE = """\
import rospy
from std_msgs.msg import Bool, Int32


class Switch:
    def __init__(self):
        self.pub = rospy.Publisher('on', Bool, queue_size=1)
        self.sub = rospy.Subscriber('count', Int32, self.count)

    def count(self, message):
        self.pub.publish(message.data > 3)


rospy.init_node('switch')
Switch()
rospy.spin()
"""
NODES = Path(__file__).parents[1] / "nodes"
PINNED = (
    "rclpy/fibonacci_action_server.py", "rclpy/parameters.py", "rclpy/timers.py",
    "rospy/add_client.py", "rospy/class_hierarchy.py", "rospy/fleets_in_loops.py",
    "rospy/laser_filter.py", "rospy/pid_controller.py", "rospy/stereo_sync.py",
)  # fmt: skip
AT = Span(0, 0)
ADD = Add(Subscription("more", InterfaceName("std_msgs", "Bool"), "count", AT))
REMOVE = Remove(EndpointKind.PUBLISHER, "on", AT)
SUBSCRIPTION = "        self.sub = rospy.Subscriber('count', Int32, self.count)\n"
MORE = "        self.more = rospy.Subscriber('more', Bool, self.count)\n"
PUBLISHER = "        self.pub = rospy.Publisher('on', Bool, queue_size=1)\n"


def text(source: str) -> survey_checks.Text:
    found = read_source(Path("switch.py"), one(source.encode())).source
    assert found is not None
    return survey_checks.Text(found)


def problems(after: str, change: Add | Remove) -> list[str]:
    return list(survey_checks.check(text(NODE), text(after), change))


def surveyed(capsys: pytest.CaptureFixture[str], *folders: str) -> Counter[str]:
    """Make every edit on the nodes of some folders; return the numbers of the table."""
    status = survey_nodes.main(folders)
    output = capsys.readouterr()
    assert (status, output.err) == (0, "")
    lines = (line.rpartition(" ") for line in output.out.splitlines())
    return Counter({name.strip(): int(count) for name, _, count in lines})


@pytest.mark.long
def test_nodes_keep_all_that_no_edit_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in PINNED:
        shutil.copy(NODES / name, tmp_path)
    counts = surveyed(capsys, str(tmp_path))
    assert counts["files"] == len(PINNED)
    assert counts["edits"] >= 100


@pytest.mark.long
def test_the_nodes_of_this_machine_keep_all_that_no_edit_asked_for(
    capsys: pytest.CaptureFixture[str],
) -> None:
    counts = surveyed(capsys)
    if counts["files"] < 20:
        machine.skip_or_fail(
            "few nodes here: apt-get install python3-actionlib python3-tf python3-rostest"
        )
    assert counts["edits"] >= 150


@pytest.mark.parametrize(
    ("after", "change", "expected"),
    [
        (NODE.replace(SUBSCRIPTION, SUBSCRIPTION + MORE), ADD, None),
        (NODE, ADD, "adds - instead of more"),
        (NODE.replace(SUBSCRIPTION, MORE), ADD, "loses endpoints: subscriptions count"),
        (NODE.replace(SUBSCRIPTION, SUBSCRIPTION + MORE + MORE), ADD, "adds subscriptions more"),
        (
            NODE.replace(SUBSCRIPTION, SUBSCRIPTION + MORE.replace("self.count", "self.on_more")),
            ADD,
            "leaves attributes that nothing sets: on_more",
        ),
        (
            NODE.replace(SUBSCRIPTION, SUBSCRIPTION + MORE).replace("data > 3", "data > 4"),
            ADD,
            "changes b'        self.pub.publish",
        ),
        (NODE.replace(SUBSCRIPTION, SUBSCRIPTION + MORE + "        )(\n"), ADD, "parses worse"),
        (
            NODE.replace(PUBLISHER, "").replace("        self.pub.publish", "        print"),
            REMOVE,
            "changes b'        self.pub.publish",
        ),
        (NODE.replace(PUBLISHER, ""), REMOVE, "leaves attributes that nothing sets: pub"),
        (
            NODE.replace(PUBLISHER, "").replace("self.pub.publish(message.data > 3)", "pass"),
            REMOVE,
            None,
        ),
        (
            NODE.replace(PUBLISHER, "")
            .replace("self.pub.publish(message.data > 3)", "pass")
            .replace("rospy.spin()\n", ""),
            REMOVE,
            "takes b'rospy.spin()",
        ),
    ],
)
def test_each_check_sees_what_it_is_for(
    after: str, change: Add | Remove, expected: str | None
) -> None:
    found = problems(after, change)
    if expected is None:
        assert found == []
    else:
        assert any(expected in problem for problem in found), found


@pytest.mark.parametrize(
    ("after", "expected"),
    [
        (NODE.replace("import Bool, Int32", "import Int32"), "F821 Undefined name `Bool`"),
        (NODE.replace("Bool, queue_size=1", "Int32, queue_size=1"), "std_msgs.msg.Bool"),
        (NODE, ""),
    ],
)
def test_names_without_a_binding_and_imports_without_a_use_are_seen(
    after: str, expected: str, tmp_path: Path
) -> None:
    found = list(
        survey_checks.names_at_fault([("an edit", NODE.encode(), after.encode())], tmp_path)
    )
    assert expected in "".join(found)
    assert bool(found) == bool(expected)
