"""How long reading and editing a hand-written node takes, in milliseconds within a process."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from statistics import median

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Add, Change, EndpointKind, FileSet, Remove
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.text_memo import MEMO
from plastron_tui.targets import find_target, read_source

from .row import Row, seconds

_HEAD = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import Float32, String


class Arm:
    def __init__(self):
        self.mode = rospy.get_param('~mode', 'slow')
"""
_JOINT = """\
        self.pub_{i} = rospy.Publisher('joint_{i}/state', Float32, queue_size=10)
        rospy.Subscriber('joint_{i}/command', Float32, self.on_joint_{i})
"""
_CALLBACK = """
    def on_joint_{i}(self, msg):
        # the joint goes no further than its stops
        angle = max(-1.5, min(1.5, msg.data))
        for step in range(10):
            if abs(angle - step * 0.1) < 0.05:
                rospy.logdebug('joint {i} is near step %d', step)
        self.pub_{i}.publish(angle)
"""
_TAIL = """

if __name__ == '__main__':
    rospy.init_node('arm')
    Arm()
    rospy.spin()
"""
_JOINTS = 96


def node() -> bytes:
    """A node of a thousand lines, with some two hundred endpoints."""
    joints = range(_JOINTS)
    text = (
        _HEAD
        + "".join(_JOINT.format(i=i) for i in joints)
        + "".join(_CALLBACK.format(i=i) for i in joints)
        + _TAIL
    )
    assert 950 <= text.count("\n") <= 1_100, text.count("\n")
    return text.encode()


def rows() -> Iterator[Row]:
    text, path = node(), Path("arm.py")
    target = find_target("rospy")
    assert target is not None
    catalog = Catalog("noetic")
    changes: tuple[Change, ...] = (
        Remove(EndpointKind.SUBSCRIPTION, "joint_40/command"),
        Add(Subscription("mode", InterfaceName("std_msgs", "String"), "on_mode", Span(0, 0))),
    )
    files = FileSet.single(".py", text)

    def inspect() -> float:
        """Time the first reading of the text, of which nothing is known yet."""
        MEMO.clear()
        return seconds(lambda: read_source(path, files)) * 1e3

    first = inspect()
    read = [inspect() for _ in range(15)]
    yield Row("inspect of a 1,000-line node, the first in a process", first, 50, "ms")
    yield Row("inspect of a 1,000-line node", median(read), 50, "ms")
    source = read_source(path, files).source
    assert source is not None
    assert target.edit(source, changes, catalog).files is not None
    edit = []
    for _ in range(15):
        # What is edited was read before; nothing of what comes of it was.
        inspect()
        edit.append(seconds(lambda: target.edit(source, changes, catalog)) * 1e3)
    yield Row("edit of a 1,000-line node, two statements", median(edit), 100, "ms")
