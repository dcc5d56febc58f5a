"""The nodes of the examples of the code's rules."""

from __future__ import annotations


def node(made: str, body: str, *, imports: str = "", main: str = "rclpy.spin(Worker())") -> str:
    """Return a node in Python for ROS 2, with some lines of its constructor, and its methods."""
    made_lines = "".join(f"        {line}\n" for line in made.splitlines())
    body_lines = "".join(f"    {line}\n" if line else "\n" for line in body.splitlines())
    return f"""\
import rclpy
from rclpy.node import Node
{imports}

class Worker(Node):
    def __init__(self):
        super().__init__('worker')
{made_lines}
{body_lines}

def main():
    rclpy.init()
    {main}
"""


_SERVICE = "from std_srvs.srv import Trigger\n"
_TEXT = "from std_msgs.msg import String\n"
_ASKING = """\
self.client = self.create_client(Trigger, 'reset')
self.timer = self.create_timer(1.0, self.tick)"""

BLOCKING = {
    "bad": {
        "worker.py": node(
            _ASKING,
            "def tick(self):\n    self.client.call(Trigger.Request())",
            imports=_SERVICE,
        )
    },
    "good": {
        "worker.py": node(
            _ASKING,
            "def tick(self):\n"
            "    future = self.client.call_async(Trigger.Request())\n"
            "    future.add_done_callback(self.answered)\n"
            "\n"
            "def answered(self, future):\n"
            "    self.get_logger().info(future.result().message)",
            imports=_SERVICE,
        )
    },
}

_LISTENING = "self.sub = self.create_subscription(String, 'orders', self.on_order, 10)"

SLEEPING = {
    "bad": {
        "worker.py": node(
            f"{_LISTENING}\nself.timer = self.create_timer(0.1, self.tick)",
            "def on_order(self, msg):\n    time.sleep(2.0)\n    self.get_logger().info(msg.data)"
            "\n\ndef tick(self):\n    self.get_logger().info('tick')",
            imports=f"import time\n{_TEXT}",
        )
    },
    "good": {
        "worker.py": node(
            f"{_LISTENING}\nself.timer = None",
            "def on_order(self, msg):\n"
            "    self.order = msg.data\n"
            "    self.timer = self.create_timer(2.0, self.do_order)\n"
            "\n"
            "def do_order(self):\n"
            "    self.timer.cancel()\n"
            "    self.get_logger().info(self.order)",
            imports=_TEXT,
        )
    },
}

ARITY = {
    "bad": {
        "worker.py": node(
            _LISTENING,
            "def on_order(self):\n    self.get_logger().info('an order')",
            imports=_TEXT,
        )
    },
    "good": {
        "worker.py": node(
            _LISTENING,
            "def on_order(self, msg):\n    self.get_logger().info(msg.data)",
            imports=_TEXT,
        )
    },
}

AGAIN = {
    "bad": {
        "worker.py": node(
            "self.timer = self.create_timer(1.0, self.tick)",
            "def tick(self):\n"
            "    self.pub = self.create_publisher(String, 'state', 10)\n"
            "    self.pub.publish(String(data='well'))",
            imports=_TEXT,
        )
    },
    "good": {
        "worker.py": node(
            "self.pub = self.create_publisher(String, 'state', 10)\n"
            "self.timer = self.create_timer(1.0, self.tick)",
            "def tick(self):\n    self.pub.publish(String(data='well'))",
            imports=_TEXT,
        )
    },
}

IDLE = {
    "bad": {
        "worker.py": node(
            _LISTENING,
            "def on_order(self, msg):\n    self.get_logger().info(msg.data)",
            imports=_TEXT,
            main="node = Worker()\n    node.get_logger().info('ready')",
        )
    },
    "good": {"worker.py": ARITY["good"]["worker.py"]},
}

_ONCE = "self.pub = self.create_publisher(String, 'state', {qos})"
_LATCHED = (
    "qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)\n"
    + _ONCE.format(qos="qos")
)

EARLY = {
    "bad": {
        "worker.py": node(
            _ONCE.format(qos=10) + "\nself.pub.publish(String(data='ready'))",
            "",
            imports=_TEXT,
        )
    },
    "good": {
        "worker.py": node(
            _LATCHED + "\nself.pub.publish(String(data='ready'))",
            "",
            imports=f"from rclpy.qos import DurabilityPolicy, QoSProfile\n{_TEXT}",
        )
    },
}
