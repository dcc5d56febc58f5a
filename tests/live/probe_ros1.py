"""Speak to a ROS 1 graph from the outside; copied by the Python that has rospy."""

import json
import sys
import threading
import time
from importlib import import_module
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
import rosservice


def load(module, type_name):
    package, name = type_name.split("/")
    return getattr(import_module(package + "." + module), name)


def plain(value):
    if hasattr(value, "__slots__") and hasattr(value, "_type"):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    if isinstance(value, (list, tuple, bytes)):
        return [plain(each) for each in value]
    if hasattr(value, "to_nsec"):
        return {"sec": value.secs, "nanosec": value.nsecs}
    return value


def listen(topics, seconds, words, silent):
    """ROS 1 knows no QoS: every subscription that is there is connected."""
    rospy.init_node("probe", anonymous=True, disable_signals=True)
    lock = threading.Lock()
    seen = set()

    def receive(message, topic):
        now = time.monotonic()
        with lock:
            seen.add(topic)
            entry = {"topic": topic, "time": now, "message": plain(message)}
            sys.stdout.write(json.dumps(entry) + "\n")

    subscribers = {
        topic: rospy.Subscriber(topic, load("msg", type_name), receive, callback_args=topic)
        for topic, type_name in topics.items()
    }

    def is_there(topic):
        return subscribers[topic].get_num_connections() if topic in silent else topic in seen

    end = time.monotonic() + 60
    while time.monotonic() < end and not all(map(is_there, topics)):
        time.sleep(0.01)
    time.sleep(seconds)
    with lock:
        sys.stdout.flush()


def call(service, type_name, request):
    rospy.init_node("probe", anonymous=True, disable_signals=True)
    rospy.wait_for_service(service, timeout=60)
    response = rospy.ServiceProxy(service, load("srv", type_name))(**request)
    print(json.dumps(plain(response)))


def set_parameter(node, name, value):
    """ROS 1 takes every value: what a node makes of it, its messages say."""
    rospy.set_param(f"/{node}/{name}", value)
    print(json.dumps({"successful": True, "reason": ""}))


def endpoints(node):
    master = ServerProxy(rosgraph.get_master_uri())
    _, _, (publishers, subscribers, services) = master.getSystemState("/probe")
    kinds = {"publishers": publishers, "subscriptions": subscribers, "services": services}
    found = {
        kind: sorted(name for name, nodes in entries if "/" + node in nodes)
        for kind, entries in kinds.items()
    }
    print(json.dumps(found))


def describe(node):
    """Tell what a node has, as far as the master, the node and its services tell it.

    The master remembers the first type of a topic, be it of a node that is long gone.
    """
    master = ServerProxy(rosgraph.get_master_uri())
    _, _, (publishers, subscribers, services) = master.getSystemState("/probe")
    try:
        asked = ServerProxy(master.lookupNode("/probe", "/" + node)[2])
        types = dict(asked.getSubscriptions("/probe")[2] + asked.getPublications("/probe")[2])
    except OSError:  # the address is that of one that was killed
        types, publishers, subscribers, services = {}, (), (), ()

    def topics(entries):
        return {
            name: {"type": types.get(name, "*"), "queue": None, "latch": None}
            for name, nodes in entries
            if "/" + node in nodes and name != "/rosout"
        }

    own = [name for name, nodes in services if "/" + node in nodes]
    kinds = {name: rosservice.get_service_type(name) for name in own}
    print(
        json.dumps(
            {
                "nodes": ["/" + node],
                "publishers": topics(publishers),
                "subscriptions": topics(subscribers),
                "services": {
                    name: {"type": type_}
                    for name, type_ in kinds.items()
                    if type_ is not None and not type_.startswith("roscpp/")
                },
            }
        )
    )


def main():
    command, *arguments = sys.argv[1:]
    if command == "listen":
        listen(*map(json.loads, arguments))
    elif command == "call":
        call(arguments[0], arguments[1], json.loads(arguments[2]))
    elif command == "set":
        set_parameter(arguments[0], arguments[1], json.loads(arguments[2]))
    elif command == "describe":
        describe(arguments[0])
    else:
        endpoints(arguments[0])
