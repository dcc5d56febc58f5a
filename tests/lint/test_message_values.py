"""Values that fields of messages do not hold, and messages that are constructed in vain."""

from __future__ import annotations

import pytest
from message_programs import diagnostics, fixed, marked, node, script, tick, told

WRONG = {
    "in rclpy": tick("""
        msg = String()
        msg.data = 42  # wrong
        msg.data = 1.5  # wrong
        msg.data = None  # wrong
        msg.data = ['a']  # wrong
        msg.data = {'a': 1}  # wrong
        msg.data = {each: 1 for each in 'ab'}  # wrong
        msg.data = {'a', 'b'}  # wrong
        msg.data = {each for each in 'ab'}  # wrong
        msg.data = dict(a=1)  # wrong
        msg.data = frozenset('ab')  # wrong
        msg.data = String  # wrong
        msg.data = True  # wrong
        msg.data = b'a'  # wrong
        msg.data = String()  # wrong
        msg.data = str(42)
        msg.data = f'{42}' + 'a' * 3
        msg.data = json.dumps({})
        number = Int32()
        number.data = '42'  # wrong
        number.data = 4.0  # wrong
        number.data = 4 / 2  # wrong
        number.data = math.sqrt(4)  # wrong
        number.data = int('4') + len('a') // 2
        number.data = True
        truth = Bool()
        truth.data = 1  # wrong
        truth.data = 'True'  # wrong
        truth.data = not truth.data
    """),
    "messages": node("""
        def on_odometry(self, msg):
            stamped = PoseStamped()
            stamped.pose = msg.pose  # wrong
            stamped.pose = msg.pose.pose
            stamped.header = msg.header
            stamped.header.frame_id = msg.header  # wrong
            stamped.pose.position = msg.pose.pose.orientation  # wrong
            stamped.header.stamp = self.get_clock().now()  # wrong
            stamped.header.stamp = self.get_clock().now().to_msg()
            stamped.header.stamp = time.time()  # wrong
            stamped.header.stamp = Time()
            self.twists.publish(stamped)  # wrong
            self.twists.publish(msg.twist.twist)
            self.twists.publish('stop')  # wrong
            self.twists.publish(Twist)  # wrong
            self.client.call_async(SetBool.Response())  # wrong
            self.client.call_async(True)  # wrong
            self.texts.publish(String(data=msg.child_frame_id))
            self.texts.publish(String(data=msg.pose.pose.position.x))  # wrong
    """),
    "messages of a package that is not known": tick("""
        wheels = self.create_publisher(Wheel, 'wheels', 10)
        wheels.publish(Twist())  # wrong
        wheels.publish(Wheel())
        self.twists.publish(Wheel())  # wrong
        Twist().linear = Wheel().hub
        Twist().linear = Wheel()  # wrong
        self.twists.publish(Rim())
    """).replace(
        "import rclpy\n",
        "import rclpy\nfrom acme_msgs.msg import Wheel\nfrom acme.msg import Rim\n",
        1,
    ),
    "answers of rospy": script("""
        def on_set(request):  # wrong
            x = request.data

        def on_reset(request):
            if request.data:
                return None
            return {'success': True}

        def on_start(request):
            if request.data:
                return True  # wrong
            return SetBoolResponse(True, '')

        rospy.Service('a', SetBool, on_set)
        rospy.Service('b', SetBool, on_reset)
        rospy.Service('c', SetBool, on_start)
    """),
    "lists": tick("""
        scan = LaserScan()
        scan.ranges = 1.0  # wrong
        scan.ranges = 'abc'  # wrong
        scan.ranges = ['a', 'b']  # wrong
        scan.ranges = {1.0, 2.0}
        scan.ranges = {1.0: 2.0}  # wrong
        scan.ranges = [1.0, 2.0]
        scan.ranges = [float(each) for each in '123']
        joints = JointState(name='a')  # wrong
        joints.name = ['a', 1]  # wrong
        joints.name = ['a', 'b']
        poses = PoseArray()
        poses.poses = Pose()  # wrong
        poses.poses = [None] * 3
        poses.poses.append(Point())  # wrong
        poses.poses.append(Pose())
        joints.name.append(3)
        joints.position.append('x')  # wrong
        joints.name[0] = None  # wrong
    """),
    "through names": tick("""
        speed = 'fast'
        msg = Twist()
        msg.linear.x = speed  # wrong
        self.frame = 3
        msg.linear.y = self.factor
        header = Header(frame_id=self.frame)  # wrong
        status = DiagnosticStatus(level=2)  # wrong
        status.level = DiagnosticStatus.OK
        for number in range(3):
            header.frame_id = number  # wrong
    """),
    "numbers that are too great": tick("""
        std_msgs.msg.UInt8(data=256)  # wrong
        std_msgs.msg.UInt8(data=255)
        std_msgs.msg.UInt32(data=-1)  # wrong
        Header(stamp=Time(sec=2147483648))  # wrong
        Float32(data=1e30)
        std_msgs.msg.UInt8MultiArray(data=[0, 255])
        std_msgs.msg.UInt8MultiArray(data=[256, 0])  # wrong
        std_msgs.msg.UInt8MultiArray(data=[1] + [-1])  # wrong
        std_msgs.msg.UInt8MultiArray(data=[300] * 2)  # wrong
    """),
    "answers of services": node("""
        def on_set(self, request, response):  # wrong
            response.success = request.data
            self.get_logger().info('set')

        def on_reset(self, request, response):
            if not self.ready:
                return False  # wrong
            if self.quiet:
                return Trigger_Response()
            if self.late:
                return SetBool.Response()  # wrong
            if self.early:
                return  # wrong
            if self.lost:
                return True, 'lost'  # wrong
            def ready():
                return
            return response

        def on_clear(self, request, response):
            response.success = True
            raise NotImplementedError

        def more(self):
            self.create_service(Trigger, 'reset', self.on_reset)
            self.create_service(Trigger, 'clear', self.on_clear)
    """),
    "in rospy": script("""
        texts = rospy.Publisher('text', String, queue_size=1)
        speeds = rospy.Publisher('speed', Float64, queue_size=1)
        texts.publish(3)  # wrong
        texts.publish('a')
        texts.publish(String('a'))
        texts.publish(String(3))  # wrong
        texts.publish(Int32(3))  # wrong
        speeds.publish(1)
        speeds.publish('1')  # wrong
        Int32(1.5)  # wrong
        Bool(data='yes')  # wrong
        Bool(1)
        header = Header()
        header.stamp = rospy.get_time()  # wrong
        header.stamp = rospy.Time.now()
        header = Header(0, None, 'map')
        msg = Twist()
        msg.linear = 1.0  # wrong
        msg.linear.x = '1'  # wrong
        msg.linear.x = rospy.Time.now()  # wrong
        msg.linear = Point(1, 2, 3)
    """),
    "in rospy, the value of the only field": script("""
        def on_set(request):
            texts.publish(request.data)  # wrong
            truths.publish(request.data)
            speeds.publish(Twist().linear.x)
            points.publish(Twist().linear.x)  # wrong
            points.publish(Point())
            points.publish(Vector3())
            proxy = rospy.ServiceProxy('other', SetBool)
            proxy(request.data)
            return SetBoolResponse(True, '')

        truths = rospy.Publisher('truth', Bool, queue_size=1)
        texts = rospy.Publisher('text', String, queue_size=1)
        speeds = rospy.Publisher('speed', Float64, queue_size=1)
        points = rospy.Publisher('point', Point, queue_size=1)
        rospy.Service('set', SetBool, on_set)
    """),
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG)
def test_named_are_values_that_a_field_does_not_hold(text: str) -> None:
    assert told(text, "RM202") == marked(text)


CPP = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_msgs/msg/float64.hpp"
class N : public rclcpp::Node {
public:
  N() : Node("n") {
    std_msgs::msg::String text;
    text.data = 42;  // wrong
    text.data = "42";
    std_msgs::msg::Float64 number;
    number.data = 42;
    number.data = true;
    number.data = "42";  // wrong
    number.date = 1.0;  // field
    pub_ = create_publisher<std_msgs::msg::String>("a", 1);
  }
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
"""


def test_in_cpp_numbers_become_one_another() -> None:
    lines = [line.strip() for line in CPP.splitlines()]
    wrong = [line for line in lines if line.endswith("// wrong")]
    assert told(CPP, "RM202", ".cpp") == wrong
    assert told(CPP, "RM201", ".cpp") == [line for line in lines if line.endswith("// field")]
    assert told(CPP, "RM203", ".cpp") == told(CPP, "RM204", ".cpp") == []


UNSURE = {
    "names of several kinds": tick("""
        value = 1
        if self.ready:
            value = 'a'
        String(data=value)
        self.state = None
        self.state = self.read()
        String(data=self.state)
    """),
    "attributes that others set": node("""
        def tick(self):
            self.name = 3
            String(data=self.name)

        def other(self, node):
            node.worker.name = 'a'
    """),
    "what only an annotation says": node("""
        def send(self, msg: Odometry):
            self.twists.publish(msg)
    """),
}


@pytest.mark.parametrize("text", UNSURE.values(), ids=UNSURE)
def test_nothing_is_told_of_values_that_are_not_sure(text: str) -> None:
    assert told(text, "RM202") == []


def test_a_time_becomes_a_message() -> None:
    text = tick("Header(stamp=self.get_clock().now())")
    assert "Header(stamp=self.get_clock().now().to_msg())" in fixed(text, "RM202")


INTEGERS = tick("""
    count = 3
    msg = Twist()
    msg.linear.x = 1  # wrong
    msg.linear.y = -2  # wrong
    msg.linear.z = count  # wrong
    msg.angular.z = count * 2.0
    msg.angular = Vector3(x=0, y=1.0)  # wrong
    Point(x=1.0 if count else 0.5)
    Point(x=0 if count else 0.5)  # wrong
    msg.linear.x = self.speed if count else (0 if self.slow else -1)  # wrong
    msg.angular.x = 0 if count else 1  # wrong
    msg.angular.y = len('abc') - 1  # wrong
    Float64MultiArray(data=[0, 1.5, 2])  # wrong
    scan = LaserScan()
    scan.ranges = [0] * 3  # wrong
    scan.ranges.append(1)
    scan.ranges[0] = 1
    Float32(data=Int32().data)  # wrong
    Int32(data=1)
""")


def test_named_are_integers_in_fields_of_floating_point() -> None:
    assert told(INTEGERS, "RM203") == marked(INTEGERS)


def test_integers_become_numbers_of_floating_point() -> None:
    after = fixed(INTEGERS, "RM203")
    assert told(after, "RM203") == []
    for each in (
        "msg.linear.x = 1.0 ",
        "msg.linear.y = -2.0 ",
        "msg.linear.z = float(count) ",
        "x=0.0, y=1.0",
        "[0.0, 1.5, 2.0]",
        "[0.0] * 3",
        "float(len('abc') - 1)",
        "data=float(Int32().data)",
    ):
        assert each in after


def test_rospy_takes_integers() -> None:
    assert told(script("Vector3(1, 2, 3)\nTwist().linear.x = 1\n"), "RM203") == []


@pytest.mark.parametrize(
    ("first", "line", "is_told"),
    [
        ("", "for _ in range(3): pass", True),
        ("", "for _ in xrange(3): pass", False),
        ("", "for each in {}.iteritems(): pass", False),
        ("", "xrange = range\nfor _ in xrange(3): pass", True),
        ("#!/usr/bin/env python2\n", "pass", False),
        ("#!/usr/bin/env python\n", "pass", True),
    ],
)
def test_python2_packs_what_python3_refuses(first: str, line: str, is_told: bool) -> None:
    text = f"{first}import rospy\nfrom std_msgs.msg import Int32\nrospy.init_node('a')\n{line}\n"
    text += (
        "pub = rospy.Publisher('a', Int32, queue_size=1)\npub.publish(Int32(data=4.5))  # wrong\n"
    )
    assert told(text, "RM202") == (marked(text) if is_told else [])


@pytest.mark.parametrize("value", ["'%d' % 4", "{}", "[1]", "Int32"])
def test_neither_packs_what_is_no_number(value: str) -> None:
    text = "import rospy\nfrom std_msgs.msg import Int32\nrospy.init_node('a')\nraw_input()\n"
    text += "pub = rospy.Publisher('a', Int32, queue_size=1)\n"
    text += f"pub.publish(Int32(data={value}))  # wrong\n"
    assert told(text, "RM202") == marked(text)


SAID = {
    "self.texts.publish('a')": "what is sent here is a str, and has to be `std_msgs/String`",
    "std_msgs.msg.UInt8MultiArray(data=[1, 300])": (
        "field `data` of `std_msgs/UInt8MultiArray` is `uint8[]` (0 to 255), and gets a list with "
        "`300`"
    ),
    "std_msgs.msg.UInt8(data=300)": (
        "field `data` of `std_msgs/UInt8` is `uint8` (0 to 255), and gets `300`"
    ),
}


@pytest.mark.parametrize(("line", "message"), SAID.items(), ids=SAID)
def test_what_is_said_of_a_value(line: str, message: str) -> None:
    assert [each.message for each in diagnostics(tick(line), "RM202")] == [message]
