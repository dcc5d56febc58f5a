"""Endpoints that change in a node where they stand: only the arguments that differ."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest
from updates import NODES, Outcome


class Case(NamedTuple):
    """A change: the statements, and the lines that go and come in each library."""

    statements: str
    rospy: str
    rclpy: str


CASES = {
    "the type, over several lines with comments": Case(
        "unsubscribe n from 'goal'\nsubscribe n to 'goal' of message_type Float32 calling on_goal",
        """
-from std_msgs.msg import Int32, String
+from std_msgs.msg import Float32, Int32, String
-            String,
+            Float32,
""",
        """
-from std_msgs.msg import Int32, String
+from std_msgs.msg import Float32, Int32, String
-            String,
+            Float32,
""",
    ),
    "the callback": Case(
        "unsubscribe n from 'goal'\nsubscribe n to 'goal' of message_type String calling stop",
        "-            self.on_goal,\n+            self.stop,",
        "-            self.on_goal,\n+            self.stop,",
    ),
    "the topic": Case(
        "unsubscribe n from 'goal'\nsubscribe n to '/nav/goal' of message_type String",
        "-            'goal',  # where to go\n+            '/nav/goal',  # where to go",
        '-            "goal",  # where to go\n+            "/nav/goal",  # where to go',
    ),
    "topic and callback": Case(
        "unsubscribe n from 'goal'\nsubscribe n to 'aim' of message_type String calling stop",
        """
-            'goal',  # where to go
+            'aim',  # where to go
-            self.on_goal,
+            self.stop,
""",
        """
-            "goal",  # where to go
+            "aim",  # where to go
-            self.on_goal,
+            self.stop,
""",
    ),
    "the type of a topic that a constant names": Case(
        "unsubscribe n from 'mode'\nsubscribe n to 'mode' of message_type Int32 calling on_mode",
        """
-        rospy.Subscriber(MODE, String, callback=self.on_mode)
+        rospy.Subscriber(MODE, Int32, callback=self.on_mode)
""",
        """
-        self.create_subscription(String, MODE, callback=self.on_mode, qos_profile=10)
+        self.create_subscription(Int32, MODE, callback=self.on_mode, qos_profile=10)
""",
    ),
    "the topic that is published, by keyword": Case(
        "n stop_publishing to 'beat'\nn publish two to 'pulse' of message_type Int32 at 2 hz",
        """
-        self.beat = rospy.Publisher('beat', data_class=Int32, latch=True, queue_size=7)  # slow
+        self.beat = rospy.Publisher('pulse', data_class=Int32, latch=True, queue_size=7)  # slow
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Int32(data=2))  # alive
""",
        """
-        self.beat = self.create_publisher(msg_type=Int32, topic="beat", qos_profile=latched)  #
+        self.beat = self.create_publisher(msg_type=Int32, topic="pulse", qos_profile=latched)  #
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Int32(data=2))  # alive
""",
    ),
    "the type that is published, with its message": Case(
        "n stop_publishing to 'beat'\nn publish half to 'beat' of message_type Float32",
        """
-from std_msgs.msg import Int32, String
+from std_msgs.msg import Float32, String
-        self.beat = rospy.Publisher('beat', data_class=Int32, latch=True, queue_size=7)  # slow
+        self.beat = rospy.Publisher('beat', data_class=Float32, latch=True, queue_size=7)  # slow
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Float32(data=0.5))  # alive
""",
        """
-from std_msgs.msg import Int32, String
+from std_msgs.msg import Float32, String
-        self.beat = self.create_publisher(msg_type=Int32, topic="beat", qos_profile=latched)  #
+        self.beat = self.create_publisher(msg_type=Float32, topic="beat", qos_profile=latched)  #
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Float32(data=0.5))  # alive
""",
    ),
    "the rate": Case(
        "n stop_publishing to 'beat'\nn publish two to 'beat' of message_type Int32 at 4 hz",
        """
-        rospy.Timer(rospy.Duration(0.5), self.tick)
+        rospy.Timer(rospy.Duration(0.25), self.tick)
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Int32(data=2))  # alive
""",
        """
-        self.timer = self.create_timer(0.5, self.tick, self.group)
+        self.timer = self.create_timer(0.25, self.tick, self.group)
-        self.beat.publish(Int32(data=1))  # alive
+        self.beat.publish(Int32(data=2))  # alive
""",
    ),
    "the service type": Case(
        "n stop_service 'reset'\nn provides_service 'reset' of service_type SetBool",
        """
-from std_srvs.srv import Empty, EmptyResponse, SetBool
+from std_srvs.srv import SetBool, SetBoolResponse
-        self.reset = rospy.Service(name='reset', service_class=Empty, handler=self.on_reset)
+        self.reset = rospy.Service(name='reset', service_class=SetBool, handler=self.on_reset)
-        return EmptyResponse()
+        return SetBoolResponse()
""",
        """
-from std_srvs.srv import Empty, SetBool
+from std_srvs.srv import SetBool
-            Empty, 'reset', self.on_reset, callback_group=self.group
+            SetBool, 'reset', self.on_reset, callback_group=self.group
""",
    ),
    "the service": Case(
        "n stop_service 'reset'\nn provides_service 'again' of service_type Empty",
        """
-        self.reset = rospy.Service(name='reset', service_class=Empty, handler=self.on_reset)
+        self.reset = rospy.Service(name='again', service_class=Empty, handler=self.on_reset)
""",
        """
-            Empty, 'reset', self.on_reset, callback_group=self.group
+            Empty, 'again', self.on_reset, callback_group=self.group
""",
    ),
    "nothing": Case(
        "unsubscribe n from 'goal'\nsubscribe n to 'goal' of message_type String", "", ""
    ),
}  # fmt: skip


def lines(diff: str) -> list[str]:
    return [f"{line[0]} {line[1:]}" for line in diff.strip().splitlines()]


@pytest.mark.parametrize("library", NODES)
@pytest.mark.parametrize("name", CASES)
def test_only_what_differs_is_changed(tmp_path: Path, name: str, library: str) -> None:
    case = CASES[name]
    outcome = Outcome(tmp_path, library, NODES[library], case.statements)
    assert outcome.diff == lines(getattr(case, library))
    compile(outcome.text, "node.py", "exec")


HEAD = """\
import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, SetBoolRequest
rospy.init_node('n')
"""
LOOP = """\
p = rospy.Publisher('a', String, queue_size=3)
rate = rospy.Rate(5)
while not rospy.is_shutdown():
    p.publish('on')  # on
    rate.sleep()
"""
TOPIC = "unsubscribe n from 'a'\nsubscribe n to 'b' of message_type String"
TYPE = "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type Int32"
CALLBACK = "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type String calling f"
SEND = "n stop_publishing to 'a'\nn publish off to 'a' of message_type String"
OFF = "-    p.publish('on')  # on\n+    p.publish(String(data='off'))  # on"
OFF_BY_TIMER = """
+def publish_a(event):
+    \"\"\"Publish to a.\"\"\"
+    message = String(data='off')
+    p.publish(message)
+rospy.Timer(rospy.Duration(0.5), publish_a)
-    p.publish('on')  # on
"""
ON_A = "+def on_a(message):\n+    rospy.loginfo('a: %s', message)"
ON_B = ON_A.replace("_a", "_b").replace("'a", "'b") + "\n+rospy.Subscriber('b', String, on_b)"

SMALL = {
    "the rate of a loop that does nothing else": (
        LOOP, f"{SEND} at 2 hz", f"-rate = rospy.Rate(5)\n+rate = rospy.Rate(2)\n{OFF}",
    ),
    "what a loop sends, at the loop's own rate": (
        LOOP.replace("    rate", "    work()\n    rate"), SEND, OFF,
    ),
    "a literal keeps its prefix and its quotes": (
        'rospy.Subscriber(r"""a""", String, **options)\n',
        TOPIC,
        '-rospy.Subscriber(r"""a""", String, **options)\n'
        '+rospy.Subscriber(r"""b""", String, **options)',
    ),
    "a type of a module": (
        "import std_msgs.msg as m\nrospy.Subscriber('a', m.String)\n",
        TYPE,
        "-rospy.Subscriber('a', m.String)\n+rospy.Subscriber('a', m.Int32)",
    ),
    "a new callback is written": (
        "def g(m): print(m)\nrospy.Subscriber('a', String, g, queue_size=3)\n",
        CALLBACK,
        "+def f(m):\n+    rospy.loginfo('a: %s', m)\n"
        "-rospy.Subscriber('a', String, g, queue_size=3)\n"
        "+rospy.Subscriber('a', String, f, queue_size=3)",
    ),
    "what waits for a service waits for the new one": (
        "rospy.wait_for_service('a')\nc = rospy.ServiceProxy('a', SetBool, persistent=True)\n"
        "class N:\n    def call(self, client, request): pass\n"
        "    def go(self):\n        self.call(c, SetBoolRequest(data=True))\n",
        "n stop_request 'a'\nn client_requests 'b' of service_type SetBool with input False",
        "-rospy.wait_for_service('a')\n+rospy.wait_for_service('b')\n"
        "-c = rospy.ServiceProxy('a', SetBool, persistent=True)\n"
        "+c = rospy.ServiceProxy('b', SetBool, persistent=True)\n"
        "-        self.call(c, SetBoolRequest(data=True))\n"
        "+        self.call(c, SetBoolRequest(data=False))",
    ),
    "a name that is put together": (
        "rospy.Subscriber('' + 'a', String, queue_size=3)\n",
        TOPIC,
        "-rospy.Subscriber('' + 'a', String, queue_size=3)\n"
        "+rospy.Subscriber('' + 'b', String, queue_size=3)",
    ),
    "a name that a constant says": (
        "A = 'a'\nrospy.Subscriber(A, String, queue_size=3)\n", TOPIC, "-A = 'a'\n+A = 'b'",
    ),
    "a name that a constant says to others too": (
        "A = 'a'\nrospy.Subscriber(A, String, queue_size=3)\nwork(A)\n",
        TOPIC,
        "-rospy.Subscriber(A, String, queue_size=3)\n"
        "+rospy.Subscriber('b', String, queue_size=3)",
    ),
    "a name that a caller gives": (
        "def make(name):\n    return rospy.Subscriber(name, String)\nmake('a')\n",
        TOPIC,
        "-make('a')\n+make('b')",
    ),
    "several calls of one name get another": (
        "rospy.Subscriber('a', String, f)\nrospy.Subscriber('a', String, f, queue_size=3)\n",
        f"{TOPIC} calling f",
        "-rospy.Subscriber('a', String, f)\n-rospy.Subscriber('a', String, f, queue_size=3)\n"
        "+rospy.Subscriber('b', String, f)\n+rospy.Subscriber('b', String, f, queue_size=3)",
    ),
    "several calls of one name get another type": (
        "rospy.Subscriber('a', String, queue_size=3)\nrospy.Subscriber('a', String)\nx = String\n",
        TYPE,
        "-rospy.Subscriber('a', String, queue_size=3)\n-rospy.Subscriber('a', String)\n"
        "+rospy.Subscriber('a', Int32, queue_size=3)\n+rospy.Subscriber('a', Int32)",
    ),
    "of several calls of one name that with the callback is meant": (
        "def g(m): print(m)\ndef f(m): print(String)\n"
        "rospy.Subscriber('a', String, g)\nrospy.Subscriber('a', String, f, queue_size=3)\n",
        f"{TYPE} calling f",
        "-rospy.Subscriber('a', String, g)\n-rospy.Subscriber('a', String, f, queue_size=3)\n"
        "+rospy.Subscriber('a', Int32, f, queue_size=3)",
    ),
}  # fmt: skip

ANEW = {
    "a type that a constant says": (
        "T = String\nrospy.Subscriber('a', T, queue_size=3)\n",
        TYPE,
        f"{ON_A}\n-rospy.Subscriber('a', T, queue_size=3)\n+rospy.Subscriber('a', Int32, on_a)",
    ),
    "several calls of one name, of which none has the callback": (
        "def g(m): print(m)\ndef h(m): print(m)\n"
        "rospy.Subscriber('a', String, g, queue_size=3)\nrospy.Subscriber('a', String, h)\n",
        CALLBACK,
        "-rospy.Subscriber('a', String, g, queue_size=3)\n-rospy.Subscriber('a', String, h)\n"
        "+def f(message):\n+    rospy.loginfo('a: %s', message)\n+rospy.Subscriber('a', String, f)",
    ),
    "a call without a callback gets one": (
        "def f(m): pass\nrospy.Subscriber('a', String, queue_size=3)\n",
        CALLBACK,
        "-rospy.Subscriber('a', String, queue_size=3)\n+rospy.Subscriber('a', String, f)",
    ),
    "another name and another type": (
        "rospy.Subscriber('a', Int32, queue_size=3)\nx = Int32\n",
        TOPIC,
        f"{ON_B[:-1]}, queue_size=3)\n-rospy.Subscriber('a', Int32, queue_size=3)",
    ),
    "two go and one comes": (
        "rospy.Subscriber('a', String)\nrospy.Subscriber('c', String)\n",
        f"{TOPIC}\nunsubscribe n from 'c'",
        f"{ON_B}\n-rospy.Subscriber('a', String)\n-rospy.Subscriber('c', String)",
    ),
    "the rate of a loop that does more": (
        LOOP.replace("    rate", "    work()\n    rate"), f"{SEND} at 2 hz", OFF_BY_TIMER,
    ),
    "the rate of two loops": (f"{LOOP}rate.sleep()\n", f"{SEND} at 2 hz", OFF_BY_TIMER),
}  # fmt: skip

REFUSED = {
    "what is used": ("p = rospy.Publisher('a', String)\nprint(p.impl)\np.publish('a')\n", SEND),
}  # fmt: skip


@pytest.mark.parametrize("name", [*SMALL, *ANEW])
def test_in_place_where_that_is_safe_and_anew_where_it_is_not(tmp_path: Path, name: str) -> None:
    body, statements, diff = {**SMALL, **ANEW}[name]
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    changed = [line for line in outcome.diff if len(line) > 1]
    assert sorted(changed) == sorted(lines(diff))
    compile(outcome.text, "node.py", "exec")


@pytest.mark.parametrize("library", NODES)
@pytest.mark.parametrize(
    ("statements", "told"),
    [
        (
            "unsubscribe n from 'goal'\nsubscribe n to 'goal' of message_type Int32",
            ["`on_goal` was written for `std_msgs/String`, and gets `std_msgs/Int32`"],
        ),
        (CASES["the type, over several lines with comments"].statements, []),
        (CASES["the service type"].statements, []),
        (CASES["the topic"].statements, []),
    ],
)
def test_a_callback_with_code_is_told_of_when_its_type_changes(
    tmp_path: Path, library: str, statements: str, told: list[str]
) -> None:
    outcome = Outcome(tmp_path, library, NODES[library], statements)
    assert [found.message for found in outcome.found] == told


@pytest.mark.parametrize("name", REFUSED)
def test_refused_as_before(tmp_path: Path, name: str) -> None:
    body, statements = REFUSED[name]
    outcome = Outcome(tmp_path, "rospy", HEAD + body, statements)
    assert outcome.diff == []
    assert [found.code for found in outcome.found] == ["endpoint-in-use"]
