"""Files of Python 2, which nodes of ROS 1 were written in."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree

NODE = """\
#!/usr/bin/env python
import rospy
from std_msgs.msg import String
def heard(msg):
    {body}
rospy.init_node('old')
rospy.Subscriber('orders', String, heard)
pub = rospy.Publisher('a', String)
rospy.spin()
"""
BODIES = {
    "print": ("print 'heard', msg.dta", [("RM201", 5), ("RC407", 8)]),
    "print_to_a_file": ("print >>log, msg.data", [("RC407", 8)]),
    "exec": ("exec 'x = 1'", [("RC407", 8)]),
    "raise": ("raise ValueError, msg.data", [("RC407", 8)]),
    "numbers_and_texts": ("x = 0777, u'a', ur'b', 10L, `msg`", [("RC407", 8)]),
    "except": ("try: x = 1\n    except ValueError, e: pass", [("RC407", 9)]),
    "not_equal": ("x = 1 <> 2", [("RC407", 8)]),
    "tabs": ("if msg:\n\tprint msg.data\n        print 1", [("RC407", 10)]),
}


@pytest.mark.parametrize(("body", "expected"), BODIES.values(), ids=BODIES)
def test_a_file_of_python_2_is_read(
    tmp_path: Path, body: str, expected: list[tuple[str, int]]
) -> None:
    root = write_tree(tmp_path, {"old.py": NODE.format(body=body)})
    run = run_over(root)
    assert told(run) == expected
    assert run.tree.problems == ()
