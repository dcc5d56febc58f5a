"""Sleeps in callbacks while others wait."""

from __future__ import annotations

import pytest
from python_programs import diagnostics, marked, script, told, worker

CLIENT = "self.client = self.create_client(Trigger, 'reset')\n"
MULTI = """
node = Worker()
executor = MultiThreadedExecutor()
executor.add_node(node)
executor.spin()
"""
ALONE = "self.sub = self.create_subscription(String, 'orders', self.on_order, 10)\n"
LISTEN = ALONE + "self.create_subscription(String, 'news', print, 10)\n"
RATE = "self.rate = self.create_rate(10)\n"
RATED = "def on_order(self, msg):\n    self.rate.sleep()"
SLEEPING = {
    "time": worker(LISTEN, "def on_order(self, msg):\n    time.sleep(1)  # wrong"),
    "a name": worker(LISTEN, "def on_order(self, msg):\n    sleep(0.5)  # wrong"),
    "unknown": worker(LISTEN, "def on_order(self, msg):\n    time.sleep(self.how_long)  # wrong"),
    "in a loop": worker(
        LISTEN,
        "def on_order(self, msg):\n    for _ in range(9):\n        time.sleep(0.1)  # wrong",
    ),
    "after a try that failed": worker(
        LISTEN,
        """
        def on_order(self, msg):
            for _ in range(5):
                try:
                    return self.send(msg)
                except OSError:
                    time.sleep(0.1)
            while not self.box.try_set(msg):
                self.tries += 1
                if self.tries > 9:
                    return
                time.sleep(0.05)
        """,
    ),
    "after tries that take long": worker(
        LISTEN,
        """
        def on_order(self, msg):
            for _ in range(5):
                try:
                    return self.send(msg)
                except OSError:
                    time.sleep(1.0)  # wrong
        """,
    ),
    "after tries without an end": worker(
        LISTEN,
        """
        def on_order(self, msg):
            while not self.box.try_set(msg):
                time.sleep(0.05)  # wrong
        """,
    ),
    "between steps that no try ends": worker(
        LISTEN,
        """
        def on_order(self, msg):
            for _ in range(5):
                self.step()
                time.sleep(0.05)  # wrong
        """,
    ),
    "in a helper": worker(
        LISTEN,
        """
        def on_order(self, msg):
            self.stop()

        def stop(self):
            time.sleep(2)  # wrong
        """,
    ),
    "in a goal": worker(
        "self.server = ActionServer(self, Fibonacci, 'fib', execute_callback=self.go)",
        "def go(self, goal):\n    time.sleep(1)  # wrong\n    return Fibonacci.Result()",
    ),
    "once for a callback": worker(
        LISTEN,
        "def on_order(self, msg):\n    time.sleep(0.1)  # wrong\n    time.sleep(2)",
    ),
    "nothing else waits": worker(ALONE, "def on_order(self, msg):\n    time.sleep(1)"),
    "the answer of a service waits": worker(
        ALONE + CLIENT, "def on_order(self, msg):\n    time.sleep(1)  # wrong"
    ),
    "before the end": worker(
        LISTEN,
        """
        def on_order(self, msg):
            if msg.data == 'end':
                time.sleep(1)
                self.destroy_node()
                sys.exit(0)
            self.stop()
            self.finish()

        def finish(self):
            for _ in range(9):
                self.stop()
                time.sleep(0.1)
            self.create_timer(1.0, self.shutdown)

        def stop(self):
            time.sleep(0.2)
        """,
    ),
    "where nothing runs": worker(
        LISTEN,
        """
        def on_order(self, msg):
            if msg.data:
                return
                time.sleep(1)
            if False:
                time.sleep(1)
            if msg.data == 'a':
                raise ValueError
            elif msg.data == 'b':
                time.sleep(2)  # wrong
                return
            else:
                return
            self.stop()

        def stop(self):
            time.sleep(2)
        """,
    ),
    "before a word of the end, or what may be it": worker(
        LISTEN,
        """
        def on_order(self, msg):
            time.sleep(1)  # wrong
            self.get_logger().info('exit')
            if msg.data == 'exit':
                sys.exit(0)
        """,
    ),
    "a demonstration": worker(
        LISTEN,
        "def on_order(self, msg):\n    # slow\n    self.get_logger().info('a')\n"
        "    time.sleep(1)\n    print('b')",
    ),
    "no time to speak of": worker(LISTEN, "def on_order(self, msg):\n    time.sleep(0.001)"),
    "several threads": worker(LISTEN, "def on_order(self, msg):\n    time.sleep(1)", MULTI),
    "a rate": worker(LISTEN + RATE, RATED + "  # wrong"),
    "where another file spins": worker(
        LISTEN, "def on_order(self, msg):\n    time.sleep(1)  # wrong", ""
    ),
    "where another file spins, and groups are told apart": worker(
        LISTEN
        + "self.create_timer(1.0, self.tick, callback_group=MutuallyExclusiveCallbackGroup())",
        "def on_order(self, msg):\n    time.sleep(1)\n\ndef tick(self):\n    pass",
        "",
    ),
    "a rate, several threads": worker(LISTEN + RATE, RATED, MULTI),
    "a rate of the moment": worker(
        LISTEN,
        "def on_order(self, msg):\n    rate = self.create_rate(2)\n    rate.sleep()  # wrong",
    ),
    "a clock": worker(
        LISTEN,
        "def on_order(self, msg):\n    self.get_clock().sleep_for(Duration(seconds=1))  # wrong",
    ),
    "rospy": script(
        """
        def heard(msg):
            rospy.sleep(0.1)
            rospy.sleep(rospy.Duration(0, 9000))
            rospy.Rate(1).sleep()  # wrong
            time.sleep(2)

        def tick(event):
            rospy.sleep(2)

        def waited(msg):
            rospy.sleep(rospy.get_param('~pause'))

        rospy.Subscriber('orders', String, heard)
        rospy.Subscriber('news', String, waited)
        rospy.Timer(rospy.Duration(9), tick)
        """
    ),
    "rospy, a duration": script(
        """
        SHORT = rospy.Duration(0.1)

        def heard(msg):
            rospy.sleep(SHORT)
            rospy.sleep(rospy.Duration(later()))
            rospy.sleep(rospy.Duration(nsecs=9))
            rospy.sleep(rospy.Duration(secs=0, nsecs=600000000))  # wrong

        rospy.Subscriber('orders', String, heard)
        """
    ),
    "rospy, what is meant": script(
        """
        def heard(msg):
            if msg.data:
                rospy.sleep(2)

        def again(msg):
            if msg.data:
                rospy.sleep(2)  # wrong

        def paced(msg):
            print(msg)
            rospy.sleep(2)

        def piled(msg):
            print(msg)
            rospy.sleep(2)  # wrong

        def stale(msg):
            rospy.sleep(2)  # wrong
            print(msg)

        def signal(msg):
            rospy.sleep(2)

        def once(msg):
            sub.unregister()
            rospy.sleep(2)

        rospy.Subscriber('heard', String, heard, queue_size=1)
        rospy.Subscriber('again', String, again)
        rospy.Subscriber('paced', String, paced, None, 1)
        rospy.Subscriber('piled', String, piled, queue_size=10)
        rospy.Subscriber('stale', String, stale, queue_size=1)
        rospy.Subscriber('signal', Empty, signal)
        sub = rospy.Subscriber('once', String, once)
        """
    ),
    "not in a callback": worker(LISTEN + "time.sleep(1)", "def on_order(self, msg):\n    pass"),
    "in a thread": worker(
        LISTEN,
        """
        def on_order(self, msg):
            threading.Thread(target=self.work).start()

        def work(self):
            time.sleep(1)
        """,
    ),
}


@pytest.mark.parametrize("text", SLEEPING.values(), ids=SLEEPING)
def test_a_sleep_in_a_callback_is_told(text: str) -> None:
    assert told(text, "RC402") == marked(text)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (SLEEPING["time"], "`on_order` sleeps: the"),
        (SLEEPING["in a helper"], "`stop` sleeps, which `on_order` calls: the"),
        (
            script("rospy.Subscriber('orders', String, lambda msg: rospy.sleep(2))"),
            "the lambda sleeps: the",
        ),
    ],
)
def test_who_sleeps_is_named(text: str, said: str) -> None:
    assert [each.message.partition(" n")[0] for each in diagnostics(text, "RC402")] == [said]


def test_remedy_for_a_goal_is_no_timer() -> None:
    (found,) = diagnostics(SLEEPING["in a goal"], "RC402")
    assert found.help is not None
    assert "`MultiThreadedExecutor`" in found.help
