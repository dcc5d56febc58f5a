"""Which names the reader takes from the file, and which it leaves unknown."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.kinds import EDITABLE, EndpointKind
from plastron_tui.sources.python import read_python

HEAD = "import sys\nimport rospy\nfrom std_msgs.msg import Int8, String\n"


def names(body: str) -> list[str | None]:
    """Read rospy code; return the names of its endpoints, a default in brackets."""
    source = read_python(Path("x.py"), one((HEAD + body).encode()), "rospy").source
    assert source is not None
    return [
        each.name if each.default is None else f"[{each.default}]"
        for each in source.endpoints
        if each.kind in EDITABLE and each.kind is not EndpointKind.PARAMETER
    ]


USE = "rospy.Publisher(t, String)\n"

VALUES_ONE_BY_ONE = [
    (f"t = 'a'\n{USE}t = 'b'\n{USE}", ["a", "b"]),
    (f"t = 'a'\nif t:\n    {USE}    t = 'b'\n    {USE}{USE}", ["a", "b", None]),
    (f"if sys.argv:\n    t = 'a'\nelse:\n    t = 'b'\n{USE}", [None]),
    (f"t = 'a'\ntry:\n    t = 'b'\nexcept OSError:\n    pass\n{USE}", [None]),
    (f"t = 'a'\nwhile t:\n    {USE}    t = 'b'\n", [None]),
    (f"t = 'x'\nwhile t:\n    t = 'a'\n    {USE}    t = 'b'\n", ["a"]),
    (f"t = 'x'\nwhile t:\n    t += 'a'\n    {USE}", [None]),
    (f"t = 'a'\nt += '/b'\n{USE}", ["a/b"]),
    (f"def f():\n    t = 'a'\n    {USE}    t = 'b'\n", ["a"]),
    (f"def f(t='a'):\n    t = '/' + t\n    {USE}", ["/a"]),
    (f"t = 'a'\nt = 'b'\ndef f():\n    {USE}", [None]),
    (f"t = 'a'\ndef f():\n    global t\n    t = 'b'\nf()\n{USE}", [None]),
    (f"def f():\n    t = 'a'\n    def g():\n        nonlocal t\n        t = ''\n    {USE}", [None]),
    ("def f():\n    t = 'a'\n    [rospy.Publisher(t, String)]\n    t = 'b'\n", ["a"]),
    (f"for t in sys.argv:\n    t = 'a'\n    {USE}", ["a"]),
    (f"t = 'a'\nif (t := 'b'):\n    {USE}", [None]),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), VALUES_ONE_BY_ONE)
def test_a_line_sees_the_value_that_a_name_has_there(body, expected):
    assert names(body) == expected


def test_functions_that_hand_parts_of_what_they_get_to_each_other_end():
    one = f"def f(t=None):\n    {USE.replace('(t,', '(t.name,')}    g(t.a)\n"
    assert names(f"{one}def g(t=None):\n    f(t.b)\n") == [None]


MAKE = "def make(t):\n    return rospy.Publisher('/' + t, String)\n"
ROBOT = "class Robot:\n    def __init__(self, t):\n        self.t = t\n"
OPENS = "    def open(self):\n        rospy.Publisher(self.t, String)\n"

PASSES = [
    # helpers
    (f"{MAKE}make('a')\nmake(t='b')\n", ["/a", "/b"]),
    (f"{MAKE}make('a')\nmake('a')\n", ["/a"]),
    (f"{MAKE}make('a')\nmake(sys.argv[1])\n", ["/a", None]),
    (f"{MAKE}make(sys.argv[1])\nmake(sys.argv[2])\n", [None]),
    (f"{MAKE}other.make('a')\nother.make('b')\n", [None]),
    (f"{MAKE}for each in 'ab':\n    make(each)\n", ["/a", "/b"]),
    (f"{MAKE}def pair(side):\n    make(side + '/x')\npair('l')\npair('r')\n", ["/l/x", "/r/x"]),
    (f"def make(t, q=1):\n    if t == 'a':\n        {USE}make('a')\nmake('b')\n", [None]),
    (f"def make(t):\n    if not t:\n        return\n    {USE}make('a')\nmake('b')\n", [None]),
    (f"def make(t):\n    if sys.argv:\n        {USE}make('a')\nmake('b')\n", ["a", "b"]),
    ("class A:\n    def make(self, t):\n        if t not in self.made:\n"
     "            self.made[t] = rospy.Publisher(t, String)\n"
     "    def go(self):\n        self.make('a')\n        self.make('b')\n", ["a", "b"]),
    ("class A:\n    def make(self, t='x'):\n        rospy.Publisher(t, String)\n"
     "    def go(self):\n        self.make()\n        self.make('b')\n", ["x", "b"]),
    # objects
    (f"{ROBOT}{OPENS}Robot('a').open()\nRobot('b').open()\n", ["a", "b"]),
    (f"{ROBOT}a = Robot('a')\nb = Robot('b')\nrospy.Publisher(a.t, String)\n", [None]),
    (f"{ROBOT}class A(Robot):\n    def __init__(self):\n        super().__init__('a')\n{OPENS}"
     "class B(Robot):\n    def __init__(self):\n        Robot.__init__(self, 'b')\n", ["a"]),
    (f"{ROBOT}{OPENS}class A(Robot):\n    def __init__(self):\n        super().__init__('a')\n"
     "class B(Robot):\n    def __init__(self):\n        Robot.__init__(self, 'b')\n", ["a", "b"]),
    ("class A:\n    def set(self, t):\n        self.t = t\n    def open(self):\n"
     "        rospy.Publisher(self.t, String)\na = A()\na.set('a')\na.set('b')\n", [None]),
    # loops
    (f"for t in ('a', 'b'):\n    {USE}", ["a", "b"]),
    (f"ALL = ['a', 'b']\nfor t in ALL:\n    {USE}", ["a", "b"]),
    (f"ALL = ['a', 'b']\nALL.append('c')\nfor t in ALL:\n    {USE}", [None]),
    (f"ALL = ['a', 'b']\nALL[0] = 'c'\nfor t in ALL:\n    {USE}", [None]),
    (f"ALL = ['a', *sys.argv]\nfor t in ALL:\n    {USE}", [None]),
    (f"for t in ('a', sys.argv[1]):\n    {USE}", ["a", None]),
    (f"for i, t in enumerate(['a', 'b']):\n    {USE}", ["a", "b"]),
    (f"for t, k in {{'a': Int8, 'b': String}}.items():\n    {USE}", ["a", "b"]),
    ("for a, b in zip('ab', 'cd'):\n    rospy.Publisher(a + b, String)\n", ["ac", "bd"]),
    ("for a in 'ab':\n    for b in 'cd':\n        rospy.Publisher(a + b, String)\n",
     ["ac", "ad", "bc", "bd"]),
    ("[rospy.Publisher('r%d' % i, String) for i in range(2)]\n", ["r0", "r1"]),
    ("[rospy.Publisher('r%d' % i, String) for i in range(2) if i]\n", [None]),
    (f"for t in ('a', 'b'):\n    if t == 'a':\n        continue\n    {USE}", [None]),
    (f"for t in ('a', 'b'):\n    pass\n{USE}", [None]),
    (f"for t in {tuple(map(str, range(100)))}:\n    {USE}", [None]),
    # what a container holds
    ("T = {'a': {'t': 'x'}}\nrospy.Publisher(T['a']['t'], String)\n", ["x"]),
    ("T = {'a': 'x'}\nT['a'] = 'y'\nrospy.Publisher(T['a'], String)\n", [None]),
    ("T = dict(a='x')\nrospy.Publisher(T.get('a', 'y'), String)\n", ["x"]),
    ("T = ['x', 'y']\nrospy.Publisher(T[1], String)\n", ["y"]),
    # what a function gives
    ("def name(t):\n    return '/' + t\nrospy.Publisher(name('a'), String)\n", ["/a"]),
    ("name = lambda t: '/' + t\nrospy.Publisher(name(name('a')), String)\n", ["//a"]),
    ("def f(t):\n    if t:\n        return 'x'\n    return t\n"
     "rospy.Publisher(f('a'), Int8)\n", [None]),
    ("def name(t):\n    return rospy.get_param('~' + t, t)\nrospy.Publisher(name('a'), Int8)\n",
     ["[a]"]),
    ("def name(t):\n    return name(t)\nrospy.Publisher(name('a'), Int8)\n", [None]),
    ("rospy.Publisher('/A/'.strip('/').lower(), String)\n", ["a"]),
    ("rospy.Publisher(rospy.get_param('~t', '') or 'a', String)\n", ["a"]),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), PASSES)
def test_each_call_and_each_turn_of_a_loop_has_a_name(body, expected):
    assert names(body) == expected


PARSER = (
    "import argparse\np = argparse.ArgumentParser()\n"
    "p.add_argument('-t', '--out-topic', default='a')\n"
    "p.add_argument('--plain', dest='other', default='b')\np.add_argument('needed')\n"
)
READ = "rospy.Publisher(args.out_topic, String)\n"

OPTIONS = [
    (f"{PARSER}args = p.parse_args()\n{READ}", ["[a]"]),
    (f"{PARSER}args, rest = p.parse_known_args()\n{READ}", ["[a]"]),
    (f"{PARSER}args = p.parse_known_args()[0]\n{READ}", ["[a]"]),
    (f"{PARSER}def get(a=1):\n    return p.parse_args(a)\nargs = get()\n{READ}", ["[a]"]),
    (f"{PARSER}def run(args):\n    {READ}run(p.parse_args())\n", ["[a]"]),
    (f"{PARSER}args = p.parse_args()\nrospy.Publisher('/' + args.other, String)\n", ["[/b]"]),
    (f"{PARSER}args = p.parse_args()\nrospy.Publisher(args.needed, String)\n", [None]),
    (f"{PARSER}args = load()\n{READ}", [None]),
    (f"{PARSER}p.add_argument('--out-topic', default='c')\nargs = p.parse_args()\n{READ}", [None]),
]  # fmt: skip


@pytest.mark.parametrize(("body", "expected"), OPTIONS)
def test_an_option_of_the_command_line_has_its_default(body, expected):
    assert names(body) == expected


LISTS_FROM_FUNCTIONS = [
    (f"def all():\n    return ['a', 'b']\nfor t in all():\n    {USE}", ["a", "b"]),
    (f"def all(n):\n    return [n]\nfor t in all('a'):\n    {USE}all('b')\n", [None]),
]


@pytest.mark.parametrize(("body", "expected"), LISTS_FROM_FUNCTIONS)
def test_a_list_that_a_function_makes_of_nothing_is_looped_over(body, expected):
    assert names(body) == expected


NODE_HEAD = "import rclpy\nfrom std_msgs.msg import String\nfrom other import KIND, Arm, make\n"
SUBSCRIBE = "create_subscription(String, 'a', print, 1)\n"

FOREIGN_OBJECTS = [
    (f"arm = Arm()\narm.{SUBSCRIBE}", ["a"]),
    (f"arm = Arm()\narm.{SUBSCRIBE}arm.create_timer(1.0, print)\n", ["a", None]),
    (f"def f(arm: Arm):\n    arm.{SUBSCRIBE}", ["a"]),
    (f"def f(arm: Arm | None):\n    arm.{SUBSCRIBE}", ["a"]),
    (f"with Arm() as arm:\n    arm.{SUBSCRIBE}", ["a"]),
    (f"make().{SUBSCRIBE}", ["a"]),
    ("arm = Arm()\narm.create_subscription(KIND, 'a', print, 1)\n", []),
    ("arm = Arm()\narm.create_timer(1.0, print)\n", []),
    (f"import threading\narm = threading.Thread()\narm.{SUBSCRIBE}", []),
]


@pytest.mark.parametrize(("body", "expected"), FOREIGN_OBJECTS)
def test_what_makes_something_of_an_interface_type_is_likely_to_be_a_node(body, expected):
    source = read_python(Path("x.py"), one((NODE_HEAD + body).encode())).source
    assert [each.name for each in source.endpoints] == expected
    assert all(each.is_guess for each in source.endpoints)


ROS_1 = (
    "import rospy, tf, tf2_ros, smach_ros\nfrom std_srvs.srv import Empty\nfrom a.msg import Go\n"
)
ROS_2 = "import rclpy, tf2_ros\nnode = rclpy.create_node('n')\n"

DISGUISED = [
    (f"{ROS_1}tf.TransformListener()\n", ["subscription /tf", "subscription /tf_static"]),
    (f"{ROS_1}tf2_ros.TransformBroadcaster()\n", ["publisher /tf"]),
    (f"{ROS_1}tf2_ros.StaticTransformBroadcaster()\n", ["publisher /tf_static"]),
    (f"{ROS_1}smach_ros.SimpleActionState('go', Go)\n", ["action client go"]),
    (f"{ROS_1}smach_ros.ServiceState('reset', Empty)\n", ["client reset"]),
    (f"{ROS_1}smach_ros.MonitorState('seen', Go, print)\n", ["subscription seen"]),
    ("import rospy\nfrom mine import tf\ntf.TransformListener()\nrospy.init_node('n')\n", []),
    (f"{ROS_2}tf2_ros.TransformBroadcaster(node)\n", ["publisher /tf"]),
    (f"{ROS_2}tf2_ros.Buffer()\n", []),
]


@pytest.mark.parametrize(("text", "expected"), DISGUISED)
def test_objects_of_libraries_create_endpoints(text, expected):
    source = read_python(Path("x.py"), one(text.encode())).source
    assert [f"{each.kind.word} {each.name}" for each in source.endpoints] == expected
