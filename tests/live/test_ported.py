"""Nodes that somebody wrote for one ROS, brought to the other, run there and talk."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from graph import Graph
from processes import PLASTRON

pytestmark = pytest.mark.live

ROSPY = '''\
#!/usr/bin/env python
"""Counts aloud, repeats what it hears, and can be switched."""
import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, SetBoolResponse

LOUD = "!"


def louder(text):
    return text.upper() + LOUD


class Repeater:
    def __init__(self):
        self.is_on = True
        self.count = 0
        self.repeated = rospy.Publisher("repeated", String, queue_size=10)
        self.counted = rospy.Publisher("counted", Int32, queue_size=10)
        rospy.Subscriber("words", String, self.hear)
        rospy.Service("switch", SetBool, self.switch)
        rospy.Timer(rospy.Duration(0.05), self.tick)

    def hear(self, msg):
        if self.is_on:
            self.repeated.publish(String(data=louder(msg.data)))

    def switch(self, req):
        self.is_on = req.data
        return SetBoolResponse(success=True, message=str(req.data))

    def tick(self, event):
        self.count += 1
        self.counted.publish(Int32(data=self.count))


def main():
    pub = rospy.Publisher("words", String, queue_size=10)
    rospy.init_node("repeater")
    Repeater()
    rate = rospy.Rate(20)
    while not rospy.is_shutdown():
        pub.publish(String(data="hello"))
        rate.sleep()


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSInterruptException:
        pass
'''
RCLPY = '''\
"""Counts aloud, repeats what it hears, and can be switched."""
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool


class Repeater(Node):
    def __init__(self):
        super().__init__("repeater")
        self.is_on = True
        self.count = 0
        self.words = self.create_publisher(String, "words", 10)
        self.repeated = self.create_publisher(String, "repeated", 10)
        self.counted = self.create_publisher(Int32, "counted", 10)
        self.create_subscription(String, "words", self.hear, 10)
        self.create_service(SetBool, "switch", self.switch)
        self.create_timer(0.05, self.tick)

    def hear(self, msg):
        if self.is_on:
            self.repeated.publish(String(data=msg.data.upper() + "!"))

    def switch(self, request, response):
        self.is_on = request.data
        response.success = True
        response.message = str(request.data)
        return response

    def tick(self):
        self.count += 1
        self.counted.publish(Int32(data=self.count))
        self.words.publish(String(data="hello"))


def main(args=None):
    rclpy.init(args=args)
    node = Repeater()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
'''


def test_a_ported_node_talks(graph: Graph, tmp_path: Path) -> None:
    source = RCLPY if graph.target == "rospy" else ROSPY
    (tmp_path / "repeater.py").write_text(source)
    program = tmp_path / "port.plastron"
    program.write_text(f"load repeater as node\ngenerate_node node using {graph.target}\n")
    done = subprocess.run(
        [PLASTRON, "generate", program], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "port-by-hand" not in done.stderr
    node = graph.run(tmp_path / "output" / "repeater.py")
    topics = {"/repeated": "std_msgs/String", "/counted": "std_msgs/Int32"}
    received = graph.listen(topics, 1)
    assert {each.message["data"] for each in received["/repeated"]} == {"HELLO!"}
    counted = [each.message["data"] for each in received["/counted"]]
    assert counted == list(range(counted[0], counted[0] + len(counted)))
    assert len(counted) > 10
    answer = graph.call("/switch", "std_srvs/SetBool", {"data": False})
    assert answer == {"success": True, "message": "False"}
    assert node.interrupt() == 0
    assert "Traceback" not in node.output
