"""Node files of at most 4 MB that something grows from."""

from __future__ import annotations

from pathlib import Path

import pytest
from limited import NODE, Attacker, make_project
from machine import mostly_long

RCLPY = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"

_BIG = 4_000_000 - 1_000

NODES: dict[str, str | bytes] = {
    "parentheses": "(" * _BIG,
    "brackets": "x = " + "[" * _BIG,
    "nested": "x = " + "(" * 200_000 + "1" + ")" * 200_000,
    "indented": NODE + "".join(f"{' ' * n}if x:\n" for n in range(2_000)) + f"{' ' * 2_000}pass\n",
    "sums": NODE + "t = " + " + ".join(["'a'"] * 400_000) + "\nrospy.Publisher(t, String)\n",
    "doubled text": NODE
    + "t0 = 'aaaaaaaa'\n"
    + "".join(f"t{n + 1} = t{n} + t{n}\n" for n in range(60))
    + "rospy.Publisher(t60, String)\n",
    "repeated": NODE + "rospy.Publisher('a' * 10**9, String)\n",
    "power": NODE + "x = 9**9**9**9\nrospy.Publisher('%d' % x, String)\n",
    "width": NODE + "rospy.Publisher('%*d' % (999999999, 1), String)\n",
    "width in braces": NODE + "rospy.Publisher('{:{}}'.format('a', 999999999), String)\n",
    "precision": NODE + "rospy.Publisher(f'{1:999999999}', String)\n",
    "digits": NODE + f"rospy.Publisher(str({'9' * 1_000_000}), String)\n",
    "text of lines": NODE + "rospy.Publisher('" + "a" * _BIG + "', String)\n",
    "attributes": NODE + "x = a" + ".a" * 1_000_000 + "\n",
    "calls": NODE + "f" + "()" * 1_000_000 + "\n",
    "names": NODE + "".join(f"n{n} = n{n - 1}\n" for n in range(1, 90_000)),
    "same name": NODE + "t = 'a'\n" * 120_000 + "rospy.Publisher(t, String)\n" * 2_000,
    "publishers": NODE + "".join(f"rospy.Publisher('t{n}', String)\n" for n in range(30_000)),
    "same publishers": NODE + "rospy.Publisher('t', String)\n" * 30_000,
    "functions": NODE
    + "".join(f"def f{n}(t):\n    f{n + 1}(t)\n    f{n + 1}(t)\n" for n in range(40))
    + "def f40(t):\n    rospy.Publisher(t, String)\nf0('a')\n",
    "names in names": NODE
    + "n0 = ''\n"
    + "".join(f"n{n + 1} = f'{f'{{n{n}}}' * 50}'\n" for n in range(12))
    + "rospy.Publisher(n12, String)\n",
    "names for names": NODE
    + "n0 = rospy.Publisher\n"
    + "".join(f"n{n + 1} = n{n}\n" * 8 for n in range(23))
    + "n23('a', String)\n",
    "defaults": NODE
    + "n0 = 1\n"
    + "".join(f"n{n + 1} = n{n} * n{n} + n{n} ** n{n}\n" for n in range(40))
    + "".join(f"rospy.get_param('p{n}', n{n % 40})\n" for n in range(5_000)),
    "long defaults": NODE
    + f"a = [{'1, ' * 100_000}]\nb = [a] * 900\nc = [b] * 900\nd = [c] * 900\n"
    + "rospy.get_param('p', a)\nrospy.get_param('q', d)\n" * 1_000,
    "fields of a descriptor": RCLPY
    + "from rcl_interfaces.msg import ParameterDescriptor\n\n\nclass A(Node):\n    def f(self):\n"
    + "        d = ParameterDescriptor()\n"
    + "        d.description = 'a'\n        self.declare_parameter('p', 1, d)\n" * 5_000,
    "helpers of transitions": RCLPY
    + "from rclpy.lifecycle import LifecycleNode\n\n\nclass A(LifecycleNode):\n"
    + "    def on_configure(self, state):\n        self.f0()\n"
    + "".join(
        f"    def f{n}(self):\n        self.create_timer(1, print)\n        self.f{n + 1}()\n"
        for n in range(5_000)
    ),
    "uses of actions": RCLPY
    + "from rclpy.action import ActionClient\nfrom a_msgs.action import B\n\n\n"
    + "class A(Node):\n    def f(self):\n"
    + "        self.a = ActionClient(self, B, 'a')\n        self.a.send_goal_async(1, f)\n" * 2_000,
    "nodes without a name": RCLPY
    + "class C0(Node):\n    def __init__(self):\n        super().__init__()\n"
    + "".join(
        f"class C{n + 1}(C{n}):\n    def __init__(self):\n        super().__init__()\n"
        for n in range(60)
    ),
    "nodes that derive from each other": RCLPY
    + "".join(
        f"class {a}({b}, Node):\n    def __init__(self):\n        super().__init__()\n"
        for a, b in ("AB", "BA")
    ),
    "nodes, many": RCLPY
    + "".join(
        f"class C{n}(Node):\n    def __init__(self):\n        super().__init__('c{n}')\n"
        f"        self.create_publisher(String, 'a{n}', 10)\n"
        for n in range(20_000)
    ),
    "nodes of functions": RCLPY
    + "".join(f"def f{n}():\n    rclpy.create_node('n{n}')\n" for n in range(1_000))
    + "class P:\n    def __init__(self, node):\n        self.node = node\n"
    + "".join(f"        self.node.create_publisher(String, 't{n}', 10)\n" for n in range(1_000)),
    "attributes, many": NODE
    + "".join(
        f"class C{n}:\n    def __init__(self):\n        self.n = 'a{n}'\n"
        "        rospy.Publisher(self.n, String)\n"
        for n in range(900)
    ),
    "attributes of derived classes": NODE
    + "class A:\n    def f(self):\n"
    + "        self.x = 'a'\n" * 2_000
    + "        rospy.Publisher(self.x, String)\n" * 3_000
    + "".join(f"class C{n}(A):\n    pass\n" for n in range(990)),
    "base classes": f"{RCLPY}class A({'Node2, ' * 20_000}):\n    pass\n"
    + "".join(f"class C{n}(A):\n    pass\n" for n in range(990)),
    "bindings of a base class": RCLPY
    + "".join(f"class A{n}:\n    pass\n" for n in range(64))
    + "x = 1\n" * 20_000
    + "".join(
        f"class C{n}({'x, ' * 60}{f'C{n - 1}' if n else ''}):\n    pass\n" for n in range(900)
    ),
    "parameters, many": NODE
    + "def f(x):\n"
    + "    rospy.Publisher(x, String)\n" * 5_000
    + "f('a')\n" * 5_000,
    "old line ends": (NODE + "x = 1\n" * 100_000).replace("\n", "\r"),
    "idna": "# coding: idna\n" + NODE + "x = 'aaaaaaaaaaaaaa'\n" * 10,
    "punycode": "# coding: punycode\n" + NODE + "x = 'aaaaaaaaaaaaaa'\n" * 100_000,
    "functions, many": NODE
    + "".join(f"def f{n}(t):\n    f{n + 1}(t)\n" for n in range(20_000))
    + "def f20000(t):\n    rospy.Publisher(t, String)\nf0('a')\n",
    "one function": NODE
    + "def f(t):\n    rospy.Publisher(t, String)\n"
    + "".join(f"f('a{n}')\n" for n in range(50_000)),
    "branching": NODE
    + "".join(f"if x:\n    t{n + 1} = t{n}\nelse:\n    t{n + 1} = t{n} + 'x'\n" for n in range(40))
    + "t0 = 'a'\nrospy.Publisher(t40, String)\n",
    "classes": NODE
    + "class A0:\n    pass\n"
    + "".join(f"class A{n + 1}(A{n}, A{n}):\n    pass\n" for n in range(2_000))
    + "rospy.Publisher(A2000().x, String)\n",
    "imports": NODE + "from std_msgs.msg import String\n" * 50_000,
    "stars": NODE + "from std_msgs.msg import *\n" * 50_000,
    "stars for names": NODE
    + "".join(f"from m{n} import *\n" for n in range(5_000))
    + "x()\n" * 25_000,
    "lambdas": NODE + "x = " + "lambda: " * 100_000 + "1\n",
    "comments, short run": (NODE + "# a\n" * 60 + "x = 1\n" * 9_000).replace("\n", "\r\n"),
    "underscores": RCLPY + "_" * 60_000 + "x.create_publisher(String, 'a', 10)\n",
    "decorators": NODE + "@a\n" * 100_000 + "def f(): pass\n",
    "comments": NODE + "# rospy\n" * 400_000,
    "subscripts": NODE + "x = a" + "[0]" * 500_000 + "\n",
    "errors": NODE + "rospy.Publisher(((\n" * 50_000,
    "no lines": NODE.replace("\n", "\r") * 10_000,
    "format strings": NODE + "x = " + "f'{" * 5_000 + "1" + "}'" * 5_000 + "\n",
    "unicode": (NODE + "rospy.Publisher('" + "\u202e" * 100_000 + "', String)\n").encode(),
}

_QUICK = {"nested", "doubled text", "power", "comments"}
_QUICK |= {"underscores", "base classes"}


# JSON is laid out by Python, and `generate` does all that `check` does: the many do it once.
_OF_ALL = ("inspect known.py", "generate p.plastron")
_OF_SOME = (*_OF_ALL, "inspect --format json known.py", "check p.plastron")


@pytest.mark.parametrize("name", mostly_long(NODES, _QUICK))
def test_a_node_ends_with_a_diagnostic(attacker: Attacker, tmp_path: Path, name: str) -> None:
    folder = tmp_path / "project"
    make_project(folder)
    text = NODES[name]
    (folder / "known.py").write_bytes(text.encode() if isinstance(text, str) else text)
    for command in _OF_SOME if name in _QUICK else _OF_ALL:
        attacker.run(folder, *command.split()).check()
