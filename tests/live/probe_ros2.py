"""Speak to a ROS 2 graph from the outside; run by a Python that has rclpy."""

import json
import sys
import time
from importlib import import_module

import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter


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


def listen(node, executor, topics, seconds):
    seen = set()

    def receiver(topic):
        def receive(message):
            seen.add(topic)
            entry = {"topic": topic, "time": time.monotonic(), "message": plain(message)}
            print(json.dumps(entry))

        return receive

    for topic, type_name in topics.items():
        node.create_subscription(load("msg", type_name), topic, receiver(topic), 10)
    end = time.monotonic() + 60
    while time.monotonic() < end and len(seen) < len(topics):
        executor.spin_once(0.1)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(0.1)


def ask(node, executor, service, type_, request):
    client = node.create_client(type_, service)
    assert client.wait_for_service(60), "the service is not there"
    future = client.call_async(request)
    executor.spin_until_future_complete(future, 60)
    return future.result()


def call(node, executor, service, type_name, request):
    type_ = load("srv", type_name)
    print(json.dumps(plain(ask(node, executor, service, type_, type_.Request(**request)))))


def set_parameter(node, executor, name, parameter, value):
    changed = Parameter(parameter, value=value).to_parameter_msg()
    request = SetParameters.Request(parameters=[changed])
    [result] = ask(node, executor, f"/{name}/set_parameters", SetParameters, request).results
    print(json.dumps(plain(result)))


def endpoints(node, executor, name):
    end = time.monotonic() + 60
    while name not in node.get_node_names() and time.monotonic() < end:
        executor.spin_once(0.1)
    time.sleep(0.5)
    look = {
        "publishers": node.get_publisher_names_and_types_by_node,
        "subscriptions": node.get_subscriber_names_and_types_by_node,
        "services": node.get_service_names_and_types_by_node,
    }
    print(json.dumps({kind: sorted(n for n, _ in ask(name, "/")) for kind, ask in look.items()}))


def main():
    rclpy.init()
    node = rclpy.create_node("probe")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    command, *arguments = sys.argv[1:]
    if command == "listen":
        listen(node, executor, json.loads(arguments[0]), float(arguments[1]))
    elif command == "call":
        call(node, executor, arguments[0], arguments[1], json.loads(arguments[2]))
    elif command == "set":
        set_parameter(node, executor, arguments[0], arguments[1], json.loads(arguments[2]))
    else:
        endpoints(node, executor, arguments[0])


if __name__ == "__main__":
    main()
