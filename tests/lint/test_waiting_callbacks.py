"""What waits in a callback for what only comes once the callback has returned."""

from __future__ import annotations

import pytest
from python_programs import marked, script, told, worker

CLIENT = "self.client = self.create_client(Trigger, 'reset')\n"
TIMER = "self.timer = self.create_timer(1.0, self.tick)\n"
MULTI = """
node = Worker()
executor = MultiThreadedExecutor()
executor.add_node(node)
executor.spin()
"""
SINGLE = MULTI.replace("Multi", "Single")
TICK = "def tick(self):\n    self.client.call(Trigger.Request())"
WRONG = f"{TICK}  # wrong"
SPIN_IN = """
def tick(self):
    future = self.client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(self, future){}
"""
GROUPS = """
self.group = {one}()
self.client = self.create_client(Trigger, 'reset', callback_group=self.group)
self.timer = self.create_timer(1.0, self.tick, callback_group={other})
"""
EXCLUSIVE, REENTRANT = "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"

BLOCKING = {
    "in a timer": worker(CLIENT + TIMER, WRONG),
    "in an executor of several threads, in one group": worker(CLIENT + TIMER, WRONG, MULTI),
    "in an executor of one thread": worker(CLIENT + TIMER, WRONG, SINGLE),
    "where another file spins": worker(CLIENT + TIMER, WRONG, ""),
    "with the group of the client's own": worker(
        GROUPS.format(one=EXCLUSIVE, other="self.group"), WRONG, MULTI
    ),
    "with another group, but one thread": worker(GROUPS.format(one=EXCLUSIVE, other="None"), WRONG),
    "with another group, and several threads": worker(
        GROUPS.format(one=EXCLUSIVE, other="None"), TICK, MULTI
    ),
    "with a group that lets all run": worker(
        GROUPS.format(one=REENTRANT, other="self.group"), TICK, MULTI
    ),
    "with a group of its own, and several threads": worker(
        GROUPS.format(one=EXCLUSIVE, other=f"{EXCLUSIVE}()"), TICK, MULTI
    ),
    "with another group for all, and several threads": worker(
        f"self._default_callback_group = {REENTRANT}()\n" + CLIENT + TIMER, TICK, MULTI
    ),
    "in a callback that is called as the program's function": worker(
        CLIENT + TIMER.replace("tick", "main"), WRONG.replace("tick", "main")
    ),
    "with a time-out": worker(
        CLIENT + TIMER,
        "def tick(self):\n    self.client.call(Trigger.Request(), timeout_sec=1.0)  # wrong",
    ),
    "in a helper": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            self.reset()

        def reset(self):
            request = Trigger.Request()
            return self.client.call(request)  # wrong
        """,
    ),
    "in a helper that gets the client": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            self.ask(self.client)

        def ask(self, client):
            return client.call(Trigger.Request())  # wrong
        """,
    ),
    "in a subscription": worker(
        CLIENT + "self.create_subscription(String, 'orders', self.on_order, 10)",
        "def on_order(self, msg):\n    if msg.data:\n"
        "        result = self.client.call(Trigger.Request())  # wrong",
    ),
    "in a service": worker(
        CLIENT + "self.srv = self.create_service(SetBool, 'on', self.on)",
        """
        def on(self, request, response):
            answer = self.client.call(Trigger.Request())  # wrong
            response.success = answer.success
            return response
        """,
    ),
    "in a lambda": worker(
        CLIENT + "self.create_timer(1.0, lambda: self.client.call(Trigger.Request()))  # wrong",
        "pass",
    ),
    "in a partial": worker(
        CLIENT + "self.create_timer(1.0, partial(self.tick, 1))",
        "def tick(self, number):\n    self.client.call(Trigger.Request())  # wrong",
    ),
    "of a client of the moment": worker(
        TIMER,
        """
        def tick(self):
            client = self.create_client(Trigger, 'reset')
            client.wait_for_service()
            client.call(Trigger.Request())  # wrong
        """,
    ),
    "in a thread": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            threading.Thread(target=self.work).start()

        def work(self):
            self.client.call(Trigger.Request())
        """,
    ),
    "of another node": worker(
        "self.other = rclpy.create_node('other')\n"
        "self.client = self.other.create_client(Trigger, 'reset')\n" + TIMER,
        TICK,
    ),
    "of what may be anything": worker("self.client = open_client()\n" + TIMER, TICK),
    "while nothing waits": worker(
        CLIENT + TIMER, "def tick(self):\n    self.client.call_async(Trigger.Request())"
    ),
    "outside of callbacks": worker(
        CLIENT, "def reset(self):\n    self.client.call(Trigger.Request())"
    ),
    "spinning": worker(CLIENT + TIMER, SPIN_IN.format("  # wrong")),
    "spinning, several threads": worker(CLIENT + TIMER, SPIN_IN.format("  # wrong"), MULTI),
    "spinning, other group": worker(GROUPS.format(one=REENTRANT, other="None"), SPIN_IN.format("")),
    "spinning with an executor": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            self.future = self.client.call_async(Trigger.Request())
            self.executor.spin_until_future_complete(self.future, timeout_sec=2)  # wrong
        """,
    ),
    "spinning in a helper that gets the future": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.ask()
            self.wait(future)

        def ask(self):
            return self.client.call_async(Trigger.Request())

        def wait(self, future):
            rclpy.spin_until_future_complete(self, future)  # wrong
        """,
    ),
    "spinning in a goal, which is done apart": worker(
        CLIENT + "self.server = ActionServer(self, Fibonacci, 'fib', self.tick)",
        "def tick(self, goal):\n"
        "    future = self.client.call_async(Trigger.Request())\n"
        "    rclpy.spin_until_future_complete(self, future)",
    ),
    "in a goal of one thread": worker(
        CLIENT + "self.server = ActionServer(self, Fibonacci, 'fib', self.tick)",
        "def tick(self, goal):\n    self.client.call(Trigger.Request())  # wrong",
    ),
    "in a goal of several threads": worker(
        CLIENT + "self.server = ActionServer(self, Fibonacci, 'fib', self.tick)",
        "def tick(self, goal):\n    self.client.call(Trigger.Request())",
        MULTI,
    ),
    "polling": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.client.call_async(Trigger.Request())
            while not future.done():  # wrong
                pass
        """,
    ),
    "polling with a way out": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.client.call_async(Trigger.Request())
            while not future.done():
                if self.is_late():
                    break
        """,
    ),
    "polling until it is there": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.client.call_async(Trigger.Request())
            while rclpy.ok():
                rclpy.spin_once(self)
                if future.done():  # wrong
                    answer = future.result()
                    break
        """,
    ),
    "polling for a while": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.client.call_async(Trigger.Request())
            while rclpy.ok() and time.time() < self.end:
                if future.done():
                    break
        """,
    ),
    "an event that the answer sets": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            event = threading.Event()
            future = self.client.call_async(Trigger.Request())
            future.add_done_callback(lambda future: event.set())
            event.wait()  # wrong
        """,
    ),
    "an event that others set": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            future = self.client.call_async(Trigger.Request())
            future.add_done_callback(lambda future: self.event.set())
            self.event.wait()

        def stop(self):
            self.event.set()
        """,
    ),
    "spinning for ever": worker(TIMER, "def tick(self):\n    rclpy.spin(self)  # wrong"),
    "sending a goal": worker(
        "self.goals = ActionClient(self, Fibonacci, 'fib')\n" + TIMER,
        "def tick(self):\n    self.goals.send_goal(Fibonacci.Goal())  # wrong",
    ),
    "spinning for the result of a goal": worker(
        "self.goals = ActionClient(self, Fibonacci, 'fib')\n" + TIMER,
        """
        def tick(self):
            future = self.goals.send_goal_async(Fibonacci.Goal())
            rclpy.spin_until_future_complete(self, future)  # wrong
            goal = future.result()
            result = goal.get_result_async()
            rclpy.spin_until_future_complete(self, result)  # wrong
        """,
    ),
    "in a done callback": worker(
        CLIENT + TIMER,
        """
        def tick(self):
            self.client.call_async(Trigger.Request()).add_done_callback(self.done)

        def done(self, future):
            self.client.call(Trigger.Request())  # wrong
        """,
    ),
    "the result of a goal in a done callback": worker(
        "self.goals = ActionClient(self, Fibonacci, 'fib')\n" + TIMER,
        """
        def tick(self):
            future = self.goals.send_goal_async(Fibonacci.Goal())
            future.add_done_callback(self.on_accepted)

        def on_accepted(self, future):
            handle = future.result()
            if handle.accepted:
                handle.get_result()  # wrong
            self.other.get_result()
            handle.get_result_async().add_done_callback(self.on_result)

        def on_result(self, future):
            future.result().get_result()
        """,
    ),
    "the result of a goal that another thread may bring": worker(
        "self.goals = ActionClient(self, Fibonacci, 'fib')\n" + TIMER,
        """
        def tick(self):
            self.goals.send_goal_async(Fibonacci.Goal()).add_done_callback(self.on_accepted)

        def on_accepted(self, future):
            future.result().get_result()
        """,
        "executor = MultiThreadedExecutor()\nexecutor.add_node(Worker())\nexecutor.spin()",
    ),
    "as a managed node is configured": worker(
        CLIENT, "def on_configure(self, state):\n    self.client.call(Trigger.Request())  # wrong"
    ).replace("(Node)", "(LifecycleNode)"),
    "of a node that another file makes": worker(
        "self.helper = Helper()\nself.client = self.helper.create_client(Trigger, 'a')\n" + TIMER,
        TICK,
    ).replace("import time\n", "import time\nfrom helpers import Helper\n"),
    "in functions": worker("pass", "pass", "")
    + """
def main():
    rclpy.init()
    node = rclpy.create_node('worker')
    client = node.create_client(Trigger, 'reset')

    def tick():
        client.call(Trigger.Request())  # wrong

    node.create_timer(1.0, tick)
    rclpy.spin(node)
""",
    "of a node that a class has": worker("pass", "pass", "")
    + """
class Holder:
    def __init__(self):
        self.node = rclpy.create_node('worker')
        self.client = self.node.create_client(Trigger, 'reset')
        self.node.create_timer(1.0, self.tick)

    def tick(self):
        self.client.call(Trigger.Request())  # wrong
""",
    "of a base class": worker(CLIENT, "pass", "")
    + """
class Heir(Worker):
    def __init__(self):
        super().__init__()
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.client.call(Trigger.Request())  # wrong
""",
    "before return is dead": worker(
        CLIENT + TIMER,
        "def tick(self):\n    return\n    self.client.call(Trigger.Request())",
    ),
    "in rospy": script(
        """
        def tick(event):
            reset()

        rospy.init_node('worker')
        reset = rospy.ServiceProxy('reset', Trigger)
        rospy.Timer(rospy.Duration(1), tick)
        rospy.spin()
        """
    ),
}


@pytest.mark.parametrize("text", BLOCKING.values(), ids=BLOCKING)
def test_a_call_that_waits_for_its_own_thread_is_told(text: str) -> None:
    assert told(text, "RC401") == marked(text)
