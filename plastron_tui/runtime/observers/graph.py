"""Prints the running ROS 2 graph as JSON: nodes with their topics, services and clients.

Discovery has no end, so it is looked at until nothing new came for a while. Argument: the most
seconds that may take.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import rclpy
from rclpy.signals import SignalHandlerOptions

# Fast DDS announces a participant every three seconds; a first announcement may be missed.
_LEAST = 3.5
_QUIET = 1.5
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
            }
        except Exception:  # rclpy's own kinds of error differ between distributions
            continue
    return [{"name": name, **kinds} for name, kinds in sorted(found.items())]


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
    print(json.dumps({"nodes": graph}), flush=True)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
