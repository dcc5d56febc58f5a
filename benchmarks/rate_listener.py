"""Print when messages came over topics: for each its times in seconds, as JSON.

It runs with a Python that has ROS, and knows nothing of who sends.

Arguments: the number of messages to wait for on every topic, and the topics, of `std_msgs/String`.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module
from time import monotonic, sleep
from typing import Any

Times = dict[str, list[float]]


def _is_done(times: Times, number: int) -> bool:
    return all(len(each) >= number for each in times.values())


def _listen_rospy(times: Times, number: int) -> None:
    import rospy

    string = import_module("std_msgs.msg").String

    def note(_: Any, topic: str) -> None:
        times[topic].append(monotonic())

    rospy.init_node("rate_listener")
    subscriptions = [rospy.Subscriber(topic, string, note, topic) for topic in times]
    while not _is_done(times, number):
        sleep(0.1)
    for each in subscriptions:
        each.unregister()


def _listen_rclpy(times: Times, number: int) -> None:
    import rclpy
    from rclpy.executors import SingleThreadedExecutor

    string = import_module("std_msgs.msg").String
    rclpy.init()
    node = rclpy.create_node("rate_listener")
    for topic, own in times.items():
        node.create_subscription(string, topic, lambda _, own=own: own.append(monotonic()), 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    while not _is_done(times, number):
        executor.spin_once()
    node.destroy_node()
    rclpy.shutdown()


def main() -> None:
    number, topics = int(sys.argv[1]), sys.argv[2:]
    times: Times = {topic: [] for topic in topics}
    try:
        _listen_rospy(times, number)
    except ImportError:
        _listen_rclpy(times, number)
    print(json.dumps(times))


if __name__ == "__main__":
    main()
