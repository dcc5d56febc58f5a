"""Names that change in a file: the strings that decide them, and nothing else."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from updates import Outcome

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

HEAD = "import rospy\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Empty\n"
TOPIC = "n renames topic 'a' to 'b/c'"
ROSPY = {
    "options": (
        "rospy.Subscriber('a', String, f, (1, 2), queue_size=q, buff_size=9)  # fast\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "by keyword, in the quotes that there are": (
        'rospy.Publisher(data_class=String, name=r"a", latch=True, queue_size=1)\n',
        TOPIC,
        {'r"a"': 'r"b/c"'},
    ),
    "both sides of a topic": (
        "p = rospy.Publisher('a', String)\nrospy.Subscriber('a', String, p.publish)\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "what it sends": (
        "p = rospy.Publisher('a', String)\nwhile not rospy.is_shutdown():\n    p.publish(work())\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "a constant of both": (
        "A = 'a'\np = rospy.Publisher(A, String)\nrospy.Subscriber(A, String, f)\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "an attribute": (
        "class C:\n    def __init__(self):\n        self.topic = 'a'\n"
        "        rospy.Subscriber(self.topic, String, f)\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "a constant of others too": (
        "A = 'a'\nrospy.Subscriber(A, String, f)\nwork('on', A)\n",
        TOPIC,
        {"Subscriber(A": "Subscriber('b/c'"},
    ),
    "a constant of two that part": (
        "A = 'a'\nrospy.Subscriber(A, String, f)\nc = rospy.ServiceProxy(A, Empty)\nc()\n",
        "n renames topic 'a' to 'b'\nn renames service 'a' to 'c'",
        {"Subscriber(A": "Subscriber('b'", "ServiceProxy(A": "ServiceProxy('c'"},
    ),
    "what is put together": (
        "rospy.Subscriber(N + 'a', String, f)\n".replace("N", "'n/'"),
        "n renames topic 'n/a' to 'b'",
        {"'n/' + 'a'": "'b'"},
    ),
    "what is put together in a variable": (
        "def main():\n    t = 'n' + '/a'\n    rospy.Subscriber(t, String, f)\n",
        "n renames topic 'n/a' to 'b'",
        {"'n' + '/a'": "'b'"},
    ),
    "what is put together in a variable of others too": (
        "def main():\n    t = 'n' + '/a'\n    work(t)\n    rospy.Subscriber(t, String, f)\n",
        "n renames topic 'n/a' to 'b'",
        {"Subscriber(t": "Subscriber('b'"},
    ),
    "what only gave the old name goes": (
        "def main():\n    h = 'n/'\n    t = 'a'\n    work(h)\n"
        "    rospy.Subscriber(h + t, String, f)\n",
        "n renames topic 'n/a' to 'b'",
        {"    t = 'a'\n": "", "h + t": "'b'"},
    ),
    "a topic, and not the service of its name": (
        "rospy.wait_for_service('a')\nrospy.Subscriber('a', String, f)\n",
        TOPIC,
        {"Subscriber('a'": "Subscriber('b/c'"},
    ),
    "what is handed over": (
        "class C:\n    def __init__(self, topic):\n"
        "        rospy.Subscriber(topic, String, f)\n\n\nC('a')\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "what stands behind something else": (
        "def make(prefix=''):\n    rospy.Subscriber(prefix + 'a', String, f)\n"
        "    rospy.Subscriber(prefix + 'c', String, f)\n    work(prefix)\n\n\nmake()\n",
        TOPIC,
        {"'a'": "'b/c'"},
    ),
    "a default": (
        "t = rospy.get_param('~topic', 'a')\nrospy.Subscriber(t, String, f)\n",
        "n renames parameter '~topic' to '~in'",
        {"'~topic'": "'~in'"},
    ),
    "a private name": (
        "rospy.Subscriber('~a', String, f)\n",
        "n renames topic '~/a' to '~/b'",
        {"'~a'": "'~b'"},
    ),
    "a name that only looks private": (
        "rospy.Subscriber('~/a', String, f)\n",
        "n renames topic '/a' to '~/a'",
        {"'~/a'": "'~a'"},
    ),
    "a private service, and what waits for it": (
        "rospy.wait_for_service('~a')\nc = rospy.ServiceProxy('~a', Empty)\nc()\n",
        "n renames service '~/a' to '/a'",
        {"'~a'": "'/a'"},
    ),
    "all that waits for a service": (
        "rospy.wait_for_service('a')\nc = rospy.ServiceProxy('a', Empty, persistent=True)\nc()\n",
        "n renames service 'a' to 'b/c'",
        {"'a'": "'b/c'"},
    ),
    "two change places": (
        "rospy.Subscriber('a', String, f)\nrospy.Subscriber('b', String, g)\n",
        "n renames topic 'a' to 'x'\nn renames topic 'b' to 'a'\nn renames topic 'x' to 'b'",
        {"'a', String, f": "'b', String, f", "'b', String, g": "'a', String, g"},
    ),
    "there and back": (
        "rospy.Subscriber('a', String, f)\n",
        "n renames topic 'a' to 'x'\nn renames topic 'x' to 'a'",
        {},
    ),
}


@pytest.mark.parametrize("name", ROSPY)
def test_the_name_alone_changes(tmp_path: Path, name: str) -> None:
    body, statements, replaced = ROSPY[name]
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    expected = body
    for old, new in replaced.items():
        assert old in expected
        expected = expected.replace(old, f"\0{new}")
    assert outcome.text == HEAD + expected.replace("\0", "")
    assert outcome.found == []


def test_a_name_that_is_handed_over_and_used_is_refused(tmp_path: Path) -> None:
    body = "def make(t):\n    work(t)\n    rospy.Subscriber(t, String, f)\n\n\nmake('a')\n"
    outcome = Outcome(tmp_path, "rospy", HEAD + body, TOPIC)
    assert outcome.text == HEAD + body
    (found,) = outcome.found
    assert found.code == "edit-refused"
    assert "line 6 does not say the name of the subscription `a` itself" in found.message


TOLD = [
    "rospy.loginfo('on %s', A)",
    "rospy.logwarn_throttle(1, 'on {}'.format(A))",
    "log(f'on {A}')",
    "rospy.logdebug(('on ' + str(A),))",
    "rospy.loginfo('on %s', rospy.resolve_name(A))",
    "print('on', A, file=sys.stderr)",
    "warnings.warn('no %s' % A)",
    "logging.error('on %s', A)",
    "self.get_logger().info(f'on {A}')",
    "node._logger.warning('on %s, %s' % (A, 1))",
    "rospy.wait_for_service(A)",
    "raise RuntimeError('no ' + A)",
    "sys.exit('no %s' % A)",
    "print('no {}: {}'.format(A, 1))",
    "assert node.count_publishers(A) == 1",
    "text = 'on %s' % A; print(text)",
    "other = A; rospy.wait_for_service(other); rospy.loginfo(other)",
    "tell(A)",
    "tell('on', what=A)",
    "subs = {}; subs[A] = 1; print(subs[A], A in subs)",
    "subs = {A: 1}; print(len(subs.values()))",
    "print(1) if not A else print(2)",
]
NOT_TOLD = [
    "work(A)",
    "rospy.loginfo(names[A])",
    "rospy.loginfo(work(A))",
    "rospy.loginfo('on' if A == 'a' else 'off')",
    "text = 'on %s' % A; work(text)",
    "other = A; work(other)",
    "tell(A, out=A)",
    "subs = {}; subs[A] = 1; work(subs)",
    "subs = {A: 1}; print([work(each) for each in subs])",
    "subs = work(); print(subs[A])",
    "print('on' if A else 'off' + A, work(A is None or A))",
    "rospy.set_param('~in', A)",
    "catalog.info(A)",
]


@pytest.mark.parametrize("use", TOLD + NOT_TOLD)
@pytest.mark.parametrize("variable", ["A", "self.topic"])
@pytest.mark.parametrize(
    "statement", [TOPIC, "unsubscribe n from 'a'\nsubscribe n to 'b/c' of message_type String"]
)
def test_what_logs_a_name_logs_the_new_one(
    tmp_path: Path, use: str, variable: str, statement: str
) -> None:
    text = f"import rospy, sys\nfrom rospy import loginfo as log\n{HEAD}\n\n"
    text += (
        "def tell(text, what=None, out=''):\n    print(text, what)\n    work(out)\n\n\nclass N:\n"
    )
    text += "    def go(self):\n"
    text += f"        A = 'a'  # the topic\n        {use}\n        rospy.Subscriber(A, String, f)\n"
    text = text.replace("A", variable)
    outcome = Outcome(tmp_path, "rospy", text, statement)
    old, new = (" = 'a'", " = 'b/c'") if use in TOLD else (f"({variable}, Str", "('b/c', Str")
    assert outcome.text == text.replace(old, new)
    assert outcome.found == []


HELD = {
    "T = {'in': 'a', 'out': 'o'}\nrospy.Subscriber(T['in'], String, f)\n": {
        "rospy.Publisher(T['out'], String)": True,
        "rospy.loginfo('in %s', T['in'])": True,
        "print(T)": True,
        "work(T['in'])": False,
        "work(T)": False,
        "for each in T.values():\n    work(each)": False,
    },
    "T = ('a', 'o')\nrospy.Subscriber(T[0], String, f)\n": {
        "rospy.Publisher(T[1], String)": True,
        "work(T[-2])": False,
        "rospy.loginfo('in %s', T[0])": True,
    },
    "T = {'on': {'in': 'a'}}\nrospy.Subscriber(T['on']['in'], String, f)\n": {
        "print(T['on']['in'])": True,
        "work(T['off'])": True,
        "work(T['on'])": False,
    },
    "def t():\n    return 'a'\n\n\nrospy.Subscriber(t(), String, f)\n": {
        "rospy.loginfo('in %s', t())": True,
        "work(t())": False,
        "work(t)": False,
    },
}


@pytest.mark.parametrize(("body", "use"), [(body, use) for body in HELD for use in HELD[body]])
def test_what_a_container_or_a_function_gives_to_others_stays(
    tmp_path: Path, body: str, use: str
) -> None:
    text = f"{HEAD}{body}{use}\n"
    outcome = Outcome(tmp_path, "rospy", text, TOPIC)
    given = re.findall(r"Subscriber\((.*?), String", body)[0]
    changed = ("'a'", "'b/c'") if HELD[body][use] else (f"Subscriber({given}", "Subscriber('b/c'")
    assert outcome.text == text.replace(*changed)


# A variable of a function that has one name after the other, and whether its literal changes.
ONE_BY_ONE = {
    "A = 'o'\nMAKE\nprint(A)\nA = 'a'\nSUB\nprint(A)\nA = 'p'\nMAKE\nwork(A)": True,
    "A = 'a'\nSUB\nwhile wait():\n    print(f'no {A}')\nA = 'o'\nwork(A)": True,
    "A = 'a'\nif q:\n    SUB\n    raise OSError('no ' + A)\nA = work(1)\nMAKE": True,
    "if q:\n    A = 'a'\n    SUB\n    A = 'o'\n    work(A)": True,
    "A = 'o'\nwork(A)\nA: str = 'a'\nSUB": True,
    "A = 'a'\nSUB\nMAKE\nA = 'o'": False,
    "A = 'a'\nSUB\nwork(A)\nA = 'o'\nprint(A)": False,
    "A = 'a'\nSUB\nA = A + 'o'\nwork(A)": False,
    "A = 'a'\nSUB\nA = A\nwork(A)": False,
    "A = B = 'a'\nSUB\nA = 'o'\nwork(A, B)": False,
    "A = 'a'\nSUB\nA += 'o'\nwork(A)": False,
    "A = 'a'\nSUB\nif q:\n    A = 'o'\nwork(A)": False,
    "A = 'a'\nSUB\nif q:\n    A = 'o'\n    work(A)": False,
    "for q in work(1):\n    A = 'a'\n    SUB\n    A = 'o'\n    work(A)": False,
    "try:\n    A = 'a'\n    SUB\n    A = 'o'\nexcept OSError:\n    work(A)": False,
    "A = 'a'\nSUB\ndef told():\n    work(A)\nA = 'o'\ntold()": False,
    "A = 'o'\ndef told():\n    work(A)\nA = 'a'\nSUB\ntold()\nA = 'o'": False,
    "A = 'o'\neach = (work(A) for _ in q)\nA = 'a'\nSUB\nlist(each)": False,
    "A = 'a'\nSUB\neach = (work(A) for _ in q)\nA = 'o'": False,
}


@pytest.mark.parametrize("body", ONE_BY_ONE)
def test_the_literal_changes_where_a_local_has_one_name_after_the_other(
    tmp_path: Path, body: str
) -> None:
    lines = body.replace("SUB", "rospy.Subscriber(A, String, f)")
    lines = lines.replace("MAKE", "rospy.Service(A, Empty, f)")
    text = f"{HEAD}\n\ndef go(q):\n    " + lines.replace("\n", "\n    ") + "\n\n\ngo(1)\n"
    outcome = Outcome(tmp_path, "rospy", text, TOPIC)
    in_call = ("Subscriber(A", "Subscriber('b/c'")
    assert outcome.text == text.replace(*("'a'", "'b/c'") if ONE_BY_ONE[body] else in_call)


RCLPY_HEAD = """\
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String
from our_msgs.action import Dock


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
"""
RCLPY = {
    "quality of service": (
        'self.s = self.create_subscription(String, "a", self.f, qos_profile=qos, callback_group=g)',
        TOPIC,
        {'"a"': '"b/c"'},
    ),
    "an action": (
        "self.dock = ActionClient(self, Dock, 'a')",
        "n renames action 'a' to 'b/c'",
        {"'a'": "'b/c'"},
    ),
    "a service that logs tell, and another behind it": (
        "srv = 'a/on'\n        c = self.create_client(Dock, srv)\n"
        "        while not c.wait_for_service():\n            self.info(f'{srv} not there')\n"
        "        c.call_async(1)\n        srv = 'o/on'\n        d = self.create_client(Dock, srv)\n"
        "        d.call_async(1)\n        self.info(f'{srv} there')\n\n"
        "    def info(self, text):\n        self.get_logger().info(text)",
        "n renames service 'a/on' to 'b/on'",
        {"'a/on'": "'b/on'"},
    ),
    "a parameter, where it is asked for, declared and read": (
        "if not self.has_parameter('a'):\n            self.declare_parameter('a', 1)\n"
        "        self.get_parameter('a').value",
        "n renames parameter 'a' to 'b.c'",
        {"'a'": "'b.c'"},
    ),
    "a parameter in a period and a topic": (
        "self.declare_parameter('a', 2)\n        self.declare_parameter('t')\n"
        "        self.create_timer(1 / self.get_parameter('a').value, self.tick)\n"
        "        self.create_timer(self.get_parameter('t').value, self.tick)\n"
        "        self.create_publisher(Dock, self.get_parameter('t').value, 10)",
        "n renames parameter 'a' to 'b'\nn renames parameter 't' to 'a'",
        {"'a'": "'b'", "'t'": "'a'"},
    ),
    "a parameter in a list": (
        "self.declare_parameters('', [('a', 2), ('b', 3)])\n        self.get_parameter('a').value",
        "n renames parameter 'a' to 'c'",
        {"'a'": "'c'"},
    ),
    "a parameter where changes are heard of": (
        "self.declare_parameter('a', 2)\n\n    def heard(self, changes):\n"
        "        for each in changes:\n            if each.name == 'a' or each.kind == 'a':\n"
        "                self.get_logger().info('a')",
        "n renames parameter 'a' to 'b'",
        {"parameter('a'": "parameter('b'", "name == 'a'": "name == 'b'"},
    ),
    "a parameter whose name has the sign of ROS 1": (
        "self.declare_parameter('~a', 1)\n        self.get_parameter('~a').value",
        "n renames parameter '~a' to 'b'",
        {"'~a'": "'b'"},
    ),
}


@pytest.mark.parametrize("name", RCLPY)
def test_the_name_alone_changes_in_rclpy(tmp_path: Path, name: str) -> None:
    body, statements, replaced = RCLPY[name]
    outcome = Outcome(tmp_path, "rclpy", f"{RCLPY_HEAD}        {body}\n", statements)
    for old, new in replaced.items():
        body = body.replace(old, new)
    assert outcome.text == f"{RCLPY_HEAD}        {body}\n"
    assert outcome.found == []


def test_among_nodes_of_one_file(tmp_path: Path) -> None:
    make = "class {0}(Node):\n    def __init__(self):\n        super().__init__('{1}')\n"
    make += "        self.create_subscription(String, 'a', self.f, 10)\n\n\n"
    head = "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"
    text = head + make.format("One", "one") + make.format("Two", "two")
    file = tmp_path / "nodes.py"
    file.write_text(text)
    program = f"load 'nodes.py' node 'two' as n\n{TOPIC}\ngenerate_node n\n"
    options = Options("rclpy", tmp_path / "output", in_place=True)
    session = Session(program.encode(), tmp_path / "a.plastron", options, environ={})
    write(session.plan()[0])
    first, second = text.split("class Two")
    assert file.read_text() == first + "class Two" + second.replace("'a'", "'b/c'")
