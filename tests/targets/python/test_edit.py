"""Edits of small nodes, before → after, in many manners of writing them."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import Add, EndpointKind, Remove
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import (
    Client,
    Message,
    Publication,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.targets.python import edit_python, read_python
from plastron_tui.targets.rclpy import DIALECT as RCLPY
from plastron_tui.targets.rospy import DIALECT as ROSPY

AT = Span(0, 0)
CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("jazzy")}
DIALECTS = {"rospy": ROSPY, "rclpy": RCLPY}
NODES = sorted(
    path for path in (Path(__file__).parents[2] / "nodes").glob("r*py/*") if path.suffix != ".json"
)
PUB, SUB = EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION
SRV, CLI = EndpointKind.SERVICE, EndpointKind.CLIENT


def edit(text: str | bytes, *changes):
    data = text.encode() if isinstance(text, str) else text
    source = read_python(Path("node.py"), data).source
    assert source is not None
    return edit_python(source, changes, CATALOGS[source.library], DIALECTS[source.library])


def edited(text: str, *changes) -> str:
    rendered = edit(text, *changes)
    assert rendered.text is not None, [found.message for found in rendered.diagnostics]
    return rendered.text.decode()


def interface(text: str) -> InterfaceName:
    return InterfaceName(*text.split("/"))


def publish(topic, type_="std_msgs/String", rate=None, **fields):
    value = MessageValue(interface(type_), fields)
    sent = Publication(Message("m", value, AT), rate or 10.0, is_rate_open=rate is None)
    return Add(Publisher(topic, interface(type_), [sent] if fields else [], AT))


def subscribe(topic, type_="std_msgs/String", callback=None):
    return Add(Subscription(topic, interface(type_), callback, AT))


def provide(name, type_="std_srvs/Trigger", handler=None):
    return Add(Service(name, interface(type_), handler, AT))


def request(name, type_, **fields):
    return Add(Client(name, interface(type_), [MessageValue(interface(type_), fields)], AT))


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
        f"{HEAD}{MORE}if x:\n    rospy.Publisher('t', Int32)\n{TAIL}y = String\n",
        f"{HEAD}{MORE}if x:\n    pass\n{TAIL}y = String\n",
    ),
    "between semicolons": (
        PUB,
        f"{HEAD}a = 1; rospy.Publisher('t', Int32); b = String, Int32\n{TAIL}",
        f"{HEAD}a = 1; b = String, Int32\n{TAIL}",
    ),
    "behind a colon": (
        PUB,
        f"{HEAD}{MORE}if x: rospy.Publisher('t', Int32)\n{TAIL}y = String\n",
        f"{HEAD}{MORE}if x: pass\n{TAIL}y = String\n",
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
        f"import rospy\nfrom std_msgs.msg import Int32\n{MORE}{TAIL}",
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
    "a module of types": (
        SUB,
        f"import rospy\nimport std_msgs.msg as m\nrospy.Subscriber('t', m.String)\n{TAIL}",
        f"import rospy\n{TAIL}",
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


IN_USE = {
    "unregistered": ("s = rospy.Subscriber('t', String)\ns.unregister()\n", [4]),
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
    assert rendered.text is None
    (found,) = rendered.diagnostics
    assert found.code == "endpoint-in-use"
    assert found.message.endswith(" ".join(map(str, lines)))


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
            ("import String\n", "import String, Int32\n"),
            ("self.in_cb)\n", "self.in_cb)\n"
                             "        rospy.Subscriber('other', Int32, self.other_cb)\n"),
            ("publish(msg)\n", "publish(msg)\n\n    def other_cb(self, message):\n"
                               "        rospy.loginfo('other: %s', message)\n"),
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
                             "        rospy.Service('stop', Empty, self.handle_stop)\n"),
            ("publish(msg)\n", "publish(msg)\n\n    def handle_stop(self, request):\n"
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


def test_no_change_is_the_same_file():
    for path in NODES:
        data = path.read_bytes()
        source = read_python(path, data).source
        if source is not None:
            library = source.library
            assert edit_python(source, [], CATALOGS[library], DIALECTS[library]).text == data


def test_a_name_that_is_no_function_is_refused():
    (found,) = edit(CLASS, subscribe("x", callback="for")).diagnostics
    assert found.code == "invalid-function"


CHANGES = st.sampled_from(
    [
        publish("new_a"),
        publish("new_b", data='it\'s "so"\n'),
        publish("new_pose", "geometry_msgs/PoseStamped"),
        subscribe("new_c", "std_msgs/Int32"),
        provide("new_d"),
        request("new_e", "std_srvs/SetBool", data=True),
    ]
)
KIND_OF = {Publisher: PUB, Subscription: SUB, Service: SRV, Client: CLI}


def names(source) -> Counter:
    return Counter(
        (found.kind, found.name if found.name is not None else found.expression)
        for node in source.nodes
        for found in node.endpoints
        if found.kind is not EndpointKind.TIMER
    )


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.sampled_from(NODES), st.lists(CHANGES, max_size=4, unique_by=id), st.randoms())
def test_any_sequence_gives_the_endpoints_that_it_asks_for(path, additions, random):
    """Each step starts from the text of the one before, as load and generate do."""
    source = read_python(path, path.read_bytes()).source
    if source is None:
        return
    expected = names(source)
    library = source.library
    for addition in additions:
        choice = [key for key in expected if key[0] in KIND_OF.values()]
        change = addition
        if choice and random.random() < 0.5:
            kind, name = random.choice(choice)
            change = Remove(kind, name, AT)
        rendered = edit_python(source, [change], CATALOGS[library], DIALECTS[library])
        if rendered.text is None:
            assert rendered.diagnostics
            continue
        if isinstance(change, Remove):
            expected[change.kind, change.name] = 0
        else:
            endpoint = change.endpoint
            name = endpoint.topic if hasattr(endpoint, "topic") else endpoint.name
            expected[KIND_OF[type(endpoint)], name] += 1
        result = read_python(path, rendered.text, library)
        assert result.source is not None
        source = result.source
        assert names(source) == +expected
