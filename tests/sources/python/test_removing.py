"""Endpoints that are taken out of small nodes, before → after."""

from __future__ import annotations

import pytest
from edits import (
    AT,
    CLI,
    PUB,
    SRV,
    SUB,
    edit,
    edited,
)

from plastron_tui.model.source import Remove

HEAD = "import rospy\nfrom std_msgs.msg import Int32, String\n"
TAIL = "rospy.init_node('n')\n"
MORE = "keep = rospy.Publisher('keep', Int32)\n"

REMOVALS = {
    "a statement with its comment": (
        PUB,
        f"{HEAD}{MORE}rospy.Publisher('t', String)  # gone\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}{TAIL}",
    ),
    "a variable and what only publishes on it": (
        PUB,
        f"{HEAD}{MORE}p = rospy.Publisher('t', String)\np.publish('a')\n{TAIL}p.publish('b')\n",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}{TAIL}",
    ),
    "a whole import line": (
        PUB,
        f"import rospy\nfrom std_msgs.msg import String  # text\nx = 1\n"
        f"rospy.Publisher('t', String)\n{TAIL}",
        f"import rospy\nx = 1\n{TAIL}",
    ),
    "an import that something else uses stays": (
        PUB,
        f"{HEAD}{MORE}rospy.Publisher('t', String)\nx = String()\n{TAIL}",
        f"{HEAD}{MORE}x = String()\n{TAIL}",
    ),
    "one name of an import over many lines": (
        PUB,
        "import rospy\nfrom std_msgs.msg import (\n    Int32,\n    String,\n    Bool,\n)\n"
        f"x = Bool, Int32\nrospy.Publisher('t', String)\n{TAIL}",
        "import rospy\nfrom std_msgs.msg import (\n    Int32,\n    Bool,\n)\n"
        f"x = Bool, Int32\n{TAIL}",
    ),
    "the last statement of a block": (
        PUB,
        f"{HEAD}{MORE}while x():\n    rospy.Publisher('t', Int32)\n{TAIL}y = String\n",
        f"{HEAD}{MORE}while x():\n    pass\n{TAIL}y = String\n",
    ),
    "between semicolons": (
        PUB,
        f"{HEAD}a = 1; rospy.Publisher('t', Int32); b = String, Int32\n{TAIL}",
        f"{HEAD}a = 1; b = String, Int32\n{TAIL}",
    ),
    "behind a colon": (
        PUB,
        f"{HEAD}{MORE}while x(): rospy.Publisher('t', Int32)\n{TAIL}y = String\n",
        f"{HEAD}{MORE}while x(): pass\n{TAIL}y = String\n",
    ),
    "one of a tuple": (
        PUB,
        f"{HEAD}a, b = rospy.Publisher('k', Int32), rospy.Publisher('t', String)\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\na = rospy.Publisher('k', Int32)\n{TAIL}",
    ),
    "used at once": (
        PUB,
        f"{HEAD}{MORE}rospy.Publisher('t', String).publish('x')\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}{TAIL}",
    ),
    "over many lines, with tabs": (
        PUB,
        f"{HEAD}class A:\n\tdef __init__(self):\n\t\tself.p = rospy.Publisher(\n\t\t\t't',\n"
        f"\t\t\tString,\n\t\t)\n\t\tself.x = Int32\n{TAIL}",
        "import rospy\nfrom std_msgs.msg import Int32\nclass A:\n\tdef __init__(self):\n"
        f"\t\tself.x = Int32\n{TAIL}",
    ),
    "a stub callback goes": (
        SUB,
        f"{HEAD}{MORE}\ndef cb(msg):\n    pass\n\nrospy.Subscriber('t', String, cb)\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}\n{TAIL}",
    ),
    "a callback with code stays": (
        SUB,
        f"{HEAD}def cb(msg):\n    print(msg.data)\n\nrospy.Subscriber('t', Int32, cb)\n{TAIL}"
        "y = String, Int32\n",
        f"{HEAD}def cb(msg):\n    print(msg.data)\n\n{TAIL}y = String, Int32\n",
    ),
    "a stub that something else calls stays": (
        SUB,
        f"{HEAD}def cb(msg):\n    pass\n\nrospy.Subscriber('t', Int32, cb)\ncb(String)\n{TAIL}"
        "y = Int32\n",
        f"{HEAD}def cb(msg):\n    pass\n\ncb(String)\n{TAIL}y = Int32\n",
    ),
    "what a script's loop makes, where an import and a parameter are called so": (
        PUB,
        "import rospy\nfrom std_msgs.msg import String\n\n\ndef f(more):\n    return more\n\n\n"
        "p = rospy.Publisher('t', String)\nwhile True:\n    more = f(1)\n    msg = String()\n"
        f"    msg.data = more\n    p.publish(msg)\n    f(2)\n{TAIL}",
        f"import rospy\n\n\ndef f(more):\n    return more\n\n\nwhile True:\n    f(2)\n{TAIL}",
    ),
    "a module of types": (
        SUB,
        f"import rospy\nimport std_msgs.msg as m\nrospy.Subscriber('t', m.String)\n{TAIL}",
        f"import rospy\n{TAIL}",
    ),
    "a script's constant": (
        PUB,
        f"{HEAD}{MORE}TOPIC = 't'\nSIZE = 3\np = rospy.Publisher(TOPIC, String, queue_size=SIZE)\n"
        f"__all__ = ['SIZE']\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}SIZE = 3\n__all__ = ['SIZE']\n{TAIL}",
    ),
    "a module's constant": (
        PUB,
        f"{HEAD}TOPIC = 't'\n\n\ndef f():\n    global p\n    p = rospy.Publisher(TOPIC, String)\n"
        "    more = rospy.Publisher('m', Int32)\n    p.publish(more.name)\n",
        "import rospy\nfrom std_msgs.msg import Int32\nTOPIC = 't'\n\n\ndef f():\n"
        "    more = rospy.Publisher('m', Int32)\n",
    ),
    "imports that only define names": (
        PUB,
        "import math, os.path\nimport random\nimport mine\nimport numpy as np\n"
        f"from math import sin, pi\n{HEAD}{MORE}p = rospy.Publisher('t', String)\n"
        f"p.publish(math.e + np.e + pi + os.path.x + mine.x)\n{TAIL}y = sin, String\n",
        f"import random\nimport mine\nfrom math import sin\n{HEAD}{MORE}{TAIL}y = sin, String\n",
    ),
    "every call site": (
        SUB,
        f"{HEAD}s = rospy.Subscriber('t', String)\nr = rospy.Subscriber('t', String)\n{MORE}{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}{TAIL}",
    ),
    "a service with its stub": (
        SRV,
        "import rospy\nfrom std_srvs.srv import Empty, EmptyResponse\n\n"
        "def h(req):\n    return EmptyResponse()\n\n"
        f"rospy.Service('t', Empty, h)\n{TAIL}",
        f"import rospy\n{TAIL}",
    ),
    "a variable that holds another later": (
        SUB,
        f"{HEAD}s = rospy.Subscriber('t', String)\ns = rospy.Subscriber('u', Int32)\n{TAIL}",
        f"import rospy\nfrom std_msgs.msg import Int32\ns = rospy.Subscriber('u', Int32)\n{TAIL}",
    ),
    "a client": (
        CLI,
        f"import rospy\nfrom std_srvs.srv import Empty\nc = rospy.ServiceProxy('t', Empty)\n{TAIL}",
        f"import rospy\n{TAIL}",
    ),
    "an rclpy subscription that is mentioned to please a linter": (
        SUB,
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n"
        "        self.s = self.create_subscription(String, 't', self.cb, 10)\n"
        "        self.s  # prevent unused variable warning\n\n"
        "    def cb(self, msg):\n        pass\n",
        "from rclpy.node import Node\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n",
    ),
}


@pytest.mark.parametrize("case", REMOVALS)
def test_removing(case):
    kind, before, after = REMOVALS[case]
    assert edited(before, Remove(kind, "t", AT)) == after
    windows = before.replace("\n", "\r\n")
    assert edited(windows, Remove(kind, "t", AT)) == after.replace("\n", "\r\n")


@pytest.mark.parametrize(
    ("value", "is_kept"),
    [("d.get('k')", False), ("d.get(True)", True), ("d.get()", True), ("rospy.get_name()", False),
     ("Point(*d)", True), ("numpy.max(d)", False), ("numpy.random.rand()", False),
     ("numpy.random.seed()", True),
     ("String(*d)", False), ("take()", True), ("rospy.get_param('~x', 1)", False),
     ("[2 * each for each in d]", False), ("[a + b for a, b in d]", False),
     ("[a + b for a, (b, c) in d]", False),
     ("d.M.GetQuaternion()", False),
     ("rospy.Time.now().to_sec()", False)],
)  # fmt: skip
def test_what_made_a_message_is_kept_where_it_does_something_else(value, is_kept):
    text = edited(
        f"import numpy\n{HEAD}{MORE}x = String, Int32\n\n\ndef f(d):\n    m = String()\n"
        f"    m.data = {value}\n    p.publish(m)\n\n\np = rospy.Publisher('t', String)\n{TAIL}",
        Remove(PUB, "t", AT),
    )
    assert f"def f(d):\n    {value if is_kept else 'pass'}\n\n" in text


def test_what_ends_an_endpoint_goes_with_it():
    head = f"{HEAD}{MORE}x = String, Int32\n"
    before = f"{head}p = rospy.Publisher('t', String)\n{TAIL}p.unregister()\n"
    assert edited(before, Remove(PUB, "t", AT)) == head + TAIL


def test_what_only_served_an_endpoint_goes_with_it():
    text = (
        "from rclpy.node import Node\n"
        "from rclpy.qos import DurabilityPolicy, QoSProfile\n"
        "from std_msgs.msg import String\n\n\n"
        "class A(Node):\n"
        "    def __init__(self):\n"
        "        super().__init__('a')\n"
        "        profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)\n"
        "        self.p = self.create_publisher(String, 't', profile)\n\n"
        "    def close(self):\n"
        "        self.destroy_publisher(self.p)\n"
        "        self.destroy_node()\n"
    )
    assert edited(text, Remove(PUB, "t", AT)) == (
        "from rclpy.node import Node\n\n\n"
        "class A(Node):\n"
        "    def __init__(self):\n"
        "        super().__init__('a')\n\n"
        "    def close(self):\n"
        "        self.destroy_node()\n"
    )


@pytest.mark.parametrize("asked", ["p", "p is not None", "p != None"])
def test_what_only_asks_for_an_endpoint_goes_with_it(asked):
    head = f"{HEAD}{MORE}x = String, Int32\n"
    before = f"{head}p = None\np = rospy.Publisher('t', String)\nif {asked}:\n    p.publish('a')\n"
    assert edited(f"{before}{TAIL}", Remove(PUB, "t", AT)) == head + TAIL
    (found,) = edit(f"{before}    print(x)\n{TAIL}", Remove(PUB, "t", AT)).diagnostics
    assert found.code == "endpoint-in-use"


GROUPED = """\
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):
        super().__init__('a')
        first = MutuallyExclusiveCallbackGroup()
        self.second = ReentrantCallbackGroup(){}


rclpy.spin(A())
"""


@pytest.mark.parametrize("group", ["first", "self.second"])
def test_a_callback_group_goes_with_what_alone_is_in_it(group):
    made = f"\n        self.create_subscription(String, 't', print, 1, callback_group={group})"
    after = edited(GROUPED.format(made), Remove(SUB, "t", AT))
    assert group not in after
    assert after.count("CallbackGroup") == 2


@pytest.mark.parametrize(
    ("names", "used", "left"),
    [("Kind, other", "other", "other"), ("Kind", "0", "Kind"), ("Kind, other", "0", "Kind, other")],
)
def test_a_name_of_another_module_goes_where_one_of_it_is_left(names, used, left):
    before = f"from mine import {names}\n{HEAD}{MORE}x = {used}, String, Int32\n{TAIL}"
    made = "rospy.Publisher('t', String, kind=Kind, f=other)\n"
    if "other" not in names or used == "other":
        made = made.replace(", f=other", "")
    after = edited(before + made, Remove(PUB, "t", AT))
    assert after == before.replace(names, left)


EITHER = """\
import rclpy
if NEW:
    from geometry_msgs.msg import TwistStamped as Twist
else:
    from geometry_msgs.msg import Twist


def send(x):
    {}


node = rclpy.create_node('n')
{}rclpy.spin(node)
"""


def test_a_message_of_either_of_two_types_goes_with_its_publisher():
    before = EITHER.format("m = Twist()\n    m.x = x\n    p.publish(m)",
                           "p = node.create_publisher(Twist, 't', 1)\n")  # fmt: skip
    assert edited(before, Remove(PUB, "t", AT)) == EITHER.format("pass", "")


IN_USE = {
    "unregistered on the way": ("s = rospy.Subscriber('t', String)\nf(s.unregister())\n", [4]),
    "asked for listeners": ("p = rospy.Publisher('t', String)\nif p.get_num_connections():\n"
                            "    p.publish('x')\n", [4]),
    "returned": ("def f():\n    return rospy.Publisher('t', String)\n", [4]),
    "handed on": ("f(rospy.Publisher('t', String))\n", [3]),
    "in a dictionary": ("d = {'a': rospy.Publisher('t', String)}\n", [3]),
    "assigned twice": ("p = rospy.Publisher('t', String)\np = rospy.Publisher('u', String)\n"
                       "p.publish('x')\n", [4]),
}  # fmt: skip


@pytest.mark.parametrize("case", IN_USE)
def test_what_is_in_use_is_not_removed(case):
    body, lines = IN_USE[case]
    kind = SUB if "Subscriber" in body else PUB
    rendered = edit(f"{HEAD}{body}{TAIL}", Remove(kind, "t", AT))
    assert rendered.files is None
    (found,) = rendered.diagnostics
    assert found.code == "endpoint-in-use"
    assert found.message.endswith(" ".join(map(str, lines)))
