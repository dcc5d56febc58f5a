"""A ported node whose callbacks wait for a service, while the others go on."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from graph import Graph
from ports import run_ported
from processes import own_tracebacks

pytestmark = pytest.mark.live

SWITCH = """\
import rospy
from std_srvs.srv import SetBool


def switch(req):
    return req.data, "switched"


rospy.init_node("switch")
rospy.Service("switch", SetBool, switch)
rospy.spin()
"""
WAITS = """\
import rospy
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger


class Waits:
    def __init__(self):
        rospy.wait_for_service("switch")
        self.switch = rospy.ServiceProxy("switch", SetBool)
        self.missing = rospy.ServiceProxy("missing", Trigger)
        self.done = rospy.Publisher("done", String, queue_size=10)
        self.words = rospy.Publisher("words", String, queue_size=10)
        self.last = rospy.Publisher("last", String, queue_size=10)
        self.started = rospy.Time.now()
        rospy.on_shutdown(self.stop)
        rospy.Subscriber("words", String, self.hear)
        rospy.Timer(rospy.Duration(0.05), self.tick)
        print("first:", rospy.wait_for_message("words", String).data)
        try:
            rospy.wait_for_message("silence", String, timeout=0.2)
        except rospy.ROSException:
            print("nothing came")
        try:
            self.missing()
        except rospy.ServiceException as error:
            print("failed:", error)

    def tick(self, event):
        self.words.publish("a word")

    def hear(self, message):
        age = rospy.Time.now() - self.started
        if age > rospy.Duration(3600) or self.started == rospy.Time(0):
            return
        answer = self.switch(True)
        second = self.switch.call(data=False)
        self.done.publish("%s %s" % (answer.message, second.success))

    def stop(self):
        self.last.publish("the last")
        print("stopped while ROS is there:", not rospy.is_shutdown())


if __name__ == "__main__":
    rospy.init_node("waits")
    waits = Waits()
    rospy.spin()
    print("spun")
"""


@pytest.mark.parametrize("graph", ["ros2"], indirect=True)
@pytest.mark.long
@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM])
def test_a_ported_callback_waits_for_a_service(
    graph: Graph, tmp_path: Path, end: signal.Signals
) -> None:
    run_ported(graph, tmp_path / "switch.py", SWITCH)
    node = run_ported(graph, tmp_path / "waits.py", WAITS)
    received = graph.listen({"/done": "std_msgs/String"}, 1)["/done"]
    assert {each.message["data"] for each in received} == {"switched False"}
    assert len(received) > 4
    node.wait_to_print("failed: ")
    node.send(end)
    assert node.wait(60) == 0
    assert "first: a word" in node.output
    assert "nothing came" in node.output
    assert "failed: service [/missing] unavailable" in node.output
    assert node.output.count("stopped while ROS is there: True") == 1
    assert "spun" in node.output
    assert not own_tracebacks(node.output)
