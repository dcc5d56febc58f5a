"""What many nodes of a robot have in common; each hands itself in."""
from __future__ import annotations

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from rclpy.node import Node
from std_srvs.srv import Trigger


def diagnostics(node: Node):
    return node.create_publisher(DiagnosticArray, '/diagnostics', 10)


def rate(node: rclpy.node.Node, name='rate', default=10.0):
    """Declare the rate, as self.declare_parameter('rate', 10.0) would."""
    if not node.has_parameter(name):
        return node.declare_parameter(name, default).value
    return node.get_parameter(name).value


class Reset:
    def __init__(self, node: Node) -> None:
        self._node = node
        self._service = node.create_service(Trigger, '~/reset', self._reset)
        self._timer = self._node.create_timer(60, self._forget)

    def _reset(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success = True
        return response

    def _forget(self):
        self._node.destroy_service(self._service)
