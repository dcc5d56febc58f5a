"""Prints the running ROS 2 graph as JSON: nodes with their endpoints, actions and parameters.

Discovery has no end, so it is looked at until nothing new came for a while. Argument: the most
seconds that may take.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import rclpy
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters
from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)
from rclpy.parameter import parameter_value_to_python
from rclpy.signals import SignalHandlerOptions

# Fast DDS announces a participant every three seconds; a first announcement may be missed.
_LEAST = 3.5
_QUIET = 1.5
_ANSWER = 2.0
_OF_EVERY_NODE = ("use_sim_time", "qos_overrides", "start_type_description_service")
_OWN_NAME = "_plastron_describe"


def _graph(node: Any) -> list[dict[str, Any]]:
    found = {}
    for name, namespace in node.get_node_names_and_namespaces():
        if name == _OWN_NAME:
            continue
        # A node that has just gone is an error here; the next look does not have it.
        try:
            found[f"{namespace.rstrip('/')}/{name}"] = {
                "publishers": node.get_publisher_names_and_types_by_node(name, namespace),
                "subscriptions": node.get_subscriber_names_and_types_by_node(name, namespace),
                "services": node.get_service_names_and_types_by_node(name, namespace),
                "clients": node.get_client_names_and_types_by_node(name, namespace),
                "action_servers": get_action_server_names_and_types_by_node(node, name, namespace),
                "action_clients": get_action_client_names_and_types_by_node(node, name, namespace),
            }
        except Exception:  # rclpy's own kinds of error differ between distributions
            continue
    return [{"name": name, **kinds} for name, kinds in sorted(found.items())]


def _ask(node: Any, service: Any, part: str, requests: dict[str, Any]) -> dict[str, Any]:
    """Ask nodes for their parameters, and return the answers of those that give one."""
    clients, asked = [], {}
    for name, request in requests.items():
        client = node.create_client(service, f"{name}/{part}")
        clients.append(client)
        if client.wait_for_service(timeout_sec=0.2):
            asked[name] = client.call_async(request)
    end = time.monotonic() + _ANSWER
    while time.monotonic() < end and not all(each.done() for each in asked.values()):
        rclpy.spin_once(node, timeout_sec=0.05)
    answers = {name: each.result() for name, each in asked.items() if each.done()}
    for client in clients:
        node.destroy_client(client)
    return {name: answer for name, answer in answers.items() if answer is not None}


def _parameters(node: Any, nodes: list[str]) -> dict[str, list[dict[str, Any]]]:
    """Return what nodes say of their parameters, but for those that every node has."""
    listed = _ask(
        node, ListParameters, "list_parameters", {name: ListParameters.Request() for name in nodes}
    )
    names = {
        name: [each for each in answer.result.names if each.partition(".")[0] not in _OF_EVERY_NODE]
        for name, answer in listed.items()
    }
    having = {name: found for name, found in names.items() if found}
    get = {name: GetParameters.Request(names=found) for name, found in having.items()}
    tell = {name: DescribeParameters.Request(names=found) for name, found in having.items()}
    values = _ask(node, GetParameters, "get_parameters", get)
    told = _ask(node, DescribeParameters, "describe_parameters", tell)
    return {
        name: [
            _parameter(value, descriptor)
            for value, descriptor in zip(values[name].values, told[name].descriptors, strict=True)
        ]
        for name in having
        # One that is undeclared between the questions makes an answer shorter.
        if name in values
        and name in told
        and len(values[name].values) == len(told[name].descriptors)
    }


def _parameter(given: Any, descriptor: Any) -> dict[str, Any]:
    value = parameter_value_to_python(given)
    if not isinstance(value, (bool, int, float, str, type(None))):
        value = list(value)
    ranges = [*descriptor.floating_point_range, *descriptor.integer_range]
    limits = [(each.from_value, each.to_value, each.step) for each in ranges]
    return {
        "name": descriptor.name,
        "value": value if not isinstance(value, list) or bytes not in map(type, value) else None,
        "range": limits[0] if limits else None,
        "description": descriptor.description,
        "read_only": descriptor.read_only,
    }


def main() -> None:
    """Wait for the graph to be quiet, and print it."""
    limit = float(sys.argv[1])
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node(_OWN_NAME, enable_rosout=False, start_parameter_services=False)
    started = changed = time.monotonic()
    graph: list[dict[str, Any]] = []
    while time.monotonic() - started < limit:
        now = time.monotonic()
        if now - started > _LEAST and now - changed > _QUIET:
            break
        rclpy.spin_once(node, timeout_sec=0.1)
        latest = _graph(node)
        if latest != graph:
            graph, changed = latest, time.monotonic()
    having = [
        each["name"]
        for each in graph
        if f"{each['name']}/list_parameters" in dict(each["services"])
    ]
    parameters = _parameters(node, having)
    nodes = [{**each, "parameters": parameters.get(each["name"], [])} for each in graph]
    print(json.dumps({"nodes": nodes}), flush=True)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
