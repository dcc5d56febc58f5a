"""The imports of a ported file are those that it uses: before → after."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import ported

from plastron_tui.targets.python.porting.unused_imports import without_unused

UNUSED = [
    ("import rospy\nx = 1\n", "x = 1\n"),
    ("import rospy\nrospy.foo()\n", "import rospy\nrospy.foo()\n"),
    ("import rospy as r, sys\nx = 1\n", "import sys\nx = 1\n"),
    ("import rospy.timer\nrospy.foo()\n", "rospy.foo()\n"),
    ("import rospy.timer\nrospy.timer.foo()\n", "import rospy.timer\nrospy.timer.foo()\n"),
    ("from rospy import a, b as c\na()\n", "from rospy import a\na()\n"),
    ("from rospy import *\nx = 1\n", "from rospy import *\nx = 1\n"),
    ("from a.srv import B, C\nC()\n", "from a.srv import C\nC()\n"),
    ("from a.srv import B\nx.B(B=1)\n", "x.B(B=1)\n"),
    ("from a.srv import D\nimport os\n", "from a.srv import D\nimport os\n"),
    ("try:\n    import rospy\nexcept E:\n    x = 1\n", "try:\n    pass\nexcept E:\n    x = 1\n"),
]


@pytest.mark.parametrize(("before", "after"), UNUSED)
def test_what_nothing_uses(before: str, after: str) -> None:
    assert without_unused(before.encode(), ["rospy"], ["B"]).decode() == after


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
