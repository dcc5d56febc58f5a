"""What a callback takes, and what ROS calls it with."""

from __future__ import annotations

import pytest
from message_programs import node
from message_programs import told as fields_told
from python_programs import diagnostics, marked, script, told, worker

LISTEN = "self.create_subscription(String, 'orders', {}, 10)"
ME = LISTEN.format("self.heard")
WRONG = f"{ME}  # wrong"
TICK = "self.create_timer(1.0, self.tick)"
SERVE = "self.create_service(Trigger, 'reset', self.reset)"
GOAL = "self.server = ActionServer(self, Fibonacci, 'fib', self.go{})"
REST = "    pass"

CASES = {
    "rospy, with an argument that may be none": script(
        """
        def heard(msg):
            pass

        def listen(more):
            rospy.Subscriber('orders', String, heard, more)
        """
    ),
    "a method of one's own that is called as one of rclpy": worker(
        "Pool().add_done_callback(self.done)", f"def done(self):\n{REST}"
    ).replace(
        "class Worker",
        "class Pool:\n    def add_done_callback(self, done):\n        done()\n\n\nclass Worker",
    ),
    "a message": worker(ME, f"def heard(self, msg):\n{REST}"),
    "a message and what is known of it": worker(ME, f"def heard(self, msg, info):\n{REST}"),
    "nothing": worker(WRONG, f"def heard(self):\n{REST}"),
    "too much": worker(WRONG, f"def heard(self, msg, info, more):\n{REST}"),
    "a default": worker(ME, f"def heard(self, msg, info=1, more=2):\n{REST}"),
    "any number": worker(ME, f"def heard(self, *args):\n{REST}"),
    "keywords alone": worker(WRONG, f"def heard(self, **more):\n{REST}"),
    "a keyword that it needs": worker(WRONG, f"def heard(self, msg, *, topic):\n{REST}"),
    "a keyword that it has": worker(ME, f"def heard(self, msg, *, topic=None):\n{REST}"),
    "no self": worker(WRONG, f"def heard():\n{REST}"),
    "a message in the place of self": worker(WRONG, f"def heard(msg):\n{REST}"),
    "types": worker(WRONG, f"def heard(self, msg: String, a: int, b: int) -> None:\n{REST}"),
    "a static method": worker(ME, f"@staticmethod\ndef heard(msg):\n{REST}"),
    "a static method with self": worker(
        ME.replace("self.heard, 10)", "self.heard, 10)  # wrong"),
        f"@staticmethod\ndef heard(self, msg, more):\n{REST}",
    ),
    "a class method": worker(WRONG, f"@classmethod\ndef heard(cls):\n{REST}"),
    "a decorator": worker(ME, f"@noticed\ndef heard(self):\n{REST}"),
    "a coroutine": worker(WRONG, f"async def heard(self):\n{REST}"),
    "a lambda": worker(LISTEN.format("lambda msg: None"), "pass"),
    "a lambda without": worker(LISTEN.format("lambda: None") + "  # wrong", "pass"),
    "a lambda with a default": worker(LISTEN.format("lambda msg, n=3, m=4: None"), "pass"),
    "a partial": worker(
        LISTEN.format("partial(self.heard, 'left')"), f"def heard(self, side, msg):\n{REST}"
    ),
    "a partial with too much": worker(
        LISTEN.format("partial(self.heard, 'left')") + "  # wrong",
        f"def heard(self, msg):\n{REST}",
    ),
    "a partial with a keyword": worker(
        LISTEN.format("functools.partial(self.heard, side='left')"),
        f"def heard(self, msg, side):\n{REST}",
    ),
    "a partial with a keyword in the message's place": worker(
        LISTEN.format("functools.partial(self.heard, side='left')") + "  # wrong",
        f"def heard(self, side):\n{REST}",
    ),
    "by keyword": worker(
        "self.create_subscription(\n"
        "    String, topic='orders', callback=self.heard,  # wrong\n    qos_profile=10)",
        f"def heard(self):\n{REST}",
    ),
    "a timer": worker(TICK, f"def tick(self):\n{REST}"),
    "a timer with an event": worker(f"{TICK}  # wrong", f"def tick(self, event):\n{REST}"),
    "a timer with what it may ask for": worker(TICK, f"def tick(self, info: TimerInfo):\n{REST}"),
    "a timer with a default": worker(TICK, f"def tick(self, event=None):\n{REST}"),
    "a service": worker(SERVE, f"def reset(self, request, response):\n{REST}"),
    "a service as in rospy": worker(f"{SERVE}  # wrong", f"def reset(self, request):\n{REST}"),
    "a service with too much": worker(f"{SERVE}  # wrong", f"def reset(self, a, b, c):\n{REST}"),
    "a goal": worker(GOAL.format(""), f"def go(self, goal):\n{REST}"),
    "a goal without": worker(GOAL.format("") + "  # wrong", f"def go(self):\n{REST}"),
    "a goal's other callbacks": worker(
        GOAL.format(", goal_callback=self.take, cancel_callback=self.stop") + "  # wrong",
        f"def go(self, goal):\n{REST}\n\ndef take(self, goal):\n{REST}\n\ndef stop(self):\n{REST}",
    ),
    "an answer": worker(
        "client = self.create_client(Trigger, 'reset')\n"
        "client.call_async(Trigger.Request()).add_done_callback(self.done)  # wrong",
        f"def done(self):\n{REST}",
    ),
    "feedback": worker(
        "self.goals = ActionClient(self, Fibonacci, 'fib')\n"
        "self.goals.send_goal_async(Fibonacci.Goal(), feedback_callback=self.told)  # wrong",
        f"def told(self, goal, feedback):\n{REST}",
    ),
    "parameters": worker(
        "self.add_on_set_parameters_callback(self.changed)  # wrong", f"def changed(self):\n{REST}"
    ),
    "left to other classes": worker(ME, "def heard(self):\n    raise NotImplementedError"),
    "called at once": worker(
        "self.create_timer(1.0, self.tick())  # wrong", f"def tick(self):\n{REST}"
    ),
    "called for what it gives": worker(
        "self.create_timer(1.0, self.ticking(3))",
        "def ticking(self, number):\n    return lambda: print(number)",
    ),
    "messages that come together": worker(
        "self.both = message_filters.TimeSynchronizer([a, b], 10)\n"
        "self.both.registerCallback(self.heard)\n"
        "self.both.registerCallback(self.alone)  # wrong\n"
        "self.both.registerCallback(self.named, 'left')",
        f"def heard(self, a, b):\n{REST}\n\ndef alone(self, a):\n{REST}\n\n"
        f"def named(self, a, b, side):\n{REST}",
    ),
    "a method of a base class": worker(LISTEN.format("super().heard"), f"def heard(self):\n{REST}"),
    "a function of the file": worker(LISTEN.format("heard") + "  # wrong", "pass")
    + "def heard():\n    pass\n",
    "bound twice": worker(ME + "\nself.heard = self.other", f"def heard(self):\n{REST}"),
    "rospy, a message": script(
        """
        def heard(msg):
            pass

        rospy.Subscriber('orders', String, heard)
        """
    ),
    "rospy, nothing": script(
        """
        def heard():
            pass

        rospy.Subscriber('orders', String, heard)  # wrong
        rospy.Timer(rospy.Duration(1), heard)  # wrong
        rospy.Service('reset', Trigger, heard)  # wrong
        """
    ),
    "rospy, arguments besides": script(
        """
        def heard(msg, side):
            pass

        rospy.Subscriber('left', String, heard, 'left')
        rospy.Subscriber('right', String, heard, callback_args=('right',))
        rospy.Subscriber('orders', String, heard)  # wrong
        """
    ),
    "rospy, arguments that it does not take": script(
        """
        def heard(msg):
            pass

        rospy.Subscriber('left', String, heard, callback_args='left')  # wrong
        """
    ),
    "rospy, the end": script(
        """
        def end(reason):
            pass

        rospy.init_node('worker')
        rospy.on_shutdown(end)  # wrong
        """
    ),
    "a managed node": worker("pass", f"def on_configure(self):  # wrong\n{REST}").replace(
        "(Node)", "(LifecycleNode)"
    ),
    "rospy, a method": script(
        """
        class Worker:
            def __init__(self):
                rospy.Subscriber('left', String, self.heard)  # wrong
                rospy.Service('reset', Trigger, self.reset)  # wrong
                self.server = actionlib.SimpleActionServer('fib', FibonacciAction, self.go)  # wrong
                self.server.register_preempt_callback(self.stop)  # wrong

            def heard():
                pass

            def reset(self, request, response):
                pass

            def go(self):
                pass

            def stop(self, goal):
                pass
        """
    ),
    "rospy, a goal's callbacks": script(
        """
        class Worker:
            def __init__(self):
                self.client = actionlib.SimpleActionClient('fib', FibonacciAction)
                self.client.send_goal(None, self.done, self.active, self.fed)
                self.client.send_goal(None, done_cb=self.active)  # wrong

            def done(self, status, result):
                pass

            def active(self):
                pass

            def fed(self, feedback):
                pass
        """
    ),
}


def test_nothing_is_told_of_a_file_that_does_not_parse() -> None:
    text = worker(ME, f"def heard(self):\n{REST}")
    assert told(text, "RC403") != []
    assert told(f"{text}\ndef (:\n", "RC403") == []


@pytest.mark.parametrize("text", CASES.values(), ids=CASES)
def test_a_callback_that_cannot_be_called_is_told(text: str) -> None:
    assert told(text, "RC403") == marked(text)


@pytest.mark.parametrize(
    ("more", "help_"),
    [
        ("10", "write `queue_size=10`"),
        ("{}", "let it take the message and the other, or leave `callback_args` out"),
    ],
)
def test_what_is_called_with_more_says_with_what(more: str, help_: str) -> None:
    text = script(f"""
        def heard(msg):
            pass

        rospy.Subscriber('orders', String, heard, {more})
    """)
    (found,) = diagnostics(text, "RC403")
    assert found.message == (
        "`heard` takes 1 argument, and is called with 2 arguments: the message, and "
        f"`{more}` as `callback_args`"
    )
    assert found.help == help_


@pytest.mark.parametrize(("parameters", "count"), [("request, response", 2), ("request", 1)])
def test_what_a_callback_gets_that_cannot_be_called_has_no_fields(
    parameters: str, count: int
) -> None:
    text = node(f"""
        def on_set(self, {parameters}):
            print(request.dota)
            Vector3().w = 1.0
    """)
    assert len(fields_told(text, "RM201")) == count


@pytest.mark.parametrize(
    ("made", "method", "message", "help_"),
    [
        (TICK, "def tick():", "its object", "`def tick(self)`"),
        (ME, "def heard(msg):", "its object and 1 argument", "`def heard(self, msg)`"),
        (
            ME,
            "async def heard(\n    msg: String,  # it\n) -> None:",
            "its object and 1 argument",
            "`async def heard(self, msg: String)`",
        ),
        (
            SERVE,
            "def reset(request, response):",
            "its object and 2 arguments",
            "`def reset(self, request, response)`",
        ),
        (
            LISTEN.format("partial(self.heard, 1, side='left')"),
            "def heard(number, msg, *, side, more=None):",
            "its object and 1 argument",
            "`def heard(self, number, msg, *, side, more=None)`",
        ),
        (
            GOAL.format(", cancel_callback=self.go"),
            "def go(goal):",
            "its object and 1 argument",
            "`def go(self, goal)`",
        ),
    ],
)
def test_a_method_without_self_is_told_so(made: str, method: str, message: str, help_: str) -> None:
    found = diagnostics(worker(made, f"{method}\n{REST}"), "RC403")
    assert found
    name = method.removeprefix("async ").removeprefix("def ").partition("(")[0]
    for each in found:
        start = f"`{name}` is a method without `self`, and is called with "
        assert (each.message, each.help) == (start + message, f"add `self`: {help_}")


@pytest.mark.parametrize(
    ("made", "method"),
    [
        (ME, "def heard():"),
        (ME, "def heard(self):"),
        (ME, "def heard(this):"),
        (ME, "def heard(slef):"),
        (ME, "@classmethod\ndef heard(klass):"),
        (ME, "@staticmethod\ndef heard(a, b, c):"),
        (ME, "def heard(a, b, c, d):"),
        (SERVE, "def reset(request):"),
        (LISTEN.format("lambda: None"), "def heard():"),
    ],
)
def test_what_would_not_fit_with_self_either_is_told_what_to_take(made: str, method: str) -> None:
    (found,) = diagnostics(worker(made, f"{method}\n{REST}"), "RC403")
    assert "method" not in found.message
    assert (found.help or "").startswith("let it take ")


@pytest.mark.parametrize("code", ["RM201", "RM202"])
def test_parameters_that_self_is_missing_before_are_not_reasoned_about(code: str) -> None:
    text = node("""
        def on_set(request, response):
            request.last.pose.position = 1
            text = String(data=response)
            print(response.datum, request.datum, text.datum)  # RM201
            return response

        def on_poses(msg):
            print(msg.last.pose)
            msg.last = 3
            for pose in msg.poses:
                print(pose.pose)

        def on_odometry(self, msg):
            print(msg.datum)  # RM201
            String(data=msg)  # RM202
    """)
    wanted = [line.strip() for line in text.splitlines() if line.endswith(f"# {code}")]
    assert fields_told(text, code) == wanted
