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


# What goes with `{}`, and what is left of the lines.
LINES = {
    "the larger gap stays": ("a = 1\n\n{}\n\nb = 2\n", "a = 1\n\n\nb = 2\n"),
    "one gap of two": ("a = 1\n\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "no gap": ("a = 1\n{}b = 2\n", "a = 1\nb = 2\n"),
    "no gap at the start of a block": ("if f():\n    {}\n    b = 2\n", "if f():\n    b = 2\n"),
    "no gap at the end": ("a = 1\n\n{}", "a = 1\n"),
    "its comment": ("a = 1\n\n# Publish greetings\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment above another one": ("# Publish\n{}# Add\nb = 2\n", "# Add\nb = 2\n"),
    "its comment at the end of a block": (
        "def f():\n    a = 1\n    # Publish\n    {}\n\nb = 2\n",
        "def f():\n    a = 1\n\n\nb = 2\n",
    ),
    "its comment, which no line below is about": (
        "a = 1\n# the publishers\n{}b = 2\n", "a = 1\nb = 2\n"
    ),
    "a comment on another one too": (
        "# the publishers\n{}b = publisher()\n", "# the publishers\nb = publisher()\n"
    ),
    "its comment, with an aside": ("a = 1\n# Publish (to all)\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment of more lines": ("# Greet, add\n{}b = 2\n", "# Greet, add\nb = 2\n"),
    "its comment, with a value": ("# Publish (to = all)\n{}b = 2\n", "b = 2\n"),
    "code in a comment": ("# p = None\n{}\nb = 2\n", "# p = None\n\nb = 2\n"),
    "a heading": (
        "a = 1\n\n####\n# Publishers\n####\n{}\n# ---- More ----\nb = 2\n",
        "a = 1\n\n# ---- More ----\nb = 2\n",
    ),
    "a heading on one line, at the end of a block": (
        "def f():\n    a = 1\n    # === Publish ===\n\n    {}\nb = 2\n",
        "def f():\n    a = 1\n\nb = 2\n",
    ),
    "a heading of something else": (
        "a = 1\n\n####\n# Greet\n####\n{}\n# ---- More ----\nb = 2\n",
        "a = 1\n\n####\n# Greet\n####\n\n# ---- More ----\nb = 2\n",
    ),
    "a heading of something more": (
        "# ---- Publish ----\n{}\nb = publish(2)\n", "# ---- Publish ----\n\nb = publish(2)\n"
    ),
    "a comment with a blank line below": ("a = 1\n\n# Publish\n\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment on a paragraph": (
        "a = 1\n\n# Publish\n\n{}b = 2\n", "a = 1\n\n# Publish\n\nb = 2\n"
    ),
    "a ruler": ("# ---- Greet ----\n{}\nb = 2\n", "# ---- Greet ----\n\nb = 2\n"),
    "what tools read": ("# fmt: off\n{}\nb = 2\n", "# fmt: off\n\nb = 2\n"),
    "a comment further left": (
        "if f():\n# Greet\n    {}    b = 2\n", "if f():\n# Greet\n    b = 2\n"
    ),
    "a condition": ("if x and not y:\n    {}b = 2\n", "b = 2\n"),
    "conditions within others": (
        "if x:\n  if y:\n    if x and y:\n      with x.lock:\n        {}b = 2\n", "b = 2\n"
    ),
    "a condition with an else": (
        "if x:\n    {}else:\n    b = 2\n", "if x:\n    pass\nelse:\n    b = 2\n"
    ),
    "an else": ("if x:\n    b = 2\nelse:\n    {}", "if x:\n    b = 2\n"),
    "the end of the first way": (
        "if x:\n    b = 2\n\n    {}else:\n    b = 3\n", "if x:\n    b = 2\nelse:\n    b = 3\n"
    ),
    "both ways of a condition": ("if x:\n    {}elif y:\n    {}else:\n    {}b = 2\n", "b = 2\n"),
    "the last two of three ways": (
        "if x:\n    a = 1\nelif y:\n    {}else:\n    {}b = 2\n", "if x:\n    a = 1\nb = 2\n"
    ),
    "the last of three ways": (
        "if x:\n    a = 1\nelif f():\n    {}elif y:\n    {}b = 2\n",
        "if x:\n    a = 1\nelif f():\n    pass\nb = 2\n",
    ),
    "a condition that does something": ("if x == f():\n    {}b = 2\n", "f()\nb = 2\n"),
    "a condition that may do something": (
        "if x and f():\n    {}b = 2\n", "if x and f():\n    pass\nb = 2\n"
    ),
    "what is done in the end for nothing": ("try:\n    {}finally:\n    pass\nb = 2\n", "b = 2\n"),
    "what a lock guards": ("with x.lock:\n    {}b = 2\n", "b = 2\n"),
    "what a lock guards, and more": (
        "with x.lock:\n    {}    b = 2\n", "with x.lock:\n    b = 2\n"
    ),
    "what opens something": (
        "with x.lock, f() as z:\n    {}b = 2\n", "with x.lock, f() as z:\n    pass\nb = 2\n"
    ),
    "what may not fail any more": ("try:\n    {}except E:\n    c = 1\nb = 2\n", "b = 2\n"),
    "what is done then all the same": (
        "try:\n    {}finally:\n    c = 1\nb = 2\n",
        "try:\n    pass\nfinally:\n    c = 1\nb = 2\n",
    ),
    "what is done after a failure": (
        "try:\n    a = 1\nexcept E:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    pass\nb = 2\n",
    ),
    "what is done but after a failure": (
        "try:\n    a = 1\nexcept E:\n    c = 1\nelse:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    c = 1\nb = 2\n",
    ),
    "what alone is done in the end": (
        "try:\n    a = 1\nfinally:\n    {}b = 2\n",
        "try:\n    a = 1\nfinally:\n    pass\nb = 2\n",
    ),
    "what is done in the end": (
        "try:\n    a = 1\nexcept E:\n    c = 1\nfinally:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    c = 1\nb = 2\n",
    ),
    "a loop over what is there": ("for z in x:\n    {}b = 2\n", "b = 2\n"),
    "a loop over what is made": (
        "for z in f():\n    {}b = 2\n", "for z in f():\n    pass\nb = 2\n"
    ),
    "a loop whose turns may end": (
        "for z in x:\n    if z > 1:\n        break\n    elif z:\n        continue\n    {}b = 2\n",
        "b = 2\n",
    ),
    "a loop whose turns may end otherwise": (
        "for z in x:\n    if z > 1:\n        {}    else:\n        continue\nb = 2\n", "b = 2\n",
    ),
    "a loop that something ends": (
        "for z in x:\n    if f(z):\n        break\n    {}b = 2\n",
        "for z in x:\n    if f(z):\n        break\nb = 2\n",
    ),
    "a loop that looks for something": (
        "for z in x:\n    if z > 1:\n        break\n    {}b = z\n",
        "for z in x:\n    if z > 1:\n        break\nb = z\n",
    ),
    "a loop before another one": ("for z in x:\n    {}for z in y:\n    b = z\n",
                                  "for z in y:\n    b = z\n"),
    "a loop that something is left of": (
        "for z in x:\n    {}b = z\n", "for z in x:\n    pass\nb = z\n"
    ),
    "a loop with an else": (
        "for z in x:\n    {}else:\n    b = 2\n", "for z in x:\n    pass\nelse:\n    b = 2\n"
    ),
    "a value that a block needs": (
        "p = {}if f():\n    z = 1\n    p.publish(z)\n", "if f():\n    z = 1\n"
    ),
    "a value in a block of a script": (
        "p = {}if f():\n    z = 1\n    p.publish(z)\n    b = 2\n", "if f():\n    b = 2\n"
    ),
    "a message of a script": (
        "z = Int32()\nz.data = 1\np = {}p.publish(z)\nb = 2\n", "b = 2\n"
    ),
    "a message of a script that is read": (
        "z = Int32()\np = {}p.publish(z)\nb = z\n", "z = Int32()\nb = z\n"
    ),
    "a value of a class": (
        "p = {}class A:\n    z = 1\n    p.publish(z)\n", "class A:\n    z = 1\n"
    ),
    "a comment that is not about it": (
        "a = 1\n\n# Greet\n{}\nb = 2\n", "a = 1\n\n# Greet\n\nb = 2\n"
    ),
    "a comment about it in another language": (
        "a = 1\n\n# El publicador\n{}\nb = 2\n", "a = 1\n\nb = 2\n"
    ),
    "a comment on what is left too": (
        "a = 1\n\n# Publishers, services\n{}\nb = 2\n",
        "a = 1\n\n# Publishers, services\n\nb = 2\n",
    ),
    "a comment between lines that go": (
        "a = 1\n\n{}# Publish\n{}\nb = 2\n", "a = 1\n\nb = 2\n"
    ),
    "code for two that is none": (
        "a = 1\n# b, c.d = c.d, b\n{}\nb = 2\n", "a = 1\n# b, c.d = c.d, b\n\nb = 2\n"
    ),
    "a comment below code that is none": (
        "a = 1\n# print(x)\n# publish x\n{}\nb = 2\n", "a = 1\n# print(x)\n\nb = 2\n"
    ),
    "code that is none below a comment": (
        "a = 1\n# publish x\n# print(x)\n{}\nb = 2\n",
        "a = 1\n# publish x\n# print(x)\n\nb = 2\n",
    ),
    "a comment in Chinese": ("# 创建发布者\n{}b = 2\n", "b = 2\n"),
    "a comment in Chinese on something else": ("# 创建订阅者\n{}b = 2\n", "# 创建订阅者\nb = 2\n"),
    "a comment in another script": ("a = 1\n\n# 发布\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
}  # fmt: skip


@pytest.mark.parametrize("case", LINES)
def test_lines_around_what_is_removed(case):
    before, after = (f"{HEAD}x = y = String, Int32\n{each}" for each in LINES[case])
    if not case.endswith("end"):
        before, after = before + TAIL, after + TAIL
    before = before.replace("{}", "rospy.Publisher('t', String)\n")
    assert edited(f"{MORE}{before}", Remove(PUB, "t", AT)) == f"{MORE}{after}"


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
