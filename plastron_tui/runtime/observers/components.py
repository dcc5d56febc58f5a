"""Loads components into a container of ROS 2, as soon as it is there.

Prints a line of JSON for each component when it is loaded, or cannot be:
`{"node": "/talker", "passed": [], "error": null, "wanted": "loaded"}`, with the error null where
all is well.
Arguments: the most seconds that it may take, the full name of the container, and the components as
JSON: a list of objects with `name`, `package`, `plugin` and `arguments`, those of a process.

Service: https://github.com/ros2/rcl_interfaces/blob/rolling/composition_interfaces/srv/LoadNode.srv
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import rclpy
from composition_interfaces.srv import LoadNode
from rcl_interfaces.msg import Parameter
from rclpy.parameter import get_parameter_value
from rclpy.signals import SignalHandlerOptions

_OWN_NAME = "_plastron_components"


def _request(component: dict[str, Any]) -> Any:
    """Return what asks for a component, with what the arguments of a process would say."""
    request = LoadNode.Request(
        package_name=component["package"],
        plugin_name=component["plugin"],
        node_name=component["name"],
    )
    words = iter(component["arguments"])
    for word in words:
        if word not in ("-r", "-p"):
            continue
        name, _, value = next(words, "").partition(":=")
        if word == "-p":
            parameter = Parameter(name=name, value=get_parameter_value(value))
            request.parameters.append(parameter)
        elif name == "__node":
            request.node_name = value
        elif name == "__ns":
            request.node_namespace = value
        else:
            request.remap_rules.append(f"{name}:={value}")
    return request


def _load(node: Any, client: Any, component: dict[str, Any], end: float) -> str | None:
    """Load a component; return what is wrong, None where nothing is."""
    answer = client.call_async(_request(component))
    while not answer.done():
        if time.monotonic() > end:
            return "its container does not answer"
        rclpy.spin_once(node, timeout_sec=0.1)
    response = answer.result()
    return None if response.success else str(response.error_message)


def main() -> None:
    """Load all components, or those for which there is time."""
    end = time.monotonic() + float(sys.argv[1])
    container, components = sys.argv[2], json.loads(sys.argv[3])
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node(_OWN_NAME, enable_rosout=False, start_parameter_services=False)
    client = node.create_client(LoadNode, f"{container}/_container/load_node")
    while not client.service_is_ready() and time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    for component in components:
        error = _load(node, client, component, end)
        told = {"node": component["name"], "passed": [], "error": error, "wanted": "loaded"}
        print(json.dumps(told), flush=True)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
