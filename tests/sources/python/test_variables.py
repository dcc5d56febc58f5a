"""Variables that hold what is added: as the file has its others, and none that nothing uses."""

from __future__ import annotations

import pytest
from edits import edited, provide, subscribe

HEAD = {
    "rospy": "import rospy\nfrom std_msgs.msg import String\n"
    "from std_srvs.srv import Trigger\n\n\n",
    "rclpy": "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
    "from std_srvs.srv import Trigger\n\n\n",
}
NODE = {
    "rospy": "rospy.init_node('n')\n",
    "rclpy": "rclpy.init()\nnode = rclpy.create_node('n')\n",
}
CALLS = {
    "rospy": ("rospy.Subscriber('a', String, print)", "rospy.Service('b', Trigger, print)"),
    "rclpy": (
        "node.create_subscription(String, 'a', print, 1)",
        "node.create_service(Trigger, 'b', print)",
    ),
}
SPIN = {"rospy": "rospy.spin()\n", "rclpy": "rclpy.spin(node)\n"}


def script(library: str, is_held: bool, is_function: bool) -> str:
    subscription, service = CALLS[library]
    if is_held:
        subscription, service = f"a_sub = {subscription}", f"b_service = {service}"
    body = f"{NODE[library]}{subscription}\n{service}\n{SPIN[library]}"
    if not is_function:
        return HEAD[library] + body
    indented = "".join(f"    {line}\n" for line in body.splitlines())
    return f"{HEAD[library]}def main():\n{indented}\n\nmain()\n"


@pytest.mark.parametrize("library", HEAD)
@pytest.mark.parametrize("change", [subscribe("x"), provide("x")])
@pytest.mark.parametrize("is_function", [True, False])
@pytest.mark.parametrize("is_held", [True, False])
def test_a_variable_is_bound_where_the_others_have_one_that_lasts(
    library: str, change, is_function: bool, is_held: bool
) -> None:
    after = edited(script(library, is_held, is_function), change)
    (line,) = (each for each in after.splitlines() if "'x'" in each)
    assert ("=" in line.partition("(")[0]) == (is_held and not is_function)


@pytest.mark.parametrize("library", HEAD)
@pytest.mark.parametrize("change", [subscribe("x"), provide("x")])
def test_a_script_without_others_binds_none(library: str, change) -> None:
    after = edited(HEAD[library] + NODE[library] + SPIN[library], change)
    assert any(line.startswith(("rospy.S", "node.create_")) for line in after.splitlines())
