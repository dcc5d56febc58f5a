"""Functions and names as the file writes its own."""

import pytest
from edits import AT, SUB, edit, edited, provide, publish, request, subscribe

from plastron_tui.model.source import Remove

MANNERS = {
    "types": (
        "    def on_a(self, msg: String) -> None:\n        pass\n",
        "    def on_b(self, msg: String) -> None:\n",
    ),
    "types of callbacks, and of nothing else": (
        "    def on_a(self, msg: String):\n        pass\n\n    def more(self, x):\n        pass\n\n"
        "    def most(self, x):\n        pass\n",
        "    def on_b(self, msg: String):\n",
    ),
    "a parameter that is not used": (
        "    def on_a(self, _):\n        pass\n",
        "    def on_b(self, message):\n",
    ),
    "a parameter with a default": (
        "    def on_a(self, data=None):\n        pass\n",
        "    def on_b(self, message):\n",
    ),
    "docstrings": (
        '    def on_a(self, message):\n        """Hear a."""\n\n'
        '    def more(self):\n        """Do more."""\n',
        '    def on_b(self, message):\n        """Log what comes over b."""\n',
    ),
    "docstrings in other quotes": (
        "    def on_a(self, message):\n        '''Hear a.'''\n\n"
        "    def more(self):\n        '''Do more.'''\n",
        "    def on_b(self, message):\n        '''Log what comes over b.'''\n",
    ),
    "what none of them takes": (
        "    def on_a(self) -> None:\n        pass\n",
        "    def on_b(self, message: String) -> None:\n",
    ),
    "a ruler above each": (
        "    # ---------\n    def on_a(self, message):\n        pass\n\n"
        "    # ---------\n    def more(self):\n        pass\n",
        "    # ---------\n    def on_b(self, message):\n",
    ),
    "a ruler above one": (
        "    # ---------\n    def on_a(self, message):\n        pass\n\n"
        "    def more(self):\n        pass\n",
        "        pass\n\n    def on_b(self, message):\n",
    ),
    "a comment above each": (
        "    # it\n    def on_a(self, message):\n        pass\n\n"
        "    # it\n    def more(self):\n        pass\n",
        "        pass\n\n    def on_b(self, message):\n",
    ),
    "nothing said": (
        "    def on_a(self, data):\n        pass\n\n    def more(self):\n        pass\n",
        "    def on_b(self, data):\n        self.get_logger()",
    ),
}


@pytest.mark.parametrize("case", MANNERS)
def test_a_callback_is_written_as_the_others(case):
    methods, expected = MANNERS[case]
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n"
        f"        self.create_subscription(String, 'a', self.on_a, 10)\n\n{methods}",
        subscribe("b"),
    )
    assert expected in text


def test_private_names_and_kept_handles():
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n        self._a = 0\n"
        "        self._beat = self.create_timer(1.0, self._tick)\n\n"
        "    def _tick(self):\n        pass\n\n    def _tock(self):\n        pass\n",
        provide("b"),
    )
    assert "        self._b_service = self.create_service(Trigger, 'b', self._handle_b)\n" in text
    assert "    def _handle_b(self, request, response):\n" in text


@pytest.mark.parametrize(
    ("above", "is_apart"),
    [
        ("# Set up what is sent\n        self.pub = self.create_publisher(String, 'a', 10)", True),
        ("if self.x:\n            self.pub = self.create_publisher(String, 'a', 10)", True),
        ("self.pub = self.create_publisher(\n            String, 'a', 1\n            )", False),
        ("self.pub = self.create_publisher(String, 'a', 10)", False),
        ("self.sub = self.create_subscription(String, 'a', self.on_a, 10)", False),
        ("self.pub = self.create_publisher(\n            String, 'a', 10)", False),
        ("self.pub = self.create_publisher(\n            String, 'a', 10\n        )", False),
        ("if g():\n            self.pub = self.create_publisher(String, 'a', 10)", True),
    ],
)
def test_a_section_of_its_own(above, is_apart):
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        f"    def __init__(self):\n        super().__init__('a')\n        {above}\n\n"
        "    def on_a(self, msg):\n        pass\n",
        subscribe("b", callback="on_a"),
    )
    gap = "\n\n        self" if is_apart else "\n        self"
    assert f"{gap}.b_sub = self.create_subscription(" in text
    assert is_apart or "\n\n        self.b_sub" not in text


PER_OBJECT = (
    "import rospy\nfrom std_msgs.msg import String\n\n\nclass Joint:\n"
    "    def __init__(self, number, t='joint'):\n        self.name, self.at = number, t\n"
    "        kind = 'k' + str(number)\n        kind = kind + kind\n        fixed = 'f'\n"
    "        self.pub = rospy.Publisher({}, String, queue_size=1)\n"
    "\n\nrospy.init_node('n')\nJoint(make())\nJoint(make())\nrospy.spin()\n"
)


@pytest.mark.parametrize(
    ("name", "is_told"),
    [
        ("'joint' + str(number)", True),
        ("f'joint{number}'", True),
        ("self.name", True),
        ("'j' + self.name", True),
        ("'j'", False),
        ("t", False),
        ("self.at", False),
        ("find(number)", True),
        ("kind", True),
        ("fixed", False),
    ],
)
def test_it_is_told_that_each_object_creates_an_endpoint(name, is_told):
    found = edit(PER_OBJECT.format(name), provide("stop")).diagnostics
    assert [str(each.code) for each in found] == ["shared-name"] * is_told


@pytest.mark.parametrize("start", ["rospy.init_node('j')", "super().__init__('j')"])
def test_a_node_is_made_once(start):
    text = PER_OBJECT.format("'j' + number").replace("self.name", f"{start}\n        self.name")
    text = text.replace("rospy.init_node('n')\n", "")
    if "super" in start:
        text = text.replace("class Joint", "from rclpy.node import Node\n\n\nclass Joint(Node)")
        text = text.replace("rospy.Publisher(", "self.create_publisher(String, ")
        text = text.replace(", String, queue_size=1", ", 1").replace("import rospy\n", "")
    assert not [
        each for each in edit(text, provide("stop")).diagnostics if each.code == "shared-name"
    ]


@pytest.mark.parametrize(
    ("base", "given", "made", "name", "is_told"),
    [
        ("object", "robot_name", "", "stop", True),
        ("object", "arm_namespace", "Joint(1)\nJoint(2)\n", "stop", True),
        ("object", "name", "Joint(1)\n", "stop", False),
        ("object", "name='a'", "", "stop", False),
        ("object", "file_name", "", "stop", False),
        ("Node", "namespace", "", "/stop", True),
        ("Node", "namespace", "", "stop", False),
        ("Node", "name", "", "/stop", False),
    ],
)
def test_a_constructor_tells_that_there_are_several_objects(base, given, made, name, is_told):
    text = (
        "import rospy\nfrom std_msgs.msg import String\n\n\nclass Joint(object):\n"
        f"    def __init__(self, {given}):\n        self.n = 1\n"
        f"        self.pub = rospy.Publisher('at', String, queue_size=1)\n\n\n{made}"
    )
    if base == "Node":
        text = text.replace("import rospy", "import rclpy\nfrom rclpy.node import Node")
        text = text.replace("object", "Node").replace("self.n = 1", "super().__init__('n')")
        text = text.replace(
            "rospy.Publisher('at', String, queue_size=1)", "self.create_publisher(String, 'at', 1)"
        )
    found = edit(text, provide(name)).diagnostics
    assert [str(each.code) for each in found] == ["shared-name"] * is_told


def test_a_timer_is_in_the_group_of_the_others():
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n        self.group = make()\n"
        "        self.timer = self.create_timer(1.0, self.tick, callback_group=self.group)\n\n"
        "    def tick(self):\n        wait()\n        return\n        wait()\n",
        publish("b", rate=4.0, data="x"),
    )
    assert "self.create_timer(0.25, self.publish_b, callback_group=self.group)\n" in text


IN_CLASS = (
    "from rclpy.node import Node\nimport logs\n\nLOG = logs.make()\n\n\nclass A(Node):\n"
    "    def __init__(self):\n        super().__init__('a')\n        self.logger = f()\n"
    "        {}\n"
)
IN_ROSPY = (
    "import rospy\n\n\nclass A(Base):\n    def __init__(self):\n        rospy.init_node('a')\n"
    "        {}\n        rospy.spin()\n"
)
IN_MAIN = (
    "import rclpy\n\n\ndef main():\n    node = rclpy.create_node('a')\n"
    "    {}\n    rclpy.spin(node)\n"
)
LOGS = {
    "an attribute": (IN_CLASS, "self.logger.warn('x')", "self.logger.info(f'b: {message}')"),
    "of the module": (IN_CLASS, "LOG.info('x %s' % y)", "LOG.info('b: %s' % message)"),
    "most of them": (
        IN_CLASS,
        "LOG.info('x')\n        self.get_logger().info('{}'.format(y))\n"
        "        self.get_logger().info('x')",
        "self.get_logger().info('b: {}'.format(message))",
    ),
    "no logger": (IN_CLASS, "self.robot.info(f'{x}')", "self.get_logger().info(f'b: {message}')"),
    "of the object, of one text": (
        IN_ROSPY,
        "self.loginfo('x')",
        "self.loginfo('b: %s' % message)",
    ),
    "of the object, of two": (
        IN_ROSPY,
        "self.loginfo('x: %s', y)",
        "self.loginfo('b: %s', message)",
    ),
    "of the object": (IN_ROSPY, "self.loginfo('x: %s' % y)", "self.loginfo('b: %s' % message)"),
    "of the object, of a level": (
        IN_CLASS,
        "self.info_msg(f'{x}')",
        "self.info_msg(f'b: {message}')",
    ),
    "of rospy": (IN_ROSPY, "rospy.logwarn(f'x {y}')", "rospy.loginfo(f'b: {message}')"),
    "where the node is not seen": (
        IN_MAIN,
        "node.get_logger().info('x')",
        "get_logger('a').info(f'b: {message}')",
    ),
    "where all is printed": (IN_MAIN, "print('x')", "print(f'b: {message}')"),
}


@pytest.mark.parametrize("case", LOGS)
def test_a_function_logs_as_the_others(case):
    template, old, expected = LOGS[case]
    text = template.replace("{}", old)
    after = edited(text, subscribe("b"))
    assert f"{expected}\n" in after
    assert edited(after, Remove(SUB, "b", AT)) == text


@pytest.mark.parametrize(
    ("old", "change", "new"),
    [
        ("('a', String, hear, queue_size = 1)", subscribe("b", callback="hear"), "queue_size = 1)"),
        ("('a', String, hear, queue_size=1)", subscribe("b", callback="hear"), "queue_size=1)"),
        (
            "(name='a', data_class=String, callback=hear)",
            publish("b"),
            "(name='b', data_class=String, queue_size=10)",
        ),
    ],
)
def test_keywords_are_written_as_the_others(old, change, new):
    text = edited(
        "import rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('n')\n"
        f"rospy.Subscriber{old}\nrospy.spin()\n",
        change,
    )
    assert text.count(new) == text.count("queue_size") >= 1


def test_a_profile_of_both_ways_is_taken_over():
    text = edited(
        "from rclpy.node import Node\nfrom std_msgs.msg import String\n\n\nclass A(Node):\n"
        "    def __init__(self):\n        super().__init__('a')\n"
        "        self.a = self.create_publisher(String, 'a', self.qos)\n"
        "        self.b = self.create_subscription(String, 'b', self.on_b, self.qos)\n",
        publish("c"),
    )
    assert "self.create_publisher(String, 'c', self.qos)\n" in text


def test_a_comment_above_the_imports_begins_no_section():
    text = "#!/usr/bin/env python3\nimport rospy\nrospy.init_node('n')\nrospy.spin()\n"
    after = edited(text, subscribe("b"))
    assert "node('n')\nrospy.Subscriber('b', String, on_b)\n" in after


@pytest.mark.parametrize("blank", ["\n", "\n\n"])
def test_a_function_stands_as_far_from_the_others_as_the_first_from_the_rest(blank):
    text = (
        "import rospy\nfrom std_msgs.msg import String\ndef on_a(data):\n    pass\n"
        f"{blank}rospy.init_node('n')\nrospy.Subscriber('a', String, on_a)\nrospy.spin()\n"
    )
    assert f"    pass\n{blank}def on_b(data):\n" in edited(text, subscribe("b"))


@pytest.mark.parametrize("type_", ["std_msgs/Bool", "std_msgs/String"])
def test_what_a_star_import_brings_in_is_used(type_):
    text = "import rospy\nfrom std_msgs.msg import *\nrospy.init_node('n')\nrospy.spin()\n"
    after = edited(text, publish("b", type_))
    assert f"rospy.Publisher('b', {type_.rpartition('/')[2]}, queue_size=10)\n" in after
    assert after.count("import") == 2


@pytest.mark.parametrize(
    ("callbacks", "taken"),
    [(["twist"], "message"), (["msg"], "msg"), (["told", "told"], "told"), (["twist", "m"], "m")],
)
def test_a_parameter_is_not_named_after_another_type(callbacks, taken):
    text = "import rospy\nfrom std_msgs.msg import String\n\n"
    for number, name in enumerate(callbacks):
        text += f"\ndef on_a{number}({name}):\n    pass\n\n"
    text += "\nrospy.init_node('n')\n"
    for number in range(len(callbacks)):
        text += f"rospy.Subscriber('a{number}', String, on_a{number})\n"
    assert f"def on_b({taken}):\n" in edited(f"{text}rospy.spin()\n", subscribe("b"))


def test_a_name_of_the_module_is_not_private():
    text = (
        "import rospy\n\n\nclass A:\n    def __init__(self):\n        self._a = 1\n"
        "        self._b = 2\n\n\nrospy.init_node('n')\nrospy.spin()\n"
    )
    assert "\nc_pub = rospy.Publisher('c', " in edited(text, publish("c"))


# How a call is written beside one of its kind.
CALLS = {
    "rospy.Subscriber('a',String,f)": "rospy.Subscriber('b',String,on_b)",
    "rospy.Subscriber('a,b',String,f)": "rospy.Subscriber('b',String,on_b)",
    "rospy.Subscriber('a', String, f)": "rospy.Subscriber('b', String, on_b)",
    "rospy.Subscriber('a',String, f)": "rospy.Subscriber('b', String, on_b)",
}


@pytest.mark.parametrize("call", CALLS)
def test_commas_are_as_in_the_call_beside(call):
    head = "import rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('n')\n"
    assert f"\n{CALLS[call]}\n" in edited(f"{head}{call}\nrospy.spin()\n", subscribe("b"))


def test_a_name_in_a_log_is_as_the_file_writes_it():
    text = "import rospy\n\nrospy.init_node('n')\nrospy.spin()\n"
    assert "rospy.loginfo('~b: %s'" in edited(text, subscribe("~/b"))


def test_a_local_timer_is_private_to_nothing():
    text = edited(
        "import rclpy\n\n\ndef main():\n    node = rclpy.create_node('b')\n"
        "    _beat_timer = node.create_timer(1.0, f)\n    rclpy.spin(node)\n",
        request("b", "std_srvs/Trigger"),
    )
    assert "    b_timer = node.create_timer(" in text
