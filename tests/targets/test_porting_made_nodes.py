"""Where the node of a rospy file is made, brought to rclpy."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import ported

INIT = "rclpy.init()\n{0}node = rclpy.create_node('n')\n"
TOP, INNER, DEEP = (INIT.replace("\n{0}", f"\n{' ' * width}") for width in (0, 4, 8))
HEAD = "import rospy\nfrom std_msgs.msg import String\n"
CLASS = "class A:\n    def __init__(self):\n        rospy.Publisher('a', String)\n"
PLACES = [
    (
        "import optparse\np = optparse.OptionParser()\nrospy.init_node('n')\n",
        f"p = optparse.OptionParser()\n{TOP}",
    ),
    (
        "if __name__ == '__main__':\n    import sys\n    rospy.init_node('n')\n",
        f"    import sys\n    {INNER}",
    ),
    (
        "def main():\n    args = parse(rospy.myargv())\n    rospy.init_node('n')\n",
        f"    args = parse(remove_ros_args())\n    {INNER}",
    ),
    (
        "try:\n    rospy.init_node('n')\nexcept Exception:\n    print('no')\n",
        f"try:\n    {INNER}except Exception:\n",
    ),
    (
        "class B:\n    def go(self):\n        try:\n            rospy.init_node('n')\n"
        "        except X:\n            pass\n",
        f"        global node\n        try:\n            {DEEP.replace(' ' * 8, ' ' * 12)}",
    ),
    (
        "try:\n    import roslib; roslib.load_manifest('x')\nexcept ImportError:\n    pass\n"
        "rospy.init_node('n')\n",
        f"    pass\n{TOP}",
    ),
    (f"{CLASS}a = A()\nrospy.init_node('n')\n", f"{TOP}a = A()\n"),
    (f"{CLASS}def b():\n    A()\nb()\nrospy.init_node('n')\n", f"{TOP}b()\n"),
    (f"{CLASS}def b():\n    pass\nb()\nrospy.init_node('n')\n", f"b()\n{TOP}"),
    (
        "def main():\n    x = 1\n    if x:\n        rospy.loginfo('a')\n    rospy.init_node('n')\n",
        f"    x = 1\n    {INNER}    if x:\n",
    ),
]


@pytest.mark.parametrize(("before", "after"), PLACES)
def test_the_node_is_made_where_init_node_stood_unless_it_is_needed_before(
    before: str, after: str
) -> None:
    text, _ = ported(HEAD + before, "rospy")
    ast.parse(text)
    assert after in text
    assert text.count("rclpy.create_node(") == 1


NAMES = [
    (
        "NAME = 'n'\ndef f():\n    p = rospy.Publisher('a', String)\n    rospy.init_node(NAME)\n",
        "    node = rclpy.create_node(NAME)\n    p = ",
    ),
    ('x = "a", "b"\nrospy.init_node(\'n\')\n', "rclpy.create_node('n')\n"),
    ("NAME = 'n'\nrospy.init_node(NAME)\n", "\nnode = rclpy.create_node(NAME)\n"),
    ("NAME = 'n'\nrospy.init_node(NAME, anonymous=True)\n", '(f"{NAME}_{os.getpid()}")\n'),
    ("p = rospy.Publisher('a', String)\nNAME = 'n'\nrospy.init_node(NAME)\n", "_node('n')\n"),
    ("rospy.init_node('n')  # why\n", "rclpy.init()\nnode = rclpy.create_node('n')  # why\n"),
    (
        "rospy.init_node('n')  # why\nr = rospy.Rate(1)\nr.sleep()\n",
        "\nnode = rclpy.create_node('n')  # why\nspin_in_thread()\nr = ",
    ),
]


@pytest.mark.parametrize(("before", "after"), NAMES)
def test_a_constant_and_a_comment_stay_with_what_makes_the_node(before: str, after: str) -> None:
    text, _ = ported(HEAD + before, "rospy")
    assert after in text
