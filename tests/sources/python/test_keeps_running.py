"""What would never be called is not added: the node has to spin, or to stay."""

from __future__ import annotations

import pytest
from edits import edit, edited, provide, publish, request, subscribe

NODES = {
    "rospy": "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')\n"
    "pub = rospy.Publisher('a', String, queue_size=1)\npub.publish('once')\n",
    "rclpy": "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\n"
    "node = rclpy.create_node('n')\npub = node.create_publisher(String, 'a', 1)\n"
    "pub.publish(String(data='once'))\n",
}
LOOP = (
    "import time\n{}while rclpy.ok():\n    pub.publish(String(data='again'))\n    time.sleep(0.5)\n"
).format(NODES["rclpy"])
BRIEF = "while not ready():\n    pass\nrclpy.spin_until_future_complete(node, pub.wait())\n"
# It calls once, and ends.
ASKS = NODES["rospy"] + (
    "def main():\n    rospy.wait_for_service('x')\n    helpers.call('x')\n\n\n"
    "if __name__ == '__main__':\n    main()\n"
)
# Who calls `sleep` waits until the timer of the rate is called.
SLEEPS = NODES["rclpy"] + (
    "rate = node.create_rate(5)\nwhile rclpy.ok():\n    rclpy.spin_once(node)\n    rate.sleep()\n"
)
CALLED = {
    "a subscription": subscribe("x"),
    "a service": provide("x"),
    "messages at a rate": publish("x", rate=3.0, data="hi"),
    "a call": request("x", "std_srvs/Trigger"),
}
RUNNING = {
    "rospy": (
        "rospy.spin()\n",
        "rospy.sleep(5)\n",
        "helpers.main()\n",
        "while True:\n    pass\n",
        "window.mainloop()\n",
        "for each in steps():\n    print(each)\n",
    ),
    "rclpy": (
        "rclpy.spin(node)\n",
        "while rclpy.ok():\n    rclpy.spin_once(node)\n",
        "rclpy.executors.SingleThreadedExecutor().add_node(node)\n",
        "helpers.start_spinning(node)\n",
    ),
}


@pytest.mark.parametrize("case", CALLED)
@pytest.mark.parametrize(
    ("text", "why"),
    [
        (NODES["rospy"], "the file ends at once, so that `"),
        (ASKS, "the file ends at once, so that `"),
        (NODES["rclpy"], "the file does not keep spinning, so that `"),
        (NODES["rclpy"] + BRIEF, "the file does not keep spinning, so that `"),
        (LOOP, "the file does not keep spinning, so that `"),
        (SLEEPS, "the loop of the file sleeps until `spin_once` calls its rate: if that calls `"),
    ],
)
def test_what_is_never_called_is_not_added(case: str, text: str, why: str) -> None:
    (found,) = edit(text, CALLED[case]).diagnostics
    assert found.code == "edit-refused"
    assert found.message.startswith(why)
    assert found.help is not None
    assert "spin" in found.help


@pytest.mark.parametrize("case", CALLED)
@pytest.mark.parametrize(
    ("library", "line"), [(each, line) for each, lines in RUNNING.items() for line in lines]
)
def test_what_a_node_that_runs_is_given(case: str, library: str, line: str) -> None:
    assert edited(NODES[library] + line, CALLED[case])


GOING = {
    "rospy": (
        *("rospy.on_shutdown(f)", "t.wait()", "io_loop()", "app.exec_()", "plt.show()", "a.run()"),
        *("t.Start()", "t.join()", "serve()", "input()", "signal.pause()", "listen()", "main()"),
        *("rospy.Subscriber('b', String, print)", "rospy.Service('b', Empty, print)"),
        *("rospy.Timer(rospy.Duration(1), print)", "Goals('b', FibonacciAction)"),
    ),
    "rclpy": (
        "SingleThreadedExecutor(node)",
        "helper.add_node(node)",
        "BasicNavigator()",
        "for each in 'ab':\n    rclpy.spin_once(node)",
        "def turn():\n    rclpy.spin_once(node)\n\n\nwhile True:\n    turn()",
    ),
}
IMPORTS = (
    "from std_srvs.srv import Empty\nfrom actionlib import SimpleActionServer as Goals\n"
    "from actionlib_tutorials.msg import FibonacciAction\n"
)


@pytest.mark.parametrize(
    ("library", "line"), [(each, line) for each, lines in GOING.items() for line in lines]
)
def test_what_lets_a_node_go_on(library: str, line: str) -> None:
    imports = IMPORTS if library == "rospy" else ""
    assert edited(f"{imports}{NODES[library]}{line}\n", CALLED["a subscription"])


@pytest.mark.parametrize("case", CALLED)
@pytest.mark.parametrize("library", NODES)
def test_a_part_of_a_node_is_run_by_another_file(case: str, library: str) -> None:
    text = NODES[library].replace("rclpy.init()\n", "")
    text = text.replace("rospy.init_node('n')\n", "")
    assert edited(text, CALLED[case])


@pytest.mark.parametrize("library", NODES)
def test_a_publisher_alone_needs_nothing(library: str) -> None:
    assert edited(NODES[library], publish("x"))


def test_messages_go_into_a_loop_that_does_not_spin() -> None:
    assert "publish_x" not in edited(LOOP, publish("x", data="hi"))
