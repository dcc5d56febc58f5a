"""Nodes that somebody wrote for one ROS, brought to the other, run there and talk."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from graph import Graph
from machine import mostly_long
from ports import run_ported
from processes import own_tracebacks

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
        self.declare_parameter("period", 0.05)
        self.declare_parameters("", [("end", "!"), ("patience", 3600)])
        self.started = self.get_clock().now()
        self.create_timer(self.get_parameter("period").value, self.tick)

    def hear(self, msg):
        patience = self.get_parameter("patience").get_parameter_value().integer_value
        if (self.get_clock().now() - self.started).nanoseconds / 1e9 > patience:
            return
        if self.is_on and rclpy.ok():
            self.get_logger().info(f"100% of {msg.data}")
            self.repeated.publish(String(data=msg.data.upper() + self.get_parameter("end").value))

    def switch(self, request, response):
        self.is_on = request.data
        if not request.data:
            return SetBool.Response(success=True, message=str(request.data))
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

PLAIN = '''\
#!/usr/bin/env python
import rospy
from geometry_msgs.msg import Point, PointStamped
from std_msgs.msg import Bool, Float32MultiArray, Float64, Header, Int32, String
from std_srvs.srv import SetBool, SetBoolResponse, Trigger

flag = rospy.Publisher("flag", Bool, queue_size=10)
numbers = rospy.Publisher("numbers", Float32MultiArray, queue_size=10)


class Plain:
    """Sends what rospy makes messages of."""

    def __init__(self):
        self.count = 0
        self.text = rospy.Publisher("text", String, queue_size=10)
        self.number = rospy.Publisher("number", Float64, queue_size=10)
        self.counted = rospy.Publisher("counted", Int32, queue_size=10)
        self.point = rospy.Publisher("point", Point, queue_size=10)
        self.stamped = rospy.Publisher("stamped", PointStamped, queue_size=10)
        self.repeated = rospy.Publisher("repeated", String, queue_size=10)
        rospy.Subscriber("text", String, self.hear)
        rospy.Service("pair", Trigger, self.pair)
        rospy.Service("named", SetBool, self.named)
        rospy.Service("made", SetBool, lambda req: (1, "made %s" % req.data))
        rospy.Timer(rospy.Duration(0.05), self.tick)

    def hear(self, message):
        rospy.loginfo("chatter: %s", message)
        rospy.logwarn("%d of %s", self.count, rospy.get_name())
        rospy.loginfo(self.count)
        if not rospy.is_shutdown() and message.data:
            self.repeated.publish(message.data)

    def pair(self, req):
        return True, "paired"

    def named(self, req):
        if not req.data:
            return SetBoolResponse(False, "off")
        return {"success": req.data, "message": "named"}

    def tick(self, event):
        self.count += 1
        self.text.publish("hello %s" % rospy.get_name())
        self.number.publish(5)
        self.counted.publish(self.count)
        flag.publish(1)
        self.point.publish(1, 2, 3)
        numbers.publish(data=[1, 2.5, self.count])
        point = PointStamped(Header(stamp=rospy.Time.now()), Point(1, -2, 3))
        point.header.frame_id = "map"
        point.point.z = 4
        self.stamped.publish(point)


if __name__ == "__main__":
    rospy.init_node("plain")
    rospy.loginfo("started at %.1f", rospy.get_time())
    Plain()
    rospy.spin()
'''


@pytest.mark.long
def test_a_ported_node_sends_what_rospy_makes_messages_of(graph: Graph, tmp_path: Path) -> None:
    node = run_ported(graph, tmp_path / "plain.py", PLAIN)
    topics = {
        "/text": "std_msgs/String",
        "/repeated": "std_msgs/String",
        "/number": "std_msgs/Float64",
        "/counted": "std_msgs/Int32",
        "/flag": "std_msgs/Bool",
        "/point": "geometry_msgs/Point",
        "/stamped": "geometry_msgs/PointStamped",
        "/numbers": "std_msgs/Float32MultiArray",
    }
    received = {name: each[-1].message for name, each in graph.listen(topics, 1).items()}
    assert received["/text"] == received["/repeated"] == {"data": "hello /plain"}
    assert received["/number"] == {"data": 5.0}
    assert received["/flag"] == {"data": True}
    assert received["/point"] == {"x": 1.0, "y": 2.0, "z": 3.0}
    assert received["/stamped"]["point"] == {"x": 1.0, "y": -2.0, "z": 4.0}
    assert received["/stamped"]["header"]["frame_id"] == "map"
    assert any(received["/stamped"]["header"]["stamp"].values())
    assert received["/numbers"]["data"][:2] == [1.0, 2.5]
    assert received["/counted"]["data"] > 10
    pair = graph.call("/pair", "std_srvs/Trigger", {})
    assert pair == {"success": True, "message": "paired"}
    assert graph.call("/named", "std_srvs/SetBool", {"data": True})["message"] == "named"
    assert graph.call("/named", "std_srvs/SetBool", {"data": False})["message"] == "off"
    assert graph.call("/made", "std_srvs/SetBool", {"data": True})["message"] == "made True"
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
    assert "chatter: " in node.output
    assert " of /plain" in node.output


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros1"]), indirect=True)
def test_a_ported_node_talks(graph: Graph, tmp_path: Path) -> None:
    source = RCLPY if graph.target == "rospy" else ROSPY
    node = run_ported(graph, tmp_path / "repeater.py", source)
    topics = {"/repeated": "std_msgs/String", "/counted": "std_msgs/Int32"}
    received = graph.listen(topics, 1)
    assert {each.message["data"] for each in received["/repeated"]} == {"HELLO!"}
    counted = [each.message["data"] for each in received["/counted"]]
    assert counted == list(range(counted[0], counted[0] + len(counted)))
    assert len(counted) > 10
    answer = graph.call("/switch", "std_srvs/SetBool", {"data": False})
    assert answer == {"success": True, "message": "False"}
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


LOOP = """\
import rospy
from std_msgs.msg import Float64, Int32, String
from std_srvs.srv import Trigger, TriggerResponse

heard = 0
is_resting = False


def hear(message):
    global heard
    heard += 1
    if heard % 2:
        raise ValueError("an odd one")
    count.publish(heard)


def steps():
    return 3


def rest(request):
    global is_resting
    is_resting = True
    return TriggerResponse(success=True)


if __name__ == "__main__":
    rospy.init_node("loop", anonymous=True)
    rospy.Service("rest", Trigger, rest)
    count = rospy.Publisher("count", Int32, queue_size=10)
    words = rospy.Publisher("words", String, queue_size=10)
    number = rospy.Publisher("number", Float64, queue_size=10)
    rospy.Subscriber("words", String, hear)
    rate = rospy.Rate(rospy.get_param("~rate", 20))
    message = Float64()
    try:
        while not rospy.is_shutdown():
            if is_resting:
                rospy.loginfo_once("at rest")
            else:
                words.publish(rospy.get_param("~word", "hello"))
                message.data = steps()
                number.publish(message)
                rospy.loginfo_once("the first of many")
                rospy.loginfo_throttle(60.0, "a word of %s", rospy.get_name())
            rate.sleep()
    except rospy.ROSInterruptException:
        print("ended")
"""


@pytest.mark.long
@pytest.mark.parametrize("graph", ["ros2"], indirect=True)
def test_a_ported_loop_outlives_its_callbacks_and_ends(graph: Graph, tmp_path: Path) -> None:
    node = run_ported(graph, tmp_path / "loop.py", LOOP)
    topics = {"/number": "std_msgs/Float64", "/count": "std_msgs/Int32"}
    received = graph.listen(topics, 1)
    assert received["/number"][-1].message == {"data": 3.0}
    assert received["/count"][-1].message["data"] > 4
    # What is published as ROS ends fails, as it does with rospy.
    assert graph.call("/rest", "std_srvs/Trigger", {})["success"]
    node.wait_to_print("at rest")
    node.send(signal.SIGTERM)
    assert node.wait(60) == 0
    assert node.output.count("the first of many") == 1
    assert node.output.count("a word of /loop_") == 1
    assert "ValueError: an odd one" in node.output
    assert "ended" in node.output
