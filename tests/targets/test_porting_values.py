"""What rospy makes messages of by itself, brought to rclpy, which does not: before → after."""

from __future__ import annotations

import ast
import textwrap

import pytest
from ported_nodes import MARK, after_head, count_marks, ported

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType
from plastron_tui.sources.python.calls import LIBRARIES
from plastron_tui.sources.python.shared_analysis import analyze
from plastron_tui.targets.python.porting.fields import write_fields
from plastron_tui.targets.python.porting.port_state import Work

PUBLISH = f"{MARK}publish takes a message\n"
RETURN = f"{MARK}return a response\n"

PUBLISHED = [
    ("text.publish('hello')", "text.publish(String(data='hello'))"),
    ("text.publish(f'hello {x}')", "text.publish(String(data=f'hello {x}'))"),
    ("text.publish('a %s' % x)", "text.publish(String(data='a %s' % x))"),
    ("text.publish('a' + x)", "text.publish(String(data='a' + x))"),
    ("text.publish('a {}'.format(x))", "text.publish(String(data='a {}'.format(x)))"),
    ("text.publish(str(x))", "text.publish(String(data=str(x)))"),
    ("text.publish(str(x)[::-1])", "text.publish(String(data=str(x)[::-1]))"),
    ("number.publish(min(x))", "number.publish(Float64(data=float(min(x))))"),
    ("number.publish(min(x, key=f))", f"{PUBLISH}number.publish(min(x, key=f))"),
    ("point.publish(x)", "point.publish(x)"),
    (
        "rospy.Subscriber('t', String, lambda m: text.publish(m.data))",
        "node.create_subscription(String, 't', lambda m: text.publish(String(data=m.data)), 10)",
    ),
    ("text.publish(data=x)", "text.publish(String(data=x))"),
    ("text.publish()", "text.publish(String())"),
    ("text.publish(\n    'hello',\n)", "text.publish(\n    String(data='hello'),\n)"),
    ("dotted.publish('hello')", "dotted.publish(std_msgs.msg.String(data='hello'))"),
    (
        "rospy.Publisher('t', String, queue_size=1).publish('x')",
        "node.create_publisher(String, 't', 1).publish(String(data='x'))",
    ),
    ("number.publish(5)", "number.publish(Float64(data=5.0))"),
    ("number.publish(-5)", "number.publish(Float64(data=-5.0))"),
    ("number.publish(5.5)", "number.publish(Float64(data=5.5))"),
    ("number.publish(0x10)", "number.publish(Float64(data=float(0x10)))"),
    ("number.publish(2 * x)", "number.publish(Float64(data=float(2 * x)))"),
    ("number.publish(0.5 * x)", "number.publish(Float64(data=float(0.5 * x)))"),
    ("number.publish(0.5 * len(x))", "number.publish(Float64(data=0.5 * len(x)))"),
    ("number.publish(int(x))", "number.publish(Float64(data=float(int(x))))"),
    ("number.publish(data=5)", "number.publish(Float64(data=5.0))"),
    ("whole.publish(5)", "whole.publish(Int32(data=5))"),
    ("whole.publish(2 * 3 + 1)", "whole.publish(Int32(data=2 * 3 + 1))"),
    ("flag.publish(True)", "flag.publish(Bool(data=True))"),
    ("flag.publish(1)", "flag.publish(Bool(data=bool(1)))"),
    ("flag.publish(a > b)", "flag.publish(Bool(data=a > b))"),
    ("octet.publish(5)", 'octet.publish(Byte(data=b"\\x05"))'),
    ("octet.publish(int(x))", f"{PUBLISH}octet.publish(int(x))"),
    ("point.publish(1, x, 3.5)", "point.publish(Point(x=1.0, y=float(x), z=3.5))"),
    ("point.publish(x=1, z=a)", "point.publish(Point(x=1.0, z=float(a)))"),
    (
        "stamped.publish(Header(), Point(1, 2, 3))",
        "stamped.publish(PointStamped(header=Header(), point=Point(x=1.0, y=2.0, z=3.0)))",
    ),
    (
        "numbers.publish(data=[1, 2.5, x])",
        "numbers.publish(Float32MultiArray(data=[1.0, 2.5, float(x)]))",
    ),
    (
        "numbers.publish(data=[each for each in x])",
        "numbers.publish(Float32MultiArray(data=[float(each) for each in x]))",
    ),
    # Nobody knows what it is, or it is no message of the topic's type in rospy either.
    ("text.publish(message)", f"{PUBLISH}text.publish(message)"),
    ("text.publish(make(1))", f"{PUBLISH}text.publish(make(1))"),
    (
        "text.publish(rospy.get_param('~a'))",
        "text.publish(String(data=get_param('a')))",
    ),
    ("text.publish(String(data='x'))", "text.publish(String(data='x'))"),
    ("text.publish(*parts)", f"{PUBLISH}text.publish(*parts)"),
    ("text.publish(5)", f"{PUBLISH}text.publish(5)"),
    ("point.publish(1, 2)", f"{PUBLISH}point.publish(1, 2)"),
    ("point.publish(w=1)", f"{PUBLISH}point.publish(w=1)"),
    ("pubs['a'].publish('x')", f"{PUBLISH}pubs['a'].publish('x')"),
    # A name is what it is bound to.
    ("x = 'a'\ntext.publish(x)", "x = 'a'\ntext.publish(String(data=x))"),
    (
        "count = 0\ncount += 1\nwhole.publish(count)",
        "count = 0\ncount += 1\nwhole.publish(Int32(data=count))",
    ),
    (
        "for i in range(3):\n    number.publish(i)",
        "for i in range(3):\n    number.publish(Float64(data=float(i)))",
    ),
    ("x = String()\ntext.publish(x)", "x = String()\ntext.publish(x)"),
    ("x = 'a'\nx = make()\ntext.publish(x)", f"x = 'a'\nx = make()\n{PUBLISH}text.publish(x)"),
    # The class of a message takes no positions, and no whole number for another.
    ("x = String('a')", "x = String(data='a')"),
    ("x = Point(1, 2, 3)", "x = Point(x=1.0, y=2.0, z=3.0)"),
    ("x = Float64(data=5)", "x = Float64(data=5.0)"),
    ("x = Float64(5)", "x = Float64(data=5.0)"),
    ("x = Header(0, now, 'map')", f"{MARK}Header takes keywords only\nx = Header(0, now, 'map')"),
    ("x = Header(seq=0)", f"{MARK}seq of Header\nx = Header(seq=0)"),
    # rclpy reads the memory of a `float` and of a `bool`, whatever a field of such holds.
    ("x = Float64(data=unknown)", "x = Float64(data=float(unknown))"),
    ("x = Float64(data=max(1, 2))", "x = Float64(data=float(max(1, 2)))"),
    ("x = Float64(data=SPEED['fast'])", "x = Float64(data=float(SPEED['fast']))"),
    ("x = Bool(data=unknown)", "x = Bool(data=bool(unknown))"),
    ("x = Int32(data=unknown)", "x = Int32(data=unknown)"),
    ("x = Point(x=1, y=unknown)", "x = Point(x=1.0, y=float(unknown))"),
    ("x = Float64()\nx.data = steps()", "x = Float64()\nx.data = float(steps())"),
    ("x = Float64()\nsetattr(x, 'data', 1)", "x = Float64()\nsetattr(x, 'data', 1.0)"),
    ("x = Point()\nsetattr(x, name, y)", "x = Point()\nsetattr(x, name, float(y))"),
    (
        "x = PointStamped()\nsetattr(x.point, 'z', max(1, 2))",
        "x = PointStamped()\nsetattr(x.point, 'z', float(max(1, 2)))",
    ),
    ("setattr(unknown, 'data', 1)", "setattr(unknown, 'data', 1)"),
    ("x = Point()\nx.x, x.y = 1, y", "x = Point()\nx.x, x.y = 1.0, float(y)"),
    ("x = Point()\nx.x, x.y = pair", "x = Point()\nx.x, x.y = map(float, pair)"),
    ("x = Point()\nx.x, y = pair", f"x = Point()\n{MARK}fields of numbers\nx.x, y = pair"),
    (
        "x = Float32MultiArray()\nx.data = values",
        "x = Float32MultiArray()\nx.data = [float(each) for each in values]",
    ),
    (
        "x = Float32MultiArray()\nx.data = [1, y]",
        "x = Float32MultiArray()\nx.data = [1.0, float(y)]",
    ),
    (
        "x = Float32MultiArray(data=[i for i in range(3)])",
        "x = Float32MultiArray(data=[float(i) for i in range(3)])",
    ),
    (
        "x = Float32MultiArray(data=z)\ny = Float32MultiArray(data=x.data)",
        "x = Float32MultiArray(data=[float(each) for each in z])\n"
        "y = Float32MultiArray(data=x.data)",
    ),
    (
        "x = Float32MultiArray()\ny = Float64(data=x.data[0])",
        "x = Float32MultiArray()\ny = Float64(data=x.data[0])",
    ),
    (
        "def drive(twist, speed):\n    twist.linear.x = speed",
        "def drive(twist, speed):\n    twist.linear.x = float(speed)",
    ),
    (
        "def drive(twist: Twist, speed):\n    twist.linear.x = speed",
        "def drive(twist: Twist, speed):\n    twist.linear.x = float(speed)",
    ),
    ("x = Twist()", "x = Twist()"),
    ("x = Twist()\nx.linear.x = 1", "x = Twist()\nx.linear.x = 1.0"),
    ("x = Twist()\nx.linear.x = x.linear.y = -1", "x = Twist()\nx.linear.x = x.linear.y = -1.0"),
    ("x = Twist()\nx.linear.x = 2 * y", "x = Twist()\nx.linear.x = float(2 * y)"),
    ("x = Twist()\nx.linear.x = y", "x = Twist()\nx.linear.x = float(y)"),
    ("x = Int32()\nx.data = 1", "x = Int32()\nx.data = 1"),
    ("x = make()\nx.linear.x = 1", "x = make()\nx.linear.x = 1.0"),
    ("x = make()\nx.x = 1", "x = make()\nx.x = 1"),
]


@pytest.mark.parametrize(("before", "after"), PUBLISHED)
def test_what_is_published(before: str, after: str) -> None:
    text = after_head(before)
    assert text.endswith(f"\n{after}\n")
    assert count_marks(text) == after.count(MARK)


HEARD = [
    ("text.publish(msg)", "text.publish(msg)"),
    ("text.publish(msg.data)", "text.publish(String(data=msg.data))"),
    ("number.publish(len(msg.data))", "number.publish(Float64(data=float(len(msg.data))))"),
    ("text.publish('heard ' + msg.data)", "text.publish(String(data='heard ' + msg.data))"),
]


@pytest.mark.parametrize(("before", "after"), HEARD)
def test_what_a_callback_publishes(before: str, after: str) -> None:
    text = after_head(f"def hear(msg):\n    {before}\n\n\nrospy.Subscriber('s', String, hear)")
    assert f"def hear(msg):\n    {after}\n" in text
    assert MARK not in text


def test_an_attribute_holds_what_its_class_puts_in() -> None:
    before = """
        class Counter:
            def __init__(self):
                self.count = 0
                self.pub = rospy.Publisher('count', Int32, queue_size=1)
                rospy.Timer(rospy.Duration(1), self.tick)

            def tick(self, event):
                self.count += 1
                self.pub.publish(self.count)
        """
    text = after_head(textwrap.dedent(before) + "\nCounter()")
    assert "        self.pub.publish(Int32(data=self.count))\n" in text
    assert MARK not in text


def test_a_parameter_that_is_a_whole_number_by_default() -> None:
    text = after_head("def drive(speed=1):\n    x = Twist()\n    x.linear.x = speed")
    assert "    x.linear.x = float(speed)\n" in text


def test_all_types_of_a_tutorial() -> None:
    text, _ = ported(
        "import rospy\nfrom beginner_tutorials.srv import *\n\n\n"
        "def add(req):\n    return AddTwoIntsResponse(req.a + req.b)\n\n\n"
        "rospy.init_node('n')\nrospy.Service('add', AddTwoInts, add)\nrospy.spin()\n",
        "rospy",
    )
    assert "\nfrom example_interfaces.srv import AddTwoInts\n" in text
    assert "\nAddTwoIntsResponse = AddTwoInts.Response\n" in text
    assert "    return AddTwoIntsResponse(sum=req.a + req.b)\n" in text
    assert "beginner_tutorials" not in text


def test_a_type_that_the_place_does_not_see_is_marked() -> None:
    before = (
        "def make():\n    from std_msgs.msg import UInt8 as Small\n"
        "    return 1\n\n\ndef other():\n    global small\n"
        "    from std_msgs.msg import UInt8 as Small\n"
        "    small = rospy.Publisher('small', Small, queue_size=1)\n\n\n"
        "def send():\n    small.publish(5)"
    )
    assert f"    {MARK}publish takes a message\n    small.publish(5)\n" in after_head(before)


RETURNED = [
    ("AddTwoInts", "return 5", "return AddTwoInts.Response(sum=5)"),
    ("AddTwoInts", "return req.a + req.b", "return AddTwoInts.Response(sum=req.a + req.b)"),
    ("AddTwoInts", "return [5]", "return AddTwoInts.Response(sum=5)"),
    ("AddTwoInts", "return [req.a + req.b]", "return AddTwoInts.Response(sum=req.a + req.b)"),
    ("AddTwoInts", "return {'sum': 5}", "return AddTwoInts.Response(sum=5)"),
    ("AddTwoInts", "return AddTwoIntsResponse(5)", "return AddTwoIntsResponse(sum=5)"),
    ("AddTwoInts", "x = req.a\n    return x", "x = req.a\n    return AddTwoInts.Response(sum=x)"),
    ("Trigger", "return True, 'on'", "return Trigger.Response(success=True, message='on')"),
    ("Trigger", "return (True, 'on')", "return Trigger.Response(success=True, message='on')"),
    ("Trigger", "return [1, 'on']", "return Trigger.Response(success=bool(1), message='on')"),
    (
        "Trigger",
        "return {\n        'success': True,\n        'message': x,\n    }",
        "return Trigger.Response(\n        success=True,\n        message=x,\n    )",
    ),
    (
        "Trigger",
        "return TriggerResponse(True, 'on')",
        "return TriggerResponse(success=True, message='on')",
    ),
    ("Trigger", "x = TriggerResponse()\n    return x", "x = TriggerResponse()\n    return x"),
    ("Empty", "return []", "return Empty.Response()"),
    ("Empty", "return {}", "return Empty.Response()"),
    (
        "Trigger",
        "return TriggerResponse(True, 'a') if x else TriggerResponse()",
        "return TriggerResponse(success=True, message='a') if x else TriggerResponse()",
    ),
    ("Trigger", "return make()", f"{RETURN}    return make()"),
    ("Trigger", "return 5", f"{RETURN}    return 5"),
    ("Trigger", "return (True,)", f"{RETURN}    return (True,)"),
    ("Trigger", "return {'good': True}", f"{RETURN}    return {{'good': True}}"),
    ("Trigger", "return", f"{RETURN}    return"),
]


@pytest.mark.parametrize(("type_", "before", "after"), RETURNED)
def test_what_a_handler_returns(type_: str, before: str, after: str) -> None:
    text = after_head(f"def handle(req):\n    {before}\n\n\nrospy.Service('s', {type_}, handle)")
    assert f"def handle(req, response=None):\n    {after}\n" in text
    assert count_marks(text) == after.count(MARK)


def test_a_handler_of_two_types_is_marked() -> None:
    text = after_head(
        "def handle(req):\n    return True, 'on'\n\n\n"
        "rospy.Service('a', Trigger, handle)\nrospy.Service('b', SetBool, handle)"
    )
    assert f"    {RETURN}    return True, 'on'\n" in text


def test_names_that_are_bound_to_each_other_come_to_an_end() -> None:
    tangle = "".join(f"x = y + x.a{i}\ny = x.b{i} or y\n" for i in range(40))
    assert after_head(f"x = y = Twist()\n{tangle}text.publish(x)\nx.linear.x = 1")


CALLED = [
    ("proxy(5, 6)", "call_service(proxy, AddTwoInts.Request(a=5, b=6))"),
    ("proxy(a=5, b=6)", "call_service(proxy, AddTwoInts.Request(a=5, b=6))"),
    ("proxy.call(5, 6)", "call_service(proxy, AddTwoInts.Request(a=5, b=6))"),
    ("proxy()", "call_service(proxy, AddTwoInts.Request())"),
    ("proxy(AddTwoIntsRequest(a=5))", "call_service(proxy, AddTwoIntsRequest(a=5))"),
    ("proxy(ask)", None),
    ("proxy(5)", None),
    ("proxy(*numbers)", None),
    ("proxy('a', 6)", None),
]


@pytest.mark.parametrize(("call", "written"), CALLED)
def test_a_call_of_a_client(call: str, written: str | None) -> None:
    text = after_head(f"proxy = rospy.ServiceProxy('s', AddTwoInts)\nanswer = {call}")
    name = call.partition("(")[0]
    mark = f"{MARK}the call of {name}\n" if written is None else ""
    assert text.endswith(f"\n{mark}answer = {written or call}\n")


def test_what_python_has_is_no_message_of_a_package_that_is_imported_whole() -> None:
    text = after_head("from my_package.srv import *\nerror = ValueError('a', 1)")
    assert text.endswith("\nerror = ValueError('a', 1)\n")
    assert MARK not in text


BACK_HEAD = """\
import rclpy
from std_msgs.msg import Header, String
from std_srvs.srv import SetBool

rclpy.init()
node = rclpy.create_node('n')
client = node.create_client(SetBool, 's')
"""
BACK = [
    ("node.get_logger().info('a')", "rospy.loginfo('a')"),
    ("node.get_logger().warning(f'a {x}')", "rospy.logwarn(f'a {x}')"),
    ("node.get_logger().error(\n    x\n)", "rospy.logerr(\n    x\n)"),
    ("node.get_logger().info('a', once=True)", "rospy.loginfo_once('a')"),
    (
        "node.get_logger().warn(f'{x}', throttle_duration_sec=2.0)",
        "rospy.logwarn_throttle(2.0, f'{x}')",
    ),
    (
        "node.get_logger().info('a', once=x)",
        f"{MARK}.get_logger\nnode.get_logger().info('a', once=x)",
    ),
    (
        "node.create_timer(1.0, tick, callback_group=group)",
        f"{MARK}callback_group\nrospy.Timer(rospy.Duration(1.0), lambda event: tick())",
    ),
    ("log = node.get_logger()", f"{MARK}.get_logger\nlog = node.get_logger()"),
    ("x = rclpy.ok() and y", "x = not rospy.is_shutdown() and y"),
    ("x.header.stamp = node.get_clock().now().to_msg()", "x.header.stamp = rospy.Time.now()"),
    ("x = Header(stamp=node.get_clock().now().to_msg())", "x = Header(stamp=rospy.Time.now())"),
    ("use(node.get_clock().now().to_msg())", "use(rospy.Time.now())"),
    ("x = SetBool.Request(data=True)", "x = SetBoolRequest(data=True)"),
    ("x = client.call(SetBool.Request())", "x = client.call(SetBoolRequest())"),
    (
        "x = client.call_async(SetBool.Request())",
        f"{MARK}.call_async\nx = client.call_async(SetBoolRequest())",
    ),
]


@pytest.mark.parametrize(("before", "after"), BACK)
def test_the_way_back(before: str, after: str) -> None:
    callback = f"\n\ndef hear(msg):\n{textwrap.indent(before, '    ')}\n\n\n"
    made = "node.create_subscription(String, 's', hear, 10)\n"
    text, _ = ported(f"{BACK_HEAD}{callback}{made}{before}\n", "rclpy")
    ast.parse(text)
    assert text.endswith(f"\n{after}\n")
    assert f"def hear(msg):\n{textwrap.indent(after, '    ')}\n" in text
    assert ("import SetBool, SetBoolRequest\n" in text) == ("SetBoolRequest" in after)


@pytest.mark.parametrize(("field", "is_written"), [("gain", True), ("lambda", False)])
def test_a_field_that_python_has_a_keyword_for_is_not_named(field: str, is_written: bool) -> None:
    work = Work(analyze(b"import rospy\n5", LIBRARIES["rospy"]), Catalog("kilted"))
    value = work.analysis.syntax.root.named_children[1].named_children[0]
    splices = write_fields(work, [(None, value)], {field: FieldType("float64")})
    assert (splices is not None) == is_written
