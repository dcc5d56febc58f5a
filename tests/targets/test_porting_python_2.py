"""What Python 3 lacks, or does otherwise, in a node of Python 2 that is brought to rclpy."""

from __future__ import annotations

import pytest
from ported_nodes import MARK, ported

NODE = "rospy.init_node('n')\n"
LINES = [
    ("x = isinstance(y, unicode)", "x = isinstance(y, str)"),
    ("x = isinstance(y, basestring)", "x = isinstance(y, str)"),
    ("x = map(unicode, y)", "x = list(map(str, y))"),
    ("def f(unicode): return unicode", "def f(unicode): return unicode"),
    ("x = y.unicode", "x = y.unicode"),
    ("x = long(1)", "x = int(1)"),
    ("x = sorted(y, key=cmp)", "x = sorted(y, key=cmp)"),
    ("x = cmp(1, 2)", f"{MARK}cmp\nx = cmp(1, 2)"),
    ("def cmp(a, b): pass\nx = cmp(1, 2)", "def cmp(a, b): pass\nx = cmp(1, 2)"),
    ("import Queue\nq = Queue.Queue()", "import queue as Queue\nq = Queue.Queue()"),
    ("import Tkinter as tk\ntk.Tk()", "import tkinter as tk\ntk.Tk()"),
    ("from StringIO import StringIO", "from io import StringIO"),
    ("try:\n    import Queue\nexcept X: y = 1", "try:\n    import Queue\nexcept X: y = 1"),
    ("import urllib2", f"{MARK}urllib2\nimport urllib2"),
    ("import cv2.cv as cv\ncv.Save(1)", f"{MARK}cv2.cv\nimport cv2.cv as cv\n"),
    ("import cv2\nx = cv2.cv.CV_A", f"import cv2\n{MARK}cv2.cv\nx = cv2.cv.CV_A"),
    ("import sys\nx = sys.maxint", f"import sys\n{MARK}sys.maxint\nx = sys.maxint"),
    ("import struct\nx = struct.pack('2s', 'ab')", "import struct\nx = struct.pack('2s', b'ab')"),
    (
        "import struct\nx = struct.pack('2s', str(1))",
        f"import struct\n{MARK}struct.pack\nx = struct.pack('2s', str(1))",
    ),
    ("print 1\nx = range(3)", "print(1)\nx = list(range(3))"),
    ("print 1\nx = range(3) + y", "print(1)\nx = list(range(3)) + y"),
    ("print 1\nx = len(filter(f, y))", "print(1)\nx = len(list(filter(f, y)))"),
    ("print 1\nx = sum(map(f, y))", "print(1)\nx = sum(map(f, y))"),
    ("print 1\nfor x in range(3): pass", "print(1)\nfor x in range(3): pass"),
    ("print 1\na, b = map(f, y)", "print(1)\na, b = map(f, y)"),
    ("print 1\ndef f(x): pass\nf(range(3))", "print(1)\ndef f(x): pass\nf(list(range(3)))"),
    ("x = range(3)", "x = range(3)"),
]


@pytest.mark.parametrize(("before", "after"), LINES)
def test_what_python_3_lacks(before: str, after: str) -> None:
    text, _ = ported(f"import rospy\n{NODE}{before}\n", "rospy")
    assert after in text


def test_a_function_that_moved_is_imported_among_the_modules_of_python() -> None:
    text, _ = ported(f"import os\nimport rospy\n{NODE}x = reduce(f, y)\n", "rospy")
    assert text.startswith("import os\nfrom functools import reduce\nimport rclpy\n")


OLD = [
    ("print 1", True),
    ("x = reduce(f, y)", True),
    ("import cPickle", True),
    ("print(1)", False),
]


@pytest.mark.parametrize(("line", "is_old"), OLD)
def test_a_file_of_python_2_says_so_once(line: str, is_old: bool) -> None:
    text, found = ported(f"import rospy\n{NODE}{line}\n", "rospy")
    assert [each.message for each in found].count(
        "`Python 2` has to be ported to rclpy by hand"
    ) == is_old
    assert f"{MARK}Python 2" not in text
