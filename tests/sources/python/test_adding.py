"""Endpoints that small nodes get, before → after, in many manners of writing them."""

from __future__ import annotations

import pytest
from edits import (
    AT,
    CLI,
    NODES,
    edit,
    edited,
    interface,
    provide,
    publish,
    request,
    subscribe,
)

from plastron_tui.model.kinds import Client
from plastron_tui.model.source import Add, Remove

CLASS = (
    "import rospy\nfrom std_msgs.msg import String\n\n\nclass A(object):\n"
    "    def __init__(self):\n        self.cmd_pub = rospy.Publisher('cmd', String, queue_size=5)\n"
    "        rospy.Subscriber('in', String, self.in_cb)\n\n"
    "    def in_cb(self, msg):\n        self.cmd_pub.publish(msg)\n\n"
    "    def run(self):\n        pass\n\n\nrospy.init_node('a')\nA().run()\n"
)

ADDITIONS = {
    "a publisher beside its like": (
        CLASS,
        publish("out"),
        [(
            "queue_size=5)\n",
            "queue_size=5)\n        self.out_pub = rospy.Publisher('out', String, queue_size=5)\n",
        )],
    ),
    "a subscription with a method behind its like": (
        CLASS,
        subscribe("other", "std_msgs/Int32"),
        [
            ("import String\n", "import Int32, String\n"),
            ("self.in_cb)\n", "self.in_cb)\n"
                             "        rospy.Subscriber('other', Int32, self.other_cb)\n"),
            ("publish(msg)\n", "publish(msg)\n\n    def other_cb(self, msg):\n"
                               "        rospy.loginfo('other: %s', msg)\n"),
        ],
    ),
    "a subscription that calls what is there": (
        CLASS,
        subscribe("other", callback="in_cb"),
        [("self.in_cb)\n", "self.in_cb)\n        rospy.Subscriber('other', String, self.in_cb)\n")],
    ),
    "a service": (
        CLASS,
        provide("stop", "std_srvs/Empty"),
        [
            ("import String\n", "import String\nfrom std_srvs.srv import Empty, EmptyResponse\n"),
            ("self.in_cb)\n", "self.in_cb)\n"
                             "        rospy.Service('stop', Empty, self.stop_cb)\n"),
            ("publish(msg)\n", "publish(msg)\n\n    def stop_cb(self, request):\n"
                               "        rospy.loginfo('stop: %s', request)\n"
                               "        return EmptyResponse()\n"),
        ],
    ),
    "publishing in the only loop": (
        "import rospy as r\nfrom std_msgs.msg import String\nr.init_node(\"n\")\n"
        "rate = r.Rate(5)\nwhile not r.is_shutdown():\n\trate.sleep()\n",
        publish("out", data="hi"),
        [
            ('node("n")\n', 'node("n")\nout_pub = r.Publisher("out", String, queue_size=10)\n'),
            ("down():\n", 'down():\n\tout_pub.publish(String(data="hi"))\n'),
        ],
    ),
    "publishing in the only timer": (
        "from rclpy.node import Node\nimport std_msgs.msg\n\nclass A(Node):\n"
        "  def __init__(self):\n    super().__init__('a')\n    self.create_timer(1, self.tick)\n"
        "  def tick(self):\n    print()\n",
        publish("out", data="hi"),
        [
            ("tick)\n", "tick)\n    self.out_pub = "
                        "self.create_publisher(std_msgs.msg.String, 'out', 10)\n"),
            ("print()\n", "print()\n    self.out_pub.publish(std_msgs.msg.String(data='hi'))\n"),
        ],
    ),
    "keywords as the others have them": (
        "import rospy\nfrom std_msgs.msg import *\nrospy.init_node('n')\n"
        "p = rospy.Publisher(name='p', data_class=String, queue_size=1)\n",
        publish("out"),
        [("size=1)\n", "size=1)\nout_p = rospy.Publisher(name='out', data_class=String, "
                       "queue_size=1)\n".replace("out_p ", "out_pub "))],
    ),
    "in a function, the callback before it": (
        "import rospy\nfrom std_msgs.msg import String\n\n\ndef main():\n    rospy.init_node('n')\n"
        "    rospy.spin()\n\n\nmain()\n",
        subscribe("in"),
        [
            ("String\n", "String\n\n\ndef on_in(message):\n    rospy.loginfo('in: %s', message)\n"),
            ("node('n')\n", "node('n')\n    rospy.Subscriber('in', String, on_in)\n"),
        ],
    ),
    "names that the file imports one by one": (
        "from rospy import init_node, Publisher\nfrom std_msgs.msg import String as Text\n"
        "init_node('n')\npub_a = Publisher('a', Text)\n",
        publish("out"),
        [("'a', Text)\n", "'a', Text)\npub_out = Publisher('out', Text, queue_size=10)\n")],
    ),
    "behind init_node, though a publisher stands before": (
        "import rospy\nfrom std_msgs.msg import String\np = rospy.Publisher('a', String)\n"
        "rospy.init_node('n')\n",
        publish("out"),
        [("node('n')\n", "node('n')\nout_pub = rospy.Publisher('out', String, queue_size=10)\n")],
    ),
    "a node that a function makes": (
        "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\n"
        "node = rclpy.create_node('n')\nrclpy.spin(node)\n",
        publish("out"),
        [("node('n')\n", "node('n')\nout_pub = node.create_publisher(String, 'out', 10)\n")],
    ),
    "no final newline": (
        "import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')",
        publish("out"),
        [("node('n')", "node('n')\nout_pub = rospy.Publisher('out', String, queue_size=10)")],
    ),
    "a type whose name is taken": (
        "import rospy\nfrom std_msgs.msg import Empty\nrospy.init_node('n')\n"
        "rospy.Subscriber('a', Empty)\n",
        Add(Client("b", interface("std_srvs/Empty"), [], AT)),
        [
            ("import Empty\n", "import Empty\nfrom std_srvs.srv import Empty as StdSrvsEmpty\n"),
            ("'a', Empty)\n", "'a', Empty)\nb_client = rospy.ServiceProxy('b', StdSrvsEmpty)\n"),
        ],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", ADDITIONS)
def test_adding(case):
    before, change, replacements = ADDITIONS[case]
    after = before
    for old, new in replacements:
        assert after.count(old) == 1
        after = after.replace(old, new)
    assert edited(before, change) == after
    windows = edited(before.replace("\n", "\r\n"), change)
    assert windows == after.replace("\n", "\r\n")


def test_a_client_calls_and_goes_again():
    change = request("add", "beginner_tutorials/AddTwoInts", a=1, b=2)
    after = edited(CLASS, change)
    assert "self.add_client(AddTwoIntsRequest(a=1, b=2))" in after
    assert edited(after, Remove(CLI, "add", AT)) == CLASS


def test_a_name_that_is_no_function_is_refused():
    (found,) = edit(CLASS, subscribe("x", callback="for")).diagnostics
    assert found.code == "invalid-function"


def test_spaces_before_a_tab_count_for_nothing_in_python_2():
    node = next(path for path in NODES if path.name == "python2_indents.py").read_text("utf-8")
    after = edited(node, provide("stop"))
    assert '("pit")\n\trospy.Service("stop", Trigger, handle_stop)\n' in after
    assert after.startswith(node[: node.index("Trigger\n")])
    assert node[node.index("class Pit") : node.index("def main")] in after


QUOTES = [("'", "say('it')\n"), ('"', 'say("it")\n'), ('"', 'say(\'a\', "b", "c")\n')]


@pytest.mark.parametrize(("quote", "code"), QUOTES)
def test_quotes_are_those_of_the_code(quote, code):
    other = "'" if quote == '"' else '"'
    head = (
        f"# It's {other}so{other} {other}so{other}\n{other * 3}A {other}node{other}.{other * 3}\n"
    )
    text = edited(
        f"{head}import rospy\n{code}rospy.init_node(NAME)\nrospy.spin()\n",
        subscribe("t", callback="x"),
    )
    assert f"rospy.Subscriber({quote}t{quote}, " in text


GROUPS = [
    (["callback_group=self.group"], True),
    (["callback_group=self.group", "callback_group=self.group"], True),
    (["callback_group=self.group", "callback_group=self.other"], False),
    (["callback_group=self.group", ""], False),
    (["callback_group=Group()"], False),
]


@pytest.mark.parametrize(("given", "is_taken"), GROUPS)
def test_a_callback_group_that_all_have_is_taken_over(given, is_taken):
    calls = "".join(
        f"        self.create_subscription(String, 't{number}', self.on_t, 5, {each})\n"
        for number, each in enumerate(given)
    )
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"
        f"class A(Node):\n    def __init__(self):\n        super().__init__('a')\n{calls}\n"
        "    def on_t(self, message):\n        pass\n",
        subscribe("new", callback="on_t"),
    )
    end = ", callback_group=self.group)" if is_taken else ")"
    assert f"self.create_subscription(String, 'new', self.on_t, 5{end}\n" in text


PROFILES = [
    (["latched", "latched"], "latched"),
    (["latched"], "latched"),
    (["latched", "sensed"], "10"),
    (["QoSProfile(depth=3)"] * 2, "QoSProfile(depth=3)"),
    (["make_profile()"] * 2, "10"),
    (["sensed", "7"], "7"),
]


@pytest.mark.parametrize(("given", "taken"), PROFILES)
def test_a_profile_that_several_agree_on_is_taken_over(given, taken):
    calls = "".join(
        f"        self.create_subscription(String, 't{number}', self.on_t, {each})\n"
        for number, each in enumerate(given)
    )
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "from mine import QoSProfile, latched, sensed\n\n\n"
        f"class A(Node):\n    def __init__(self):\n        super().__init__('a')\n{calls}\n"
        "    def on_t(self, message):\n        pass\n",
        subscribe("new", callback="on_t"),
    )
    assert f"self.create_subscription(String, 'new', self.on_t, {taken})\n" in text


def test_a_profile_of_another_callback_is_taken_where_it_hears_every_publisher():
    for profile, taken in (("latched", "10"), ("SENSOR_DATA", "SENSOR_DATA")):
        text = edited(
            "from rclpy.node import Node\nfrom std_msgs.msg import String\n"
            f"from mine import {profile}\n\n\n"
            "class A(Node):\n    def __init__(self):\n        super().__init__('a')\n"
            f"        self.create_subscription(String, 't', self.on_t, {profile})\n\n"
            "    def on_t(self, message):\n        pass\n",
            subscribe("new"),
        )
        assert f"self.create_subscription(String, 'new', self.on_new, {taken})\n" in text


METHODS = {"doIt sayIt go": "onNewWord", "do_it sayIt": "on_new_word", "go": "on_new_word"}


@pytest.mark.parametrize("methods", METHODS)
def test_a_callback_is_named_as_the_methods_are(methods):
    body = "".join(f"\n    def {name}(self):\n        pass\n" for name in methods.split())
    text = edited(
        "from rclpy.node import Node\n\n\nclass A(Node):\n    def __init__(self):\n"
        f"        super().__init__('a')\n{body}",
        subscribe("new_word"),
    )
    assert f"    def {METHODS[methods]}(self, message):\n" in text


LOGS = (
    "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
    "    def __init__(self):\n        super().__init__('a')\n"
    "        self.logger = {}\n        self.logger.info('there')\n"
    "        self.a = self.create_subscription(String, 'a', print, 10)\n"
    "        self.b = self.create_subscription(String, 'b', print, 10)\n"
    '        self.pub = self.create_publisher(String, "b", 10)\n'
)


@pytest.mark.parametrize(
    ("logger", "expected"),
    [
        ("self.get_logger()", "self.logger.info('c: waiting"),
        ("logging.getLogger('a')", "self.get_logger().info('c: waiting"),
    ],
)
def test_a_call_logs_by_the_logger_that_a_node_keeps(logger, expected):
    text = edited(LOGS.format(logger), request("c", "std_srvs/SetBool", data=True))
    assert text.count(expected.partition("'")[0]) == (3 if "logger.i" in expected else 2)
    assert expected in text


def test_a_name_has_the_quotes_of_the_one_beside_it():
    text = edited(LOGS.format("1"), publish("c"), subscribe("d"))
    assert 'self.create_publisher(String, "c", 10)\n' in text
    assert "self.create_subscription(String, 'd', self." in text
