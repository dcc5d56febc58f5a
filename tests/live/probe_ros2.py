"""Speak to a ROS 2 graph from the outside; copied by a Python that has rclpy."""

import json
import sys
import time
from importlib import import_module

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.srv import SetParameters
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy


def load(module, type_name):
    package, name = type_name.split("/")
    return getattr(import_module(package + "." + module), name)


def plain(value):
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if isinstance(value, bytes):
        return value[0]
    if hasattr(value, "__iter__") and not isinstance(value, str):
        return [plain(each) for each in value]
    return value


def profile(words):
    """Return the profile that words of QoS name, of a queue that is long."""
    is_late = "transient_local" in words
    is_best_effort = "best_effort" in words
    return QoSProfile(
        depth=100,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if is_late else DurabilityPolicy.VOLATILE,
        reliability=ReliabilityPolicy.BEST_EFFORT if is_best_effort else ReliabilityPolicy.RELIABLE,
        deadline=Duration(seconds=1) if "deadline" in words else Duration(),
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC
        if "manual_by_topic" in words
        else LivelinessPolicy.AUTOMATIC,
    )


def listen(node, executor, topics, seconds, words, silent):
    seen = set()

    def receiver(topic):
        def receive(message):
            seen.add(topic)
            entry = {"topic": topic, "time": time.monotonic(), "message": plain(message)}
            print(json.dumps(entry))

        return receive

    def is_there(topic):
        return node.count_publishers(topic) if topic in silent else topic in seen

    for topic, type_name in topics.items():
        node.create_subscription(load("msg", type_name), topic, receiver(topic), profile(words))
    end = time.monotonic() + 60
    while time.monotonic() < end and not all(map(is_there, topics)):
        executor.spin_once(0.1)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(0.1)


def ask(node, executor, service, type_, request):
    client = node.create_client(type_, service)
    assert client.wait_for_service(60), "the service is not there"
    future = client.call_async(request)
    executor.spin_until_future_complete(future, 60)
    node.destroy_client(client)
    return future.result()


def call(node, executor, service, type_name, request):
    type_ = load("srv", type_name)
    print(json.dumps(plain(ask(node, executor, service, type_, type_.Request(**request)))))


def set_parameter(node, executor, name, parameter, value):
    changed = Parameter(parameter, value=value).to_parameter_msg()
    request = SetParameters.Request(parameters=[changed])
    [result] = ask(node, executor, f"/{name}/set_parameters", SetParameters, request).results
    print(json.dumps(plain(result)))


def wait_for_node(node, executor, name):
    end = time.monotonic() + 60
    while name not in node.get_node_names() and time.monotonic() < end:
        executor.spin_once(0.1)


def endpoints(node, executor, name):
    wait_for_node(node, executor, name)
    time.sleep(0.5)
    look = {
        "publishers": node.get_publisher_names_and_types_by_node,
        "subscriptions": node.get_subscriber_names_and_types_by_node,
        "services": node.get_service_names_and_types_by_node,
    }
    print(json.dumps({kind: sorted(n for n, _ in ask(name, "/")) for kind, ask in look.items()}))


def describe(node, executor, name):
    """Tell what a node has, as far as the graph tells it."""
    wait_for_node(node, executor, name)
    inner = ("rcl_interfaces/", "lifecycle_msgs/", "type_description_interfaces/")
    looks = {
        "publishers": node.get_publishers_info_by_topic,
        "subscriptions": node.get_subscriptions_info_by_topic,
    }
    found = {
        kind: {
            topic: about(each)
            for topic, _ in node.get_topic_names_and_types()
            for each in look(topic)
            if each.node_name == name and not each.topic_type.startswith(inner)
        }
        for kind, look in looks.items()
    }
    services = node.get_service_names_and_types_by_node(name, "/")
    found["services"] = {
        service: {"type": type_.replace("/srv/", "/")}
        for service, [type_] in services
        if not type_.startswith(inner)
    }
    print(json.dumps({"nodes": ["/" + name], **found}))


def about(endpoint):
    qos = endpoint.qos_profile
    return {
        "type": endpoint.topic_type.replace("/msg/", "/"),
        "queue": None,
        "latch": qos.durability == DurabilityPolicy.TRANSIENT_LOCAL,
        "best_effort": qos.reliability == ReliabilityPolicy.BEST_EFFORT,
    }


def own_endpoints(node, name):
    """Return how many endpoints a node has of each name, without those that every node has."""
    inner = ("/" + name + "/", "/rosout", "/parameter_events")
    topics = {each for each, _ in node.get_topic_names_and_types() if not each.startswith(inner)}
    looks = {
        "publishers": node.get_publishers_info_by_topic,
        "subscriptions": node.get_subscriptions_info_by_topic,
    }
    found = {
        kind: {topic: [each.node_name for each in look(topic)].count(name) for topic in topics}
        for kind, look in looks.items()
    }
    for kind, names, count in (
        ("services", node.get_service_names_and_types_by_node, node.count_services),
        ("clients", node.get_client_names_and_types_by_node, node.count_clients),
    ):
        own = [each for each, _ in names(name, "/") if not each.startswith(inner)]
        found[kind] = {each: count(each) for each in own}
    return {
        f"{kind} {each}": n for kind, counts in found.items() for each, n in counts.items() if n
    }


def lifecycle(node, executor, name, steps):
    """Pass transitions; after each, wait for the endpoints that are to be there then, if any."""
    wait_for_node(node, executor, name)
    passed = []
    for label, expected in steps:
        request = ChangeState.Request(transition=Transition(label=label))
        success = ask(node, executor, f"/{name}/change_state", ChangeState, request).success
        end = time.monotonic() + 30
        while expected not in (None, own_endpoints(node, name)) and time.monotonic() < end:
            executor.spin_once(0.1)
        state = ask(node, executor, f"/{name}/get_state", GetState, GetState.Request())
        passed.append([label, success, state.current_state.label, own_endpoints(node, name)])
    print(json.dumps(passed))


def load_component(node, executor, container, package, plugin, name):
    # It is there where rclcpp is.
    from composition_interfaces.srv import LoadNode

    request = LoadNode.Request(package_name=package, plugin_name=plugin, node_name=name)
    answer = ask(node, executor, f"/{container}/_container/load_node", LoadNode, request)
    assert answer.success, answer.error_message
    print(json.dumps(answer.full_node_name))


def main():
    rclpy.init()
    node = rclpy.create_node("probe")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    command, *arguments = sys.argv[1:]
    if command == "listen":
        topics, seconds, words, silent = map(json.loads, arguments)
        listen(node, executor, topics, seconds, words, silent)
    elif command == "call":
        call(node, executor, arguments[0], arguments[1], json.loads(arguments[2]))
    elif command == "set":
        set_parameter(node, executor, arguments[0], arguments[1], json.loads(arguments[2]))
    elif command == "lifecycle":
        lifecycle(node, executor, arguments[0], json.loads(arguments[1]))
    elif command == "load":
        load_component(node, executor, *arguments)
    elif command == "describe":
        describe(node, executor, arguments[0])
    else:
        endpoints(node, executor, arguments[0])
