"""Changes a parameter of a running ROS 2 node, and prints as JSON what the node says.

Arguments: the node's full name, the parameter's, its value as JSON, and the most seconds to wait.
The answer is `{"status": "done" | "refused" | "absent", "reason": …}`.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import rclpy
from rcl_interfaces.msg import ParameterType
from rcl_interfaces.srv import GetParameterTypes, SetParameters
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions

_OWN_NAME = "_plastron_set_parameter"


def _ask(node: Any, target: str, name: str, value: Any, limit: float) -> tuple[str, str]:
    deadline = time.monotonic() + limit
    client = node.create_client(SetParameters, f"{target}/set_parameters")
    if not client.wait_for_service(timeout_sec=limit):
        return "absent", "no node of this name has parameters that can be set"
    types = node.create_client(GetParameterTypes, f"{target}/get_parameter_types")
    known = _call(node, types, GetParameterTypes.Request(names=[name]), deadline)
    if known is not None:
        value = _fitted(value, list(known.types))
    parameter = Parameter(name, value=value).to_parameter_msg()
    answer = _call(node, client, SetParameters.Request(parameters=[parameter]), deadline)
    if answer is None:
        return "absent", "the node does not answer"
    (result,) = answer.results
    return ("done" if result.successful else "refused"), result.reason


def _call(node: Any, client: Any, request: Any, deadline: float) -> Any:
    """Return the answer of a service, None where none comes in time."""
    if not client.wait_for_service(timeout_sec=max(deadline - time.monotonic(), 0.0)):
        return None
    future = client.call_async(request)
    left = max(deadline - time.monotonic(), 0.0)
    rclpy.spin_until_future_complete(node, future, timeout_sec=left)
    return future.result() if future.done() else None


def _fitted(value: Any, types: list[int]) -> Any:
    """Return whole numbers as floats where the parameter has floats."""
    if types == [ParameterType.PARAMETER_DOUBLE] and type(value) is int:
        return float(value)
    if types == [ParameterType.PARAMETER_DOUBLE_ARRAY] and isinstance(value, list):
        return [float(one) if type(one) is int else one for one in value]
    return value


def main() -> None:
    """Ask the node, and print the answer."""
    target, name, value, limit = sys.argv[1:]
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
    node = rclpy.create_node(_OWN_NAME, enable_rosout=False, start_parameter_services=False)
    status, reason = _ask(node, target, name, json.loads(value), float(limit))
    print(json.dumps({"status": status, "reason": reason}), flush=True)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
