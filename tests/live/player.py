"""Play steps to one node, one after the other, and tell all that the node sends and answers.

Run by a Python that has either rospy or rclpy, with a play as JSON: the node's endpoints as
`set_up.py` tells them, and the steps of `traffic.py`.
"""

import json
import sys
import time


def fill(message, fields):
    """Set fields, by name and at any depth; a time has `sec` and `nanosec`, a byte its number."""
    for name, value in fields.items():
        if hasattr(message, "to_nsec"):
            name = {"sec": "secs", "nanosec": "nsecs"}[name]
        if isinstance(value, dict):
            fill(getattr(message, name), value)
        else:
            is_octet = isinstance(getattr(message, name), bytes) and isinstance(value, int)
            setattr(message, name, bytes([value]) if is_octet else value)
    return message


class Player:
    """What is the same for both libraries."""

    def __init__(self, endpoints, serves):
        self.nodes = endpoints["nodes"]
        self.heard = {topic: [] for topic in endpoints["publishers"]}
        self.answers = []
        self.publishers = {}
        for service, (type_name, fields) in serves.items():
            self.heard[service] = []
            self.serve(service, load("srv", type_name), fields)
        for topic, about in endpoints["publishers"].items():
            self.listen(topic, load("msg", about["type"]), about)
        for topic, about in endpoints["subscriptions"].items():
            type_ = load("msg", about["type"])
            self.publishers[topic] = self.announce(topic, type_, about), type_
        self.services = {
            name: load("srv", about["type"]) for name, about in endpoints["services"].items()
        }

    def keep(self, topic, message):
        self.heard[topic].append(plain(message))

    def wait(self, look, what):
        end = time.monotonic() + 30
        while not look():
            if time.monotonic() > end:
                heard = {name: each[-3:] for name, each in self.heard.items()}
                sys.exit(f"not in time: {what}; the last that was heard: {heard}")
            self.turn()

    def play(self, step):
        before = {topic: len(self.heard[topic]) for topic in step["causes"]}
        if step["kind"] == "send":
            publisher, type_ = self.publishers[step["name"]]
            publisher.publish(fill(type_(), step["fields"]))
        elif step["kind"] == "call":
            type_ = self.services[step["name"]]
            self.answers.append(plain(self.call(step["name"], type_, step["fields"])))
        else:
            self.wait(lambda: self.says(step["name"], step["fields"]), step)
        for topic, count in before.items():
            more = step["causes"].count(topic)
            self.wait(lambda t=topic, n=count + more: len(self.heard[t]) >= n, step)

    def says(self, topic, fields):
        """Whether the last message of a topic has these fields, among others."""
        last = self.heard[topic][-1:]
        return bool(last) and fields.items() <= last[0].items()


class Ros1(Player):
    def __init__(self, *arguments):
        rospy.init_node("player", anonymous=True, disable_signals=True)
        Player.__init__(self, *arguments)

    def turn(self):
        time.sleep(0.01)

    def listen(self, topic, type_, about):
        keep = lambda message: self.keep(topic, message)  # noqa: E731
        rospy.Subscriber(topic, type_, keep, queue_size=1000)

    def announce(self, topic, type_, about):
        return rospy.Publisher(topic, type_, queue_size=1000)

    def serve(self, service, type_, fields):
        def answer(request):
            self.keep(service, request)
            return fill(type_._response_class(), fields)

        rospy.Service(service, type_, answer)

    def call(self, service, type_, fields):
        rospy.wait_for_service(service, 30)
        return rospy.ServiceProxy(service, type_)(fill(type_._request_class(), fields))

    def wait_for_matches(self, topics):
        """Wait until each side has connected: that of the node is what the node says of it."""
        [node] = self.nodes
        master = ServerProxy(rosgraph.get_master_uri())
        uri = master.lookupNode(rospy.get_name(), node)[2]

        def look():
            connections = ServerProxy(uri).getBusInfo(rospy.get_name())[2]
            out = {each[4] for each in connections if each[1] == rospy.get_name()}
            sent = (publisher for publisher, _ in self.publishers.values())
            return topics <= out and all(each.get_num_connections() for each in sent)

        self.wait(look, "connections")


class Ros2(Player):
    def __init__(self, *arguments):
        rclpy.init()
        self.node = rclpy.create_node("player", start_parameter_services=False)
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        Player.__init__(self, *arguments)

    def turn(self):
        self.executor.spin_once(0.05)

    def listen(self, topic, type_, about):
        keep = lambda message: self.keep(topic, message)  # noqa: E731
        self.node.create_subscription(type_, topic, keep, self.qos(about))

    def announce(self, topic, type_, about):
        return self.node.create_publisher(type_, topic, self.qos(about))

    def qos(self, about):
        return QoSProfile(
            depth=1000,
            durability=DurabilityPolicy.TRANSIENT_LOCAL
            if about["latch"]
            else DurabilityPolicy.VOLATILE,
            reliability=ReliabilityPolicy.BEST_EFFORT
            if about["best_effort"]
            else ReliabilityPolicy.RELIABLE,
        )

    def serve(self, service, type_, fields):
        def answer(request, response):
            self.keep(service, request)
            return fill(response, fields)

        self.node.create_service(type_, service, answer)

    def call(self, service, type_, fields):
        client = self.node.create_client(type_, service)
        self.wait(client.service_is_ready, service)
        future = client.call_async(fill(type_.Request(), fields))
        self.wait(future.done, service)
        return future.result()

    def wait_for_matches(self, topics):
        """Wait until each side knows the other.

        What one participant announces comes in order: a node that knows the client that calls it
        knows the subscriptions that were there before.
        """
        for node in self.nodes:
            self.call(node + "/list_parameters", ListParameters, {})
        sent = [publisher for publisher, _ in self.publishers.values()]
        self.wait(lambda: all(each.get_subscription_count() for each in sent), "subscriptions")


try:
    import rosgraph
    import rospy
except ImportError:
    import rclpy
    from probe_ros2 import load, plain
    from rcl_interfaces.srv import ListParameters
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

    Library = Ros2
else:
    from xmlrpc.client import ServerProxy

    from probe_ros1 import load, plain

    Library = Ros1


if __name__ == "__main__":
    endpoints, serves, steps = json.loads(sys.argv[1])
    player = Library(endpoints, serves)
    if any(step["kind"] != "wait" for step in steps):
        player.wait_for_matches(set(endpoints["publishers"]))
    for step in steps:
        player.play(step)
    print(json.dumps({"heard": player.heard, "answers": player.answers}))
