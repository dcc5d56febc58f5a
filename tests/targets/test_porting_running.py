"""What runs a node, and what ends its parts, brought from one ROS to the other."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.python import read_python
from plastron_tui.targets.python.porting.port import port_python

MARK = "# port by hand: "
OTHER = {"rospy": "rclpy", "rclpy": "rospy"}
CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("kilted")}
CLASS = (
    "import rclpy\nfrom rclpy.node import Node\n\n\nclass A(Node):\n"
    "    def __init__(self):\n        super().__init__('a')\n\n\n"
)


def ported(text: str, library: str, other: str) -> str:
    """Bring a file to the other library; the result is Python."""
    read = read_python(Path("node.py"), one(text.encode()), library).source
    assert read is not None
    result = port_python(read, CATALOGS[other], other)
    assert result.files is not None, result.diagnostics
    ast.parse(result.files.main)
    return result.files.main.decode()


SPINS = [
    ("rclpy.spin(A())", "A()\nrospy.spin()"),
    ("node = A()\nrclpy.spin(node)", "node = A()\nrospy.spin()"),
    ("rclpy.spin(node=A())", "A()\nrospy.spin()"),
    ("rclpy.spin(a := A())", "(a := A())\nrospy.spin()"),
    ("rclpy.spin(\n    A(),\n)", "A()\nrospy.spin()"),
    ("if True:\n    rclpy.spin(A())", "if True:\n    A()\n    rospy.spin()"),
    ("if True: rclpy.spin(A())", "if True: A(); rospy.spin()"),
    ("x = rclpy.spin(A())", "x = (A(), rospy.spin())[1]"),
    ("rclpy.spin(rclpy.create_node('b'))", "rospy.init_node('b')\nrospy.spin()"),
]


@pytest.mark.parametrize(("before", "after"), SPINS)
def test_spinning_keeps_what_makes_the_node(before: str, after: str) -> None:
    text = ported(f"{CLASS}rclpy.init()\n{before}\n", "rclpy", "rospy").replace(
        f"{MARK}a second node\n", ""
    )
    assert text.endswith(f"\n{after}\n")


def test_a_name_is_free_however_many_are_taken() -> None:
    taken = "node = ros_node = _ros_node = _ros_node_2 = 1\n"
    text = ported(f"import rospy\n{taken}rospy.init_node('n')\n", "rospy", "rclpy")
    assert "\n_ros_node_3 = rclpy.create_node(" in text


def test_the_helpers_stand_before_a_line_that_follows_the_imports_at_once() -> None:
    text = ported(
        "import rospy\nfrom std_msgs.msg import String\n"
        "rospy.Subscriber('s', String, print)\nrospy.init_node('n')\n",
        "rospy",
        "rclpy",
    )
    assert text.index("def spin_in_thread():") < text.index("\nspin_in_thread()")
    assert text.endswith(
        "\n\n\nrclpy.init()\nnode = rclpy.create_node('n')\nspin_in_thread()\n"
        "node.create_subscription(String, 's', print, 10)\n"
    )


HEAD_1 = (
    "import rospy\nfrom std_msgs.msg import String\n\n\ndef tick(event):\n    {inside}\n\n\n"
    "rospy.init_node('n')\ntimer = rospy.Timer(rospy.Duration(1), tick)\n"
    "sub = rospy.Subscriber('s', String, print)\n"
)
HEAD_2 = (
    "import rclpy\nfrom std_msgs.msg import String\n\n\ndef tick():\n    {inside}\n\n\n"
    "rclpy.init()\nnode = rclpy.create_node('n')\nbeat = node.create_timer(1, tick)\n"
    "sub = node.create_subscription(String, 's', print, 10)\n"
)
ENDINGS = [
    ("rospy", "timer.shutdown()", "\ntimer.cancel()\n"),
    ("rospy", "sub.shutdown()", f"\n{MARK}.shutdown\nsub.shutdown()\n"),
    ("rospy", "pool.shutdown()", "\npool.shutdown()\n"),
    ("rclpy", "beat.cancel()", "\nbeat.shutdown()\n"),
    ("rclpy", "beat.reset()", f"\n{MARK}.reset\nbeat.reset()\n"),
    ("rclpy", "sub.reset()", "\nsub.reset()\n"),
    ("rclpy", "game.reset()", "\ngame.reset()\n"),
    ("rclpy", "sub.destroy()", f"\n{MARK}.destroy\nsub.destroy()\n"),
]


@pytest.mark.parametrize(("library", "before", "after"), ENDINGS)
def test_ending_an_endpoint(library: str, before: str, after: str) -> None:
    head, other = {"rospy": (HEAD_1, "rclpy"), "rclpy": (HEAD_2, "rospy")}[library]
    text = ported(head.format(inside="pass") + before + "\n", library, other)
    assert after in text
    assert (MARK in after) == (f"{MARK}." in text)


@pytest.mark.parametrize(
    ("library", "line", "after"),
    [
        ("rospy", "timer.shutdown()", "timer.cancel()"),
        ("rclpy", "beat.cancel()", "beat.shutdown()"),
        ("rospy", "a_timer.shutdown()", f"{MARK}.shutdown\n    a_timer.shutdown()"),
        ("rclpy", "a_timer.cancel()", f"{MARK}.cancel\n    a_timer.cancel()"),
    ],
)
def test_a_callback_ends_a_timer_of_the_file(library: str, line: str, after: str) -> None:
    head, other = {"rospy": (HEAD_1, "rclpy"), "rclpy": (HEAD_2, "rospy")}[library]
    text = ported(head.format(inside=line), library, other)
    assert f":\n    {after}\n" in text


SHUTDOWN = "rospy.signal_shutdown('the node is done')"
SHUTDOWNS = [
    ("rclpy.spin(node)\nrclpy.shutdown()", "rospy.spin()"),
    ("rclpy.spin(node)\nif rclpy.ok():\n    rclpy.shutdown()", "rospy.spin()"),
    ("rclpy.spin(node)\nif here:\n    rclpy.shutdown()", "rospy.spin()\nif here:\n    pass"),
    ("if here:\n    rclpy.spin(node)\nrclpy.shutdown()", f"if here:\n    rospy.spin()\n{SHUTDOWN}"),
    (
        "while rclpy.ok():\n    work()\nrclpy.shutdown()",
        "while not rospy.is_shutdown():\n    work()",
    ),
    (
        "while rclpy.ok():\n    break\nrclpy.shutdown()",
        f"while not rospy.is_shutdown():\n    break\n{SHUTDOWN}",
    ),
    ("node.work()\nrclpy.shutdown()", f"node.work()\n{SHUTDOWN}"),
    (
        "try:\n    rclpy.spin(node)\nexcept KeyboardInterrupt:\n    pass\n"
        "finally:\n    node.destroy_node()\n    rclpy.shutdown()",
        "try:\n    rospy.spin()\nexcept KeyboardInterrupt:\n    pass",
    ),
    (
        "t = Thread(f)\ntry:\n    rclpy.spin(node)\nexcept E:\n    pass\nrclpy.shutdown()",
        f"t = Thread(f)\ntry:\n    rospy.spin()\nexcept E:\n    pass\n{SHUTDOWN}",
    ),
]


@pytest.mark.parametrize(("before", "after"), SHUTDOWNS)
def test_a_shutdown_behind_spin_goes(before: str, after: str) -> None:
    text = ported(f"{CLASS}rclpy.init()\nnode = A()\n{before}\n", "rclpy", "rospy")
    assert text.endswith(f"\nnode = A()\n{after}\n")


CONTEXTS = [
    ("with rclpy.init(args=None):\n    rclpy.spin(A())", "A()\nrospy.spin()"),
    ("with rclpy.init(): rclpy.spin(A())", "A(); rospy.spin()"),
    (
        "try:\n    with rclpy.init():\n        # first\n        node = A()\n\n"
        '        print("""a\n  b""")\n        rclpy.spin(node)\n'
        "except ExternalShutdownException:\n    pass",
        'try:\n    # first\n    node = A()\n\n    print("""a\n  b""")\n'
        "    rospy.spin()\nexcept rospy.ROSInterruptException:\n    pass",
    ),
    (
        "with rclpy.init(), open('x') as file:\n    rclpy.spin(A())",
        "with open('x') as file:\n    A()\n    rospy.spin()",
    ),
    (
        "with rclpy.init():\n    node = A()\n    while rclpy.ok():\n        rclpy.spin_once(node)",
        "node = A()\nwhile not rospy.is_shutdown():\n    rospy.sleep(0.1)",
    ),
    (
        "node = A()\nexecutor = MultiThreadedExecutor()\nexecutor.add_node(node)\n"
        "try:\n    executor.spin()\nfinally:\n    executor.shutdown()\n"
        "    rclpy.try_shutdown()",
        "node = A()\nrospy.spin()",
    ),
]


@pytest.mark.parametrize(("before", "after"), CONTEXTS)
def test_what_rclpy_runs_a_node_with(before: str, after: str) -> None:
    head = "from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor\n" + CLASS
    text = ported(f"{head}{before}\n", "rclpy", "rospy")
    assert text.endswith(f"\n{after}\n")
    assert MARK not in text


ONCE = f"{MARK}spin_once ends at the first message\n"
SPINS_ONCE = [
    ("while x:\n    rclpy.spin_once(n, timeout_sec=1)", "while x:\n    rospy.sleep(0.1)"),
    (
        "while x:\n    rclpy.spin_once(n, timeout_sec=1)\n    y()",
        f"while x:\n    {ONCE}    rospy.sleep(1)\n    y()",
    ),
    (
        "while x:\n    rclpy.spin_once(n, timeout_sec=0)\n    y()",
        "while x:\n    rospy.sleep(0)\n    y()",
    ),
    ("rclpy.spin_once(n, timeout_sec=1)", "rospy.sleep(1)"),
]


@pytest.mark.parametrize(("before", "after"), SPINS_ONCE)
def test_one_spin_ends_at_the_first_message(before: str, after: str) -> None:
    text = ported(f"{CLASS}rclpy.init()\nn = A()\n{before}\n", "rclpy", "rospy")
    assert text.endswith(f"\nn = A()\n{after}\n")


def test_a_node_that_ends_more_than_itself_is_ended() -> None:
    own = "\n    def destroy_node(self):\n        print('ended')\n"
    own += "        super().destroy_node()\n\n\n"
    text = ported(
        f"{CLASS[:-2]}{own}rclpy.init()\nnode = A()\nnode.destroy_node()\n", "rclpy", "rospy"
    )
    assert "        print('ended')\n\n\n" in text
    assert text.endswith("\nnode = A()\nnode.destroy_node()\n")


BUSY = [
    ("{sub}\nrospy.spin()", False),
    ("time.sleep(1)\n{sub}\nrospy.spin()", False),
    ("{sub}\nrospy.spin()\ntime.sleep(1)", False),
    ("{sub}\ntime.sleep(1)\nrospy.spin()", True),
    ("{sub}\nwhile f(): pass\nrospy.spin()", True),
    ("{sub}\nmatplotlib.pyplot.show()\nrospy.spin()", True),
    ("{sub}\nwindow.mainloop()\nrospy.spin()", True),
    ("def f(): time.sleep(1)\n\n\n{sub}\nf()\nrospy.spin()", True),
    ("def f(): time.sleep(1)\n\n\n{sub}\nuse(f)\nrospy.spin()", False),
    (
        "class A:\n    def __init__(self):\n        {sub}\n        rospy.sleep(1)\n\n\n"
        "A()\nrospy.spin()",
        True,
    ),
]


@pytest.mark.parametrize(("lines", "is_busy"), BUSY)
def test_a_thread_handles_what_comes_while_the_file_is_busy(lines: str, is_busy: bool) -> None:
    made = lines.format(sub="rospy.Subscriber('s', String, print)")
    text = ported(
        "import matplotlib.pyplot\nimport time\nimport rospy\nfrom std_msgs.msg import String\n\n"
        f"rospy.init_node('n')\n{made}\n",
        "rospy",
        "rclpy",
    )
    assert ("\nspin_in_thread()\n" in text) == is_busy
    assert ("\nwait()\n" in text) == is_busy


LOOP = f"{MARK}waits for another callback\n"
LOOPS = [
    ("while not self.done: pass", True),
    ("while True:\n            if self.done: break", True),
    ("while self.count: pass", False),
    ("if self.done: pass", False),
]


@pytest.mark.parametrize(("loop", "is_marked"), LOOPS)
def test_a_callback_that_waits_for_another_one_is_marked(loop: str, is_marked: bool) -> None:
    text = ported(
        "import rospy\nfrom std_msgs.msg import String\n\n\nclass A:\n"
        "    def __init__(self):\n        rospy.Subscriber('a', String, self.go)\n"
        "        rospy.Subscriber('b', String, self.end)\n\n"
        f"    def go(self, m):\n        self.count = 1\n        {loop}\n\n"
        "    def end(self, m):\n        self.done = True\n\n\n"
        "rospy.init_node('n')\nA()\nrospy.spin()\n",
        "rospy",
        "rclpy",
    )
    mark = f"        {LOOP}" if is_marked else ""
    assert f"{mark}        {loop}\n" in text
    assert (LOOP in text) == is_marked


ASKS = [
    ("x = input('a')", ["SIGINT", "SIGTERM"], False),
    ("rate = rospy.Rate(1)\nrate.sleep()\nx = input('a')", ["SIGINT", "SIGTERM"], True),
    ("rate = rospy.Rate(1)\nrate.sleep()", ["SIGTERM"], True),
    ("self.rate = rospy.Rate(n())", ["SIGTERM"], True),
    ("rate = rospy.Rate(1)", [], False),
    ("self.rate = rospy.Rate(1)", [], False),
    ("rate = rospy.Rate(1)\nrate = rospy.Rate(2)", [], False),
    ("rate = rospy.Rate(1)\nuse(rate)", ["SIGTERM"], True),
    ("x = 1", [], False),
]


@pytest.mark.parametrize(("lines", "signals", "in_thread"), ASKS)
def test_control_c_does_not_end_what_asks_the_user(
    lines: str, signals: list[str], in_thread: bool
) -> None:
    """rospy's handler ends ROS, and raises nothing."""
    text = ported(f"import rospy\n\nrospy.init_node('n')\n{lines}\n", "rospy", "rclpy")
    margin = "    " if in_thread else ""
    handled = "lambda number, frame: rclpy.try_shutdown())"
    assert [line for line in text.split("\n") if "signal.signal" in line] == [
        f"{margin}signal.signal(signal.{each}, {handled}" for each in signals
    ]
    assert ("SignalHandlerOptions.NO" in text) == ("SIGINT" in signals)
    assert ("create_rate" in text) == ("Rate" in lines and in_thread)


def test_the_comments_and_blank_lines_of_imports_and_of_the_node_stay() -> None:
    text = ported(
        "# of numbers\nimport numpy\n\n# of ROS\nimport rospy\n\nimport mine\n\n"
        "# the node is made\nrospy.init_node('n')  # here\n",
        "rospy",
        "rclpy",
    )
    assert text == (
        "# of numbers\nimport numpy\n\n# of ROS\nimport rclpy\n\nimport mine\n\n"
        "# the node is made\nrclpy.init()\nnode = rclpy.create_node('n')  # here\n"
    )


USED = [
    ("rospy", "import rospy", "rospy.AnyMsg"),
    ("rospy", "import rospy", "def f():\n    return rospy.get_param('/x')"),
    ("rospy", "import rospy\nfrom rospy import AnyMsg", "AnyMsg"),
    ("rospy", "import rospy, sys", "rospy.AnyMsg"),
    ("rclpy", "import rclpy\nfrom rclpy.clock import Clock", "Clock()"),
]


@pytest.mark.parametrize(("library", "imports", "line"), USED)
def test_an_import_stays_while_a_marked_line_uses_it(library: str, imports: str, line: str) -> None:
    made = {"rospy": "rospy.init_node('n')\n", "rclpy": "rclpy.init()\nrclpy.create_node('n')\n"}
    text = ported(f"{imports}\n{made[library]}{line}\n", library, OTHER[library])
    assert MARK in text
    assert f"{imports.splitlines()[-1]}\n" in text
    text = ported(f"{imports}\n{made[library]}", library, OTHER[library])
    assert imports.splitlines()[-1] not in text


def test_an_import_goes_where_the_marked_line_is_rewritten() -> None:
    text = ported(
        "import rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('n')\n"
        "rospy.Subscriber('t', String, print, headers=x)\n",
        "rospy",
        "rclpy",
    )
    assert f"{MARK}headers\n" in text
    assert "import rospy" not in text


def test_an_import_of_a_function_does_not_serve_the_helpers() -> None:
    text = ported(
        "import rospy\n\n\ndef f():\n    import traceback\n\n\n"
        "rospy.init_node('n')\nrospy.spin()\n",
        "rospy",
        "rclpy",
    )
    assert "\nimport traceback\n" in f"\n{text}"


def test_an_executor_that_another_function_uses_stays() -> None:
    text = ported(
        f"from rclpy.executors import SingleThreadedExecutor\n{CLASS}"
        "def turn():\n    executor.spin_once()\n\n\n"
        "node = A()\nexecutor = SingleThreadedExecutor()\nexecutor.add_node(node)\n",
        "rclpy",
        "rospy",
    )
    assert text.endswith(
        f"\n{MARK}rclpy.executors.SingleThreadedExecutor\n"
        "executor = SingleThreadedExecutor()\nexecutor.add_node(node)\n"
    )


# Whether what makes the node is held in a variable of the ported function.
HELD = {
    "node = A()\n    rclpy.spin(node)": "A()\n    rospy.spin()",
    "node = A()\n    use(node)\n    rclpy.spin(node)": (
        "node = A()\n    use(node)\n    rospy.spin()"
    ),
    "global node\n    node = A()\n    rclpy.spin(node)": (
        "global node\n    node = A()\n    rospy.spin()"
    ),
    "self.node = A()\n    rclpy.spin(self.node)": "self.node = A()\n    rospy.spin()",
    "other = B()\n    rclpy.spin(A())": "other = B()\n    A()\n    rospy.spin()",
}


@pytest.mark.parametrize("before", HELD)
def test_a_node_that_is_only_spun_needs_no_variable(before: str) -> None:
    text = ported(f"{CLASS}def main(self):\n    rclpy.init()\n    {before}\n", "rclpy", "rospy")
    assert text.endswith(f"def main(self):\n    {HELD[before]}\n")


def test_a_line_stays_as_long_as_rclpy_allows() -> None:
    call = "        self.words = self.create_subscription(String, 'words', self.on_words, 10)"
    after = "        self.words = rospy.Subscriber('words', String, self.on_words, queue_size=10)"
    text = ported(f"{CLASS}{call}\n", "rclpy", "rospy")
    assert after in text.split("\n")
