"""The imports of a ported file are those that it uses: before → after."""

from __future__ import annotations

import ast
from itertools import permutations

import pytest
from ported_nodes import MARK, ported

from plastron_tui.targets.python.porting.unused_imports import without_unused

UNUSED = [
    ("import rospy\nx = 1\n", "x = 1\n"),
    ("import rospy\nrospy.foo()\n", "import rospy\nrospy.foo()\n"),
    ("import rospy as r, sys\nx = 1\n", "import sys\nx = 1\n"),
    ("import rospy.timer\nrospy.foo()\n", "rospy.foo()\n"),
    ("import rospy.timer\nrospy.timer.foo()\n", "import rospy.timer\nrospy.timer.foo()\n"),
    ("from rospy import a, b as c\na()\n", "from rospy import a\na()\n"),
    (
        "from rospy import a, b, \\\n    c, d, \\\n    e\na(e)\n",
        "from rospy import a, \\\n    e\na(e)\n",
    ),
    ("from rospy import *\nx = 1\n", "from rospy import *\nx = 1\n"),
    ("from a.srv import B, C\nC()\n", "from a.srv import C\nC()\n"),
    ("from a.srv import B\nx.B(B=1)\n", "x.B(B=1)\n"),
    ("from a.srv import D\nimport os\n", "from a.srv import D\nimport os\n"),
    ("try:\n    import rospy\nexcept E:\n    x = 1\n", "try:\n    pass\nexcept E:\n    x = 1\n"),
]


@pytest.mark.parametrize(("before", "after"), UNUSED)
def test_what_nothing_uses(before: str, after: str) -> None:
    assert without_unused(before.encode(), ["rospy"], ["B"]).decode() == after


OTHERS = [
    ("rospy", "from sensor_msgs import point_cloud2", "sensor_msgs.point_cloud2"),
    ("rospy", "import sensor_msgs.point_cloud2 as pc2", "sensor_msgs.point_cloud2"),
    ("rospy", "from sensor_msgs.msg import PointCloud2", ""),
    ("rospy", "from sound_play.msg import SoundRequest", ""),
    ("rospy", "import moveit_commander", "moveit_commander"),
    ("rospy", "from mine.msg import robot_state", "mine/robot_state"),
    ("rospy", "from mine.msg import RobotState", ""),
    ("rclpy", "from sensor_msgs_py import point_cloud2", "sensor_msgs_py"),
    (
        "rclpy",
        "from interactive_markers import InteractiveMarkerServer",
        "interactive_markers.InteractiveMarkerServer",
    ),
]


@pytest.mark.parametrize(("library", "line", "what"), OTHERS)
def test_a_module_that_the_other_ros_lacks_is_marked(library: str, line: str, what: str) -> None:
    made = {"rospy": "rospy.init_node('n')\n", "rclpy": "rclpy.init()\nrclpy.create_node('n')\n"}
    text, found = ported(f"import {library}\n{line}\n{made[library]}", library)
    mark = f"{MARK}{what}\n" if what else ""
    assert f"\n{mark}{line}\n" in text
    assert [each.message.split("`")[1] for each in found] == ([what] if what else [])


PRIVATE = [
    ("from geometry_msgs.msg._Point import Point", "from geometry_msgs.msg import Point", ""),
    ("from std_msgs.msg._String import String as S", "from std_msgs.msg import String as S", ""),
    ("from mine.srv._Do import Do, DoRequest", "from mine.srv import Do", ""),
    ("import std_msgs.msg._String", None, "std_msgs.msg._String"),
    ("from std_msgs.msg._String import *", None, "std_msgs.msg._String"),
]


@pytest.mark.parametrize(("line", "written", "what"), PRIVATE)
def test_the_file_of_one_type_has_another_name(line: str, written: str | None, what: str) -> None:
    text, found = ported(f"import rospy\n{line}\nrospy.init_node('n')\n", "rospy")
    mark = f"{MARK}{what}\n" if what else ""
    assert f"\n{mark}{written or line}\n" in text
    assert [each.message.split("`")[1] for each in found] == ([what] if what else [])


def test_what_the_file_of_one_type_gives_is_known() -> None:
    text, _ = ported(
        "import rospy\nfrom std_msgs.msg._Float64 import Float64\nrospy.init_node('n')\n"
        "x = Float64(1)\n",
        "rospy",
    )
    assert "x = Float64(data=1.0)\n" in text


def test_a_module_that_the_file_does_not_import_is_marked() -> None:
    text, _ = ported(
        "from std_msgs.msg import String\nfrom rospy import Publisher\n"
        "p = Publisher('a', String, queue_size=1)\nrospy.spin()\n",
        "rospy",
    )
    assert text.endswith(f"\n{MARK}rospy.spin\nrospy.spin()\n")


def test_a_module_beside_the_library_in_one_import_is_marked() -> None:
    text, _ = ported("import tf, rospy\nrospy.init_node('n')\n", "rospy")
    assert f"{MARK}tf\nimport tf\n" in text


def test_an_import_with_continued_lines_gets_names_in_lines_of_their_own() -> None:
    text, _ = ported(
        "import rclpy\nfrom mine.srv import A, \\\n    B\nrclpy.init()\n"
        "node = rclpy.create_node('n')\nx = [B.Response(), A.Response(), A(), B()]\n",
        "rclpy",
    )
    ast.parse(text)
    assert "import A, \\\n    B, \\\n    AResponse, \\\n    BResponse\n" in text


def test_durations_of_rclpy_beside_those_of_messages() -> None:
    text, _ = ported(
        "import rospy\nfrom std_msgs.msg import Duration\nrospy.init_node('n')\n"
        "start = rospy.Time.now()\nlate = rospy.Time.now() - start > rospy.Duration(2)\n"
        "p = rospy.Publisher('d', Duration, queue_size=1)\n",
        "rospy",
    )
    assert "import rclpy.duration\n" in text
    assert "late = node.get_clock().now() - start > rclpy.duration.Duration(seconds=2)\n" in text
    assert "create_publisher(Duration, " in text


def test_names_of_a_module_that_the_file_imports_from_go_there_in_order() -> None:
    text, _ = ported(
        "import rclpy\nfrom mine.srv import (\n    A,\n    B,\n)\nrclpy.init()\n"
        "node = rclpy.create_node('n')\nx = [B.Response(), A.Response(), A(), B()]\n",
        "rclpy",
    )
    assert "import (\n    A,\n    B,\n    AResponse,\n    BResponse,\n)\n" in text


def test_an_import_that_a_marked_line_needs_is_marked() -> None:
    text, found = ported("import rospy, sys\nrospy.init_node('n')\nrospy.loginfo(*x)\n", "rospy")
    assert f"\n{MARK}import rospy\nimport rospy, sys\n" in text
    assert [each.message.split("`")[1] for each in found] == ["import rospy", "rospy.loginfo"]


IMPORTS = [
    (
        "rospy",
        "import rospy\nfrom std_srvs.srv import Trigger, TriggerRequest\n"
        "rospy.init_node('n')\nrospy.ServiceProxy('s', Trigger)\n",
        ["import rclpy", "from std_srvs.srv import Trigger"],
    ),
    (
        "rclpy",
        "import rclpy\nimport rclpy.node\n\n\nclass A(rclpy.node.Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n        rclpy.foo()\n",
        ["import rospy", "import rclpy"],
    ),
    (
        "rclpy",
        "import rclpy\nfrom std_srvs.srv import Trigger\nrclpy.init()\n"
        "node = rclpy.create_node('n')\nx = Trigger.Request()\n",
        ["import rospy", "from std_srvs.srv import TriggerRequest"],
    ),
]


@pytest.mark.parametrize(("library", "before", "after"), IMPORTS)
def test_imports_of_a_ported_file(library: str, before: str, after: list[str]) -> None:
    text, _ = ported(before, library)
    tree = ast.parse(text)
    assert [
        ast.unparse(x) for x in tree.body if isinstance(x, ast.Import | ast.ImportFrom)
    ] == after
    assert "TriggerRequest =" not in text


HOOK = "rospy.init_node('n')\nrospy.on_shutdown(print)\nrospy.spin()\n"
GROUPS = [
    (
        "import os\nimport sys\n\nimport rospy\n",
        "import atexit\nimport os\nimport signal\nimport sys\nimport threading\nimport time\n"
        "import traceback\n\nimport rclpy\n",
    ),
    (
        "import rospy\nimport sys  # args\nimport math\nimport numpy\n",
        "import sys  # args\nimport math\nimport atexit\nimport signal\nimport threading\n"
        "import time\nimport traceback\nimport numpy\n",
    ),
    (
        "import rospy\nimport numpy\n",
        "import atexit\nimport signal\nimport threading\nimport time\nimport traceback\n\n"
        "import rclpy\n",
    ),
]


@pytest.mark.parametrize(("before", "after"), GROUPS)
def test_modules_of_python_go_among_those_of_the_file(before: str, after: str) -> None:
    text, _ = ported(f"{before}{HOOK}", "rospy")
    assert after in text


BODY = """\
rospy.init_node('n')
rospy.on_shutdown(print)
rospy.Subscriber('t', String, print)
rospy.sleep(1.0)
rospy.spin()
"""
LINES = ("import rospy", "from std_msgs.msg import String", "import os", "import zlib")


@pytest.mark.parametrize("lines", list(permutations(LINES)), ids=lambda lines: lines[0])
def test_what_a_port_needs_is_imported_before_its_helpers_use_it(lines):
    text, _ = ported("\n".join((*lines, BODY)), "rospy")
    module = ast.parse(text)
    kinds = [isinstance(each, ast.Import | ast.ImportFrom) for each in module.body]
    assert kinds == sorted(kinds, reverse=True)
