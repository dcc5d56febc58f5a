"""Programs whose callbacks nobody calls."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from python_programs import marked, script, told, worker

from plastron_tui.sources.python.facts import code_facts
from plastron_tui.sources.python.reader import read_python

LISTEN = "self.sub = self.create_subscription(String, 'orders', self.heard, 10)\n"
HEARD = "def heard(self, msg):\n    pass"
MADE = "node = Worker()  # wrong\n"

GIVEN = {
    "made there": "run(Worker())",
    "by a keyword": "run(robot=Worker())",
    "in a list": "robots = [Worker()]\nrun(robots)",
    "in a dictionary": "run({'one': Worker()})",
    "within a block": "with Worker() as robot:\n    run(robot)",
    "in one go": "robot, count = Worker(), 1\nrun(robot)",
    "with a name": "run(robot := Worker())",
    "named before": "if robot := Worker():\n    run(robot)",
    "by another name": "robot = Worker()\nother = robot\nrun(other)",
    "as a class": "run(Worker)",
}
CASES = {
    "ends": worker(LISTEN, HEARD, f"{MADE}rclpy.shutdown()"),
    "says it in a comment": worker(LISTEN, HEARD, f"{MADE}# rclpy.spin(node)"),
    "sleeps": worker(LISTEN, HEARD, f"{MADE}time.sleep(10)"),
    "loops": worker(LISTEN, HEARD, f"{MADE}while rclpy.ok():\n    time.sleep(1)"),
    "destroys": worker(LISTEN, HEARD, f"{MADE}node.destroy_node()\nrclpy.shutdown()"),
    "a timer": worker("self.create_timer(1.0, self.heard)", HEARD, MADE),
    "a service": worker("self.create_service(Trigger, 'a', self.heard)", HEARD, MADE),
    "spins": worker(LISTEN, HEARD),
    "spins once at a time": worker(
        LISTEN, HEARD, "node = Worker()\nwhile rclpy.ok():\n    rclpy.spin_once(node)"
    ),
    "an executor": worker(
        LISTEN, HEARD, "node = Worker()\ne = SingleThreadedExecutor()\ne.add_node(node)\ne.spin()"
    ),
    "a thread": worker(
        LISTEN, HEARD, "node = Worker()\nthreading.Thread(target=rclpy.spin, args=(node,)).start()"
    ),
    "a method that spins": worker(
        LISTEN, HEARD + "\n\ndef run(self):\n    rclpy.spin(self)", "Worker().run()"
    ),
    "handed on": worker(LISTEN, HEARD, "node = Worker()\nrun(node)"),
    "no program": worker(LISTEN, HEARD, ""),
    "a base class that nobody knows": worker(LISTEN, HEARD, "node = Worker()").replace(
        "(Node)", "(Base)"
    ),
    "no callback": worker("self.create_publisher(String, 'a', 10)", "pass", "node = Worker()"),
    "a node of the library": worker("pass", "pass", "").replace("class Worker", "class Other")
    + "def main():\n    rclpy.init()\n    node = rclpy.create_node('worker')  # wrong\n"
    "    node.create_subscription(String, 'orders', print, 10)\n    rclpy.shutdown()\n",
    "spins another node": worker(
        LISTEN,
        HEARD,
        f"other = rclpy.create_node('other')\n{MADE}rclpy.spin(other)\nnode.destroy_node()",
    ),
    "says it in names of its own": worker(
        LISTEN + "self.spin_client = self.create_client(Trigger, 'spin')\n",
        HEARD + "\n\ndef spin_it(self):\n    spin_speed = 1\n    self.spin_client.call_async("
        "spin_speed)\n    self.spin_it()",
        MADE,
    ),
    "a name that another file gives": worker(LISTEN, HEARD, "node = Worker()\nspinner.go()"),
    "a parameter": worker(
        LISTEN, HEARD + "\n\ndef go(self, spinner):\n    spinner(self)", "node = Worker()"
    ),
    "a name for the function": worker(LISTEN, HEARD, "spinning = rclpy.spin\nspinning(Worker())"),
    "an attribute that is the function": worker(
        LISTEN + "self.spinner = rclpy.spin\n",
        HEARD + "\n\ndef go(self):\n    self.spinner(self)",
        "Worker().go()",
    ),
    "filters of messages": worker(
        "self.sub = message_filters.Subscriber(self, String, 'orders')\n"
        "self.sub.registerCallback(self.heard)\n",
        HEARD,
        f"{MADE}node.trigger_configure()",
    ),
    "filters of messages without a callback": worker(
        "self.sub = message_filters.Subscriber(self, String, 'orders')\n",
        HEARD,
        "node = Worker()",
    ),
    "asks whether another node is there": worker(
        LISTEN,
        HEARD,
        f"other = rclpy.create_node('other')\n{MADE}rclpy.spin(other)\n"
        "if node is not None:\n    node.destroy_node()",
    ),
    "compares another node": worker(
        LISTEN,
        HEARD,
        "other = rclpy.create_node('other')\nnode = Worker()\nrclpy.spin(other)\n"
        "if node == other:\n    node.destroy_node()",
    ),
    "spins both": worker(
        LISTEN,
        HEARD,
        "other = rclpy.create_node('other')\nnode = Worker()\nspin_all([node, other])",
    ),
    "rospy, ends": script(
        """
        def heard(msg):
            pass

        def main():
            rospy.init_node('worker')  # wrong
            rospy.Subscriber('orders', String, heard)

        if __name__ == '__main__':
            main()
        """
    ),
    "rospy, spins": script(
        """
        rospy.init_node('worker')
        rospy.Subscriber('orders', String, print)
        rospy.spin()
        """
    ),
    "rospy, says it in a comment": script(
        """
        rospy.init_node('worker')  # wrong
        rospy.Subscriber('orders', String, print)
        # rospy.spin()
        """
    ),
    "rospy, spins in a method of that name": script(
        """
        class Worker:
            def __init__(self):
                rospy.Subscriber('orders', String, print)

            def spin(self):
                rospy.spin()

        rospy.init_node('worker')
        Worker().spin()
        """
    ),
    "rospy, goes on": script(
        """
        rospy.init_node('worker')
        rospy.Subscriber('orders', String, print)
        while not rospy.is_shutdown():
            print('well')
        """
    ),
    "rospy, a class for others": script(
        """
        class Arm(object):
            def __init__(self):
                super(Arm, self).__init__()
                rospy.init_node('arm')
                rospy.Subscriber('orders', String, self.heard)

            def heard(self, msg):
                pass

        class Helper(object):
            def __init__(self):
                super(Helper, self).__init__()

        HELPER = Helper()
        """
    ),
    "rospy, a class that is tried out": script(
        """
        class Arm:
            def __init__(self):
                rospy.init_node('arm')
                rospy.Subscriber('orders', String, self.heard)

            def heard(self, msg):
                pass

            def move(self, joint):
                pass

        if __name__ == '__main__':
            Arm()
        """
    ),
    "rospy, a class of its own": script(
        """
        class Arm(object):
            def __init__(self):
                rospy.init_node('arm')  # wrong
                rospy.Subscriber('orders', String, self.heard)

            def heard(self, msg):
                pass

        if __name__ == '__main__':
            Arm()
        """
    ),
    "rospy, a method that spins": script(
        """
        class Arm(object):
            def __init__(self):
                rospy.Subscriber('orders', String, self.heard)

            def heard(self, msg):
                pass

            def spin(self):
                rospy.spin()

        rospy.init_node('arm')
        Arm().spin()
        """
    ),
    "rospy, a method that only says so": script(
        """
        class Runner(object):
            def __init__(self):
                rospy.Subscriber('orders', String, self.heard)

            def heard(self, msg):
                pass

            def spin(self):
                print('spinning')

        rospy.init_node('arm')  # wrong
        runner = Runner()
        runner.spin()
        """
    ),
    "rospy, another loop": script(
        """
        rospy.init_node('worker')
        rospy.Subscriber('orders', String, print)
        window.mainloop()
        """
    ),
}


@pytest.mark.parametrize("text", CASES.values(), ids=CASES)
def test_a_program_that_never_calls_its_callbacks_is_told(text: str) -> None:
    assert told(text, "RC405") == marked(text)


@pytest.mark.parametrize("main", GIVEN.values(), ids=GIVEN)
def test_a_node_that_another_file_gets_may_be_spun_there(main: str) -> None:
    text = worker(LISTEN, HEARD, f"from robots import run\n{main}")
    assert told(text, "RC405") == []
    source = read_python(Path("worker.py"), one(text.encode())).source
    assert source is not None
    assert not code_facts(source).is_closed


def test_a_base_that_is_not_read_may_spin() -> None:
    text = worker(LISTEN, HEARD, "node = Worker()").replace("(Node)", "(Node, Base)")
    assert told(f"from robots import Base\n{text}", "RC405") == []


def test_a_node_that_a_function_returns_may_be_spun_by_its_caller() -> None:
    assert told(worker(LISTEN, HEARD, "return Worker()"), "RC405") == []


def test_a_thread_that_spins_a_node_makes_no_endpoint() -> None:
    main = "robot = Worker()\nthreading.Thread(target=rclpy.spin, args=(robot,)).start()"
    source = read_python(Path("worker.py"), one(worker(LISTEN, HEARD, main).encode())).source
    assert source is not None
    assert code_facts(source).is_closed
