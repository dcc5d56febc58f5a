"""Endpoints that are created each time, and messages that are sent too early."""

from __future__ import annotations

import pytest
from python_programs import marked, script, told, worker

TIMER = "self.timer = self.create_timer(1.0, self.tick)\n"
LISTEN = "self.sub = self.create_subscription(String, 'orders', self.heard, 10)\n"
PUB = "pub = self.create_publisher(String, 'state', 10)"

AGAIN = {
    "in a timer": worker(TIMER, f"def tick(self):\n    {PUB}  # wrong\n    pub.publish(String())"),
    "as an attribute": worker(TIMER, f"def tick(self):\n    self.{PUB}  # wrong"),
    "in a subscription": worker(LISTEN, f"def heard(self, msg):\n    self.{PUB}  # wrong"),
    "for some messages": worker(
        LISTEN, f"def heard(self, msg):\n    if msg.data == 'go':\n        self.{PUB}  # wrong"
    ),
    "after some messages": worker(
        LISTEN,
        f"def heard(self, msg):\n    if not msg.data:\n        return\n    self.{PUB}  # wrong",
    ),
    "of a filter": worker(
        "self.sub = message_filters.Subscriber(self, String, 'orders')\n"
        "self.both = message_filters.TimeSynchronizer([self.sub], 10)\n"
        "self.both.registerCallback(self.heard)\n",
        f"def heard(self, msg):\n    self.{PUB}  # wrong",
    ),
    "and ended with the node": worker(
        LISTEN,
        f"def heard(self, msg):\n    self.{PUB}  # wrong\n\n"
        "def destroy_node(self):\n    self.destroy_publisher(self.pub)\n\n"
        "def on_cleanup(self, state):\n    self.destroy_publisher(self.pub)",
    ),
    "and ended by another callback": worker(
        LISTEN + TIMER,
        f"def heard(self, msg):\n    self.{PUB}\n\n"
        "def tick(self):\n    self.destroy_publisher(self.pub)",
    ),
    "and ended by a method that anybody may call": worker(
        LISTEN,
        f"def heard(self, msg):\n    self.{PUB}\n\n"
        "def end(self):\n    self.destroy_publisher(self.pub)\n\n"
        "def destroy_node(self):\n    self.end()",
    ),
    "in a transition": worker("pass", f"def on_activate(self, state):\n    self.{PUB}").replace(
        "(Node)", "(LifecycleNode)"
    ),
    "in a try": worker(
        TIMER,
        f"def tick(self):\n    try:\n        self.{PUB}  # wrong\n    except ValueError:\n"
        "        pass",
    ),
    "in a helper": worker(
        TIMER,
        f"""
        def tick(self):
            self.say('hello')

        def say(self, text):
            {PUB}  # wrong
            pub.publish(String(data=text))
        """,
    ),
    "a subscription": worker(
        TIMER,
        """
        def tick(self):
            self.create_subscription(String, 'a', self.heard, 10)  # wrong

        def heard(self, msg):
            self.create_timer(1.0, self.tick)  # wrong
        """,
    ),
    "a client": worker(
        LISTEN,
        "def heard(self, msg):\n"
        "    client = self.create_client(Trigger, 'reset')  # wrong\n"
        "    client.call_async(Trigger.Request())",
    ),
    "in a goal": worker(
        "self.server = ActionServer(self, Fibonacci, 'fib', self.go)",
        f"def go(self, goal):\n    {PUB}  # wrong",
    ),
    "if there is none": worker(
        "self.pub = None\n" + TIMER,
        f"def tick(self):\n    if self.pub is None:\n        self.{PUB}",
    ),
    "unless there is one": worker(
        "self.pub = None\n" + TIMER,
        f"def tick(self):\n    if self.pub:\n        return\n    self.{PUB}",
    ),
    "if it has none": worker(
        TIMER, f"def tick(self):\n    if not hasattr(self, 'pub'):\n        self.{PUB}"
    ),
    "where there is none": worker(
        TIMER,
        "def tick(self):\n    try:\n        self.pub.publish(String())\n"
        f"    except AttributeError:\n        self.{PUB}",
    ),
    "by a flag": worker(
        "self.is_first = True\n" + TIMER,
        f"def tick(self):\n    if self.is_first:\n        self.{PUB}\n"
        "        self.is_first = False",
    ),
    "if the node was made so": worker(
        "self.is_loud = True\n" + TIMER,
        f"def tick(self):\n    if self.is_loud:\n        self.{PUB}  # wrong",
    ),
    "if a dictionary has none": worker(
        "self.pubs = {}\n" + LISTEN,
        "def heard(self, msg):\n    pub = self.pubs.get(msg.data)\n    if pub is None:\n"
        f"        {PUB}\n        self.pubs[msg.data] = pub",
    ),
    "by a flag that is copied": worker(
        "self.is_done = False\n" + LISTEN,
        "def heard(self, msg):\n    is_first = not self.is_done\n    self.is_done = True\n"
        f"    if is_first:\n        self.{PUB}",
    ),
    "by a part of what comes": worker(
        LISTEN,
        "def heard(self, msg):\n    word = msg.data.strip()\n    if word == 'go':\n"
        f"        self.{PUB}  # wrong",
    ),
    "in a callback that gives itself up": worker(
        LISTEN,
        f"def heard(self, msg):\n    self.finish()\n    self.{PUB}\n\n"
        "def finish(self):\n    self.destroy_subscription(self.sub)",
    ),
    "by what a default keeps": worker(
        "def heard(msg, made=[]):\n    if not made:\n"
        f"        made.append(self.{PUB.removeprefix('pub = self.')})\n"
        "self.create_subscription(String, 'orders', heard, 10)",
        "pass",
    ),
    "by a list": worker(
        "self.pubs = []\n" + TIMER,
        f"def tick(self):\n    if not self.pubs:\n        {PUB}\n        self.pubs.append(pub)",
    ),
    "in a timer that ends": worker(
        TIMER, f"def tick(self):\n    self.timer.cancel()\n    self.{PUB}"
    ),
    "and destroyed": worker(TIMER, f"def tick(self):\n    {PUB}\n    self.destroy_publisher(pub)"),
    "of a name that comes": worker(
        LISTEN,
        "def heard(self, msg):\n    self.create_publisher(String, f'{msg.data}/state', 10)",
    ),
    "once": worker(f"self.{PUB}\n" + TIMER, "def tick(self):\n    self.pub.publish(String())"),
    "a timer that a request starts": worker(
        "self.create_service(Trigger, 'start', self.start)",
        "def start(self, request, response):\n    self.timer = self.create_timer(1.0, self.tick)\n"
        "    return response\n\ndef tick(self):\n    pass",
    ),
    "in a loop": worker(
        "pass",
        "pass",
        """
        node = Worker()
        while rclpy.ok():
            pub = node.create_publisher(String, 'state', 10)  # wrong
            pub.publish(String())
            rclpy.spin_once(node)
        """,
    ),
    "rospy, in a loop": script(
        """
        rospy.init_node('worker')
        while not rospy.is_shutdown():
            pub = rospy.Publisher('state', String, queue_size=1)  # wrong
            pub.publish('well')
            rospy.sleep(1)
        """
    ),
    "rospy, in a loop until it is there": script(
        """
        rospy.init_node('worker')
        while True:
            pub = rospy.Publisher('state', String, queue_size=1)
            if pub.get_num_connections():
                break
        """
    ),
    "rospy, in a loop that ends at times": script(
        """
        rospy.init_node('worker')
        while not rospy.is_shutdown():
            pub = rospy.Publisher('state', String, queue_size=1)  # wrong
            if is_enough():
                break
        """
    ),
    "rospy, in a callback": script(
        """
        def heard(msg):
            pub = rospy.Publisher('state', String, queue_size=1)  # wrong
            pub.publish(msg)
            ask = rospy.ServiceProxy('reset', Trigger)
            ask()
            rospy.Timer(rospy.Duration(1), other, oneshot=True)

        rospy.Subscriber('orders', String, heard)
        """
    ),
    "rospy, unless all ends": script(
        """
        def heard(msg):
            if rospy.is_shutdown():
                return
            rospy.Publisher('state', String, queue_size=1)  # wrong

        def stop():
            sub.unregister()

        sub = rospy.Subscriber('orders', String, heard)
        """
    ),
    "rospy, and unregistered": script(
        """
        def heard(msg):
            pubs.append(rospy.Publisher('state', String, queue_size=1))

        def stop():
            for pub in pubs:
                pub.unregister()

        rospy.Subscriber('orders', String, heard)
        """
    ),
    "rospy, in a timer that ticks once": script(
        """
        def heard(event):
            rospy.Publisher('state', String, queue_size=1)

        rospy.Timer(rospy.Duration(1), heard, oneshot=True)
        """
    ),
}

SEND = "self.pub.publish(String(data='ready'))"
LATCHED = "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)"
EARLY = {
    "at once": worker(f"self.{PUB}\n{SEND}  # wrong", "pass"),
    "with some lines between": worker(
        f"self.{PUB}\nmsg = String()\nmsg.data = 'ready'\nself.get_logger().info('ready')\n"
        "self.pub.publish(msg)  # wrong",
        "pass",
    ),
    "of the moment": worker(
        "self.create_publisher(String, 'state', 10).publish(String())  # wrong", "pass"
    ),
    "in main": worker(
        "pass",
        "pass",
        """
        node = Worker()
        pub = node.create_publisher(String, 'state', 10)
        pub.publish(String(data='ready'))  # wrong
        rclpy.shutdown()
        """,
    ),
    "to itself": worker(
        f"self.create_subscription(String, 'state', print, 10)\nself.{PUB}\n{SEND}", "pass"
    ),
    "twice": worker(f"self.{PUB}\n{SEND}  # wrong\n{SEND}", "pass"),
    "in a method": worker(
        f"self.{PUB}\nself.announce()", f"def announce(self):\n    {SEND}  # wrong"
    ),
    "of a method, among many words of its name": worker(
        "self.announce()",
        "def announce(self):\n    pub = self.create_publisher(String, 'state', 10)\n"
        "    pub.publish(String(data='publish public publications'))  # wrong\n"
        "    self.publisher = self.publishing = self.published = None\n",
    ),
    "in a method that waits": worker(
        f"self.{PUB}\nself.announce()", f"def announce(self):\n    time.sleep(1)\n    {SEND}"
    ),
    "in a method that is called again": worker(
        f"self.{PUB}\nself.announce()\nself.create_timer(1.0, self.announce)",
        f"def announce(self):\n    {SEND}",
    ),
    "for the node": worker(
        f"self.{PUB}",
        "pass",
        """
        node = Worker()
        node.pub.publish(String())  # wrong
        rclpy.shutdown()
        """,
    ),
    "by the node": worker(
        f"self.{PUB}",
        f"def announce(self):\n    {SEND}  # wrong",
        "node = Worker()\nnode.announce()\nrclpy.spin(node)",
    ),
    "by the node, after a while": worker(
        f"self.{PUB}",
        f"def announce(self):\n    {SEND}",
        "node = Worker()\ntime.sleep(1)\nnode.announce()\nrclpy.spin(node)",
    ),
    "kept": worker(f"self.pub = self.create_publisher(String, 'state', {LATCHED})\n{SEND}", "pass"),
    "with a profile that is not known": worker(
        f"self.pub = self.create_publisher(String, 'state', get_qos())\n{SEND}", "pass"
    ),
    "after a while": worker(f"self.{PUB}\ntime.sleep(1)\n{SEND}", "pass"),
    "once somebody is there": worker(
        f"self.{PUB}\nwhile self.pub.get_subscription_count() == 0:\n    time.sleep(0.1)\n{SEND}",
        "pass",
    ),
    "after something else": worker(f"self.{PUB}\nself.set_up()\n{SEND}", "pass"),
    "and again": worker(
        f"self.{PUB}\n{SEND}\n{TIMER}", "def tick(self):\n    self.pub.publish(String())"
    ),
    "later": worker(f"self.{PUB}\n{TIMER}", "def tick(self):\n    self.pub.publish(String())"),
    "never": worker(
        f"self.{PUB}\nreturn\n{SEND}",
        "pass",
    ),
    "rospy": script(
        """
        rospy.init_node('worker')
        pub = rospy.Publisher('state', String, queue_size=1)
        pub.publish('ready')  # wrong
        """
    ),
    "rospy, as the node starts": script(
        """
        pub = rospy.Publisher('state', String, queue_size=1)
        rospy.init_node('worker')
        msg = String()
        msg.data = 'ready'
        pub.publish(msg)  # wrong
        """
    ),
    "rospy, latched": script(
        """
        rospy.init_node('worker')
        pub = rospy.Publisher('state', String, queue_size=1, latch=True)
        pub.publish('ready')
        """
    ),
    "rospy, after a while": script(
        """
        rospy.init_node('worker')
        pub = rospy.Publisher('state', String, queue_size=1)
        rospy.sleep(1)
        pub.publish('ready')
        """
    ),
    "rospy, in a loop": script(
        """
        rospy.init_node('worker')
        pub = rospy.Publisher('state', String, queue_size=1)
        while not rospy.is_shutdown():
            pub.publish('ready')
        """
    ),
}


@pytest.mark.parametrize("text", AGAIN.values(), ids=AGAIN)
def test_an_endpoint_that_is_created_each_time_is_told(text: str) -> None:
    assert told(text, "RC404") == marked(text)


@pytest.mark.parametrize("text", EARLY.values(), ids=EARLY)
def test_a_message_that_nobody_can_hear_is_told(text: str) -> None:
    assert told(text, "RC408") == marked(text)


def test_what_a_callback_creates_each_time_is_told_once() -> None:
    text = worker(
        "self.sub = self.create_subscription(String, 'orders', self.heard, 10)",
        f"def heard(self, msg):\n    self.{PUB}\n    {SEND}",
    )
    assert told(text, "RC404") == [f"self.{PUB}"]
    assert told(text, "RC408") == []


def test_a_word_without_end_is_passed_over_once() -> None:
    """A line of data may be one word; at each of its letters it would be read to its end."""
    text = script("rospy.Subscriber('orders', String, print)\nDATA = '" + "z" * 300_000 + "'")
    assert told(text, "RC404") == []
