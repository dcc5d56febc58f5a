"""Python files whose nodes no other code can give more endpoints."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from python_programs import script, worker

from plastron_tui.sources.python.facts import code_facts
from plastron_tui.sources.python.reader import read_python

LISTEN = "self.create_subscription(String, 'orders', self.heard, 10)"
HEARD = "def heard(self, msg):\n    pass"
NODE = worker(LISTEN, HEARD)
OLD = script("rospy.init_node('worker')\nrospy.Subscriber('orders', String, print)\nrospy.spin()\n")

HEIR = (
    "class Arm(Base):\n    def __init__(self):\n"
    "        self.pub = self.node.create_publisher(String, 'arm', 10)\n"
)


def is_closed(text: str) -> bool:
    source = read_python(Path("worker.py"), one(text.encode())).source
    assert source is not None
    return code_facts(source).is_closed


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (NODE, True),
        (f"from robots import Base\n{NODE}".replace("Worker(Node)", "Worker(Base)"), False),
        (f"from robots import Base\n{NODE}".replace("Worker(Node)", "Worker(Node, Base)"), False),
        (worker(f"{LISTEN}\nself.arm = Arm(self)", HEARD), False),
        (worker(f"{LISTEN}\nself.arms = [Arm(self)]", HEARD), False),
        (worker(f"{LISTEN}\nself.arms = make([self])", HEARD), False),
        (worker(f"{LISTEN}\nprint(self)", HEARD), True),
        (f"import rclpy\nfrom std_msgs.msg import String\nfrom robots import Base\n{HEIR}", False),
        (OLD, True),
        (f"from robots import start\n{OLD}start()\n", False),
        (f"from robots import Base\n{OLD}class Arm(Base):\n    pass\n", False),
        (f"import numpy\n{OLD}numpy.zeros(3)\n", True),
        (f"{OLD}def broken(:\n", False),
    ],
)
def test_a_file_is_closed_where_no_other_code_gets_its_nodes(text: str, expected: bool) -> None:
    assert is_closed(text) is expected
