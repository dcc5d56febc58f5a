"""Run a node, and say what it has when its main thread has set up all that it is to have.

A client library registers what is set up at once: what the graph does not know then, is not there.
"""

import gc
import json
import runpy
import sys
import threading


def telling(describe, function):
    def tell(*arguments, **options):
        # A timer of rospy sleeps in a thread of its own, and may do so early.
        if threading.current_thread() is threading.main_thread() and not told:
            told.append(True)
            print("endpoints: " + json.dumps(describe()))
            print("all is set up", flush=True)
        return function(*arguments, **options)

    return tell


told = []


def rospy_endpoints():
    topics = rospy.topics.get_topic_manager()
    services = rospy.impl.registration.get_service_manager().map
    return {
        "nodes": [rospy.get_name()],
        "publishers": {
            name: {"type": each.type, "queue": each.queue_size, "latch": each.is_latch}
            for name, each in topics.pubs.items()
            if name != "/rosout"
        },
        "subscriptions": {
            name: {"type": each.type, "queue": each.queue_size, "latch": False}
            for name, each in topics.subs.items()
        },
        "services": {
            name: {"type": each.service_class._type}
            for name, each in services.items()
            if not each.service_class._type.startswith("roscpp/")
        },
    }


def rclpy_endpoints():
    nodes = [each for each in gc.get_objects() if isinstance(each, rclpy.node.Node)]
    return {
        "nodes": [node.get_fully_qualified_name() for node in nodes],
        "publishers": rclpy_topics(each for node in nodes for each in node.publishers),
        "subscriptions": rclpy_topics(each for node in nodes for each in node.subscriptions),
        "services": {
            node.resolve_service_name(each.srv_name): {"type": type_name(each.srv_type)}
            for node in nodes
            for each in node.services
            if not is_inner(each.srv_type)
        },
    }


def rclpy_topics(endpoints):
    qos = rclpy.qos
    return {
        each.topic_name: {
            "type": type_name(each.msg_type),
            "queue": each.qos_profile.depth,
            "latch": each.qos_profile.durability == qos.DurabilityPolicy.TRANSIENT_LOCAL,
            "best_effort": each.qos_profile.reliability == qos.ReliabilityPolicy.BEST_EFFORT,
        }
        for each in endpoints
        if not is_inner(each.msg_type)
    }


def type_name(type_):
    return type_.__module__.split(".")[0] + "/" + type_.__name__


def is_inner(type_):
    return type_name(type_).split("/")[0] in ("rcl_interfaces", "type_description_interfaces")


try:
    import rospy
except ImportError:
    import rclpy
    import rclpy.executors
    import rclpy.timer

    for owner in (rclpy.executors.SingleThreadedExecutor, rclpy.executors.MultiThreadedExecutor):
        owner.spin_once = telling(rclpy_endpoints, owner.spin_once)
    rclpy.timer.Rate.sleep = telling(rclpy_endpoints, rclpy.timer.Rate.sleep)
else:
    for owner, name in (
        (rospy, "spin"),
        (rospy, "sleep"),
        (rospy.Rate, "sleep"),
        (rospy.rostime, "wallsleep"),
    ):
        setattr(owner, name, telling(rospy_endpoints, getattr(owner, name)))

if __name__ == "__main__":
    del sys.argv[0]
    runpy.run_path(sys.argv[0], run_name="__main__")
