"""Prints, as a line of JSON twice a second, each topic with its rate and last message.

Its argument is the version of ROS. It is a node like any other, so that it sees what travels.
"""

from __future__ import annotations

import importlib
import json
import sys
import time
from typing import Any

from arrivals import Arrivals
from plastron_text import line_of

_PERIOD = 0.5
_INFRASTRUCTURE = frozenset({"/rosout", "/rosout_agg", "/parameter_events"})


class Topic:
    """What was seen of a topic; the last message stays undecoded until it is asked for."""

    def __init__(self, type_name: str) -> None:
        self.type_name = type_name
        self.arrivals = Arrivals()
        self.last: Any = None

    def see(self, message: Any) -> None:
        """Note a message."""
        self.arrivals.note()
        self.last = message


def is_shown(name: str) -> bool:
    """Tell whether a topic or service is one that people look at."""
    # A name with a part that starts with `_` is hidden (ROS 2 design, "Topic and Service names").
    return name not in _INFRASTRUCTURE and "/_" not in name


def _print(topics: dict[str, Topic], decode: Any) -> None:
    rows = [
        {
            "name": name,
            "type": topic.type_name,
            "rate": round(topic.arrivals.rate(time.monotonic()), 2),
            "count": topic.arrivals.count,
            "text": _decoded(decode, topic),
        }
        for name, topic in sorted(topics.items())
    ]
    print(json.dumps({"topics": rows}), flush=True)


def _decoded(decode: Any, topic: Topic) -> str:
    if topic.last is None:
        return ""
    try:
        return str(line_of(decode(topic)))
    except Exception as error:  # whatever a foreign message makes of its bytes
        return f"({len(topic.last)} bytes: {error})"


def watch_ros1() -> None:
    """Watch the topics of a ROS 1 master."""
    import roslib.message
    import rospy

    rospy.init_node("plastron_watch", anonymous=True, disable_signals=True)
    topics: dict[str, Topic] = {}

    def decode(topic: Topic) -> Any:
        message_class = roslib.message.get_message_class(topic.type_name)
        if message_class is None:
            raise ValueError(f"{topic.type_name} is not installed")
        return message_class().deserialize(topic.last)

    def subscribe(name: str, type_name: str) -> None:
        topic = topics[name] = Topic(type_name)
        rospy.Subscriber(name, rospy.AnyMsg, lambda message: topic.see(message._buff))

    try:
        while not rospy.is_shutdown():
            for name, type_name in rospy.get_published_topics():
                if name not in topics and is_shown(name):
                    subscribe(name, type_name)
            _print(topics, decode)
            time.sleep(_PERIOD)
    finally:
        rospy.signal_shutdown("the watch ends")


def watch_ros2() -> None:
    """Watch the topics that ROS 2 discovers."""
    import rclpy
    from fitting_subscription import FittingSubscription
    from rclpy.serialization import deserialize_message
    from rclpy.signals import SignalHandlerOptions

    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node("_plastron_watch", enable_rosout=False, start_parameter_services=False)
    topics: dict[str, Topic] = {}
    subscriptions: dict[str, FittingSubscription] = {}

    def decode(topic: Topic) -> Any:
        return deserialize_message(topic.last, ros2_class(topic.type_name))

    def subscribe(name: str, type_name: str) -> None:
        topic = topics[name] = Topic(type_name.replace("/msg/", "/"))
        try:
            message_class = ros2_class(topic.type_name)
        except (ImportError, AttributeError):
            topic.type_name += " (not installed)"
            return
        subscriptions[name] = FittingSubscription(node, name, message_class, topic.see)

    printed = 0.0
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0.1)
            if time.monotonic() - printed < _PERIOD:
                continue
            printed = time.monotonic()
            for name, type_names in node.get_topic_names_and_types():
                if name not in topics and is_shown(name) and node.count_publishers(name):
                    subscribe(name, type_names[0])
            for each in subscriptions.values():
                each.look()
            _print(topics, decode)
    finally:
        node.destroy_node()
        rclpy.shutdown()


def ros2_class(type_name: str) -> Any:
    """Return the class of a message's type."""
    package, name = type_name.split("/")
    return getattr(importlib.import_module(f"{package}.msg"), name)


if __name__ == "__main__":
    try:
        watch_ros1() if sys.argv[1] == "1" else watch_ros2()
    except KeyboardInterrupt:
        sys.exit(0)
