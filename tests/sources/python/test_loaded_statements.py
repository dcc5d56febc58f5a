"""Each statement about what a node does more, on small nodes of every shape.

A statement changes the file, or a diagnostic says why it does not: nothing is ignored, and nothing
that a user wrote raises.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES, changed

GO = "create_message go of message_type Twist and input none\n"
AGAIN = "driver no_longer_has_parameter 'gain'\ndriver has_parameter 'gain' of parameter_type "
SCAN = "'scan' of message_type sensor_msgs/LaserScan"
ADD = "driver provides_service 'add' of service_type AddTwoInts "
CALM = "driver client_requests 'calm' of service_type Trigger with input none"
GOAL = "driver sends_goal to 'fib' of action_type Fibonacci with input order=5"

# What each of the four files gets: a part of the lines that differ, or the code of the refusal.
ROWS: dict[str, tuple[str, str, str, str]] = {
    "driver has_parameter 'speed' of parameter_type float with default 0.5": (
        "+self.declare_parameter('speed', 0.5)",
        "+node.declare_parameter('speed', 0.5)",
        "+self.speed = rospy.get_param('~speed', 0.5)",
        "+speed = rospy.get_param('~speed', 0.5)",
    ),
    'driver has_parameter \'names\' of parameter_type string_list with default ["a", "b"]': (
        "+self.declare_parameter('names', ['a', 'b'])",
        "+node.declare_parameter('names', ['a', 'b'])",
        "+self.names = rospy.get_param('~names', ['a', 'b'])",
        "+names = rospy.get_param('~names', ['a', 'b'])",
    ),
    "driver has_parameter 'speed' of parameter_type int with default 1 between 0 and 2": (
        "+'speed', 1, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=2)])",
        "+'speed', 1, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=2)])",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    "driver no_longer_has_parameter 'gain'": ("endpoint-in-use",) * 4,
    "driver no_longer_has_parameter 'idle'": (
        "-self.declare_parameter('idle', 2)",
        "-node.declare_parameter('idle', 2)",
        "-self.idle = rospy.get_param('~idle', 2)",
        "-idle = rospy.get_param('~idle', 2)",
    ),
    f"{AGAIN}float with default 2.5": (
        "+self.declare_parameter('gain', 2.5)",
        "+node.declare_parameter('gain', 2.5)",
        "+self.gain = rospy.get_param('~gain', 2.5)",
        "+gain = rospy.get_param('~gain', 2.5)",
    ),
    f"{AGAIN}float with default 1 between 0 and 3": (
        "+floating_point_range=[FloatingPointRange(from_value=0.0, to_value=3.0)]",
        "+floating_point_range=[FloatingPointRange(from_value=0.0, to_value=3.0)]",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f'{AGAIN}string with default "x"': ("other-type",) * 4,
    "driver repeats blink at 2 hz": (
        "+self.blink_timer = self.create_timer(0.5, self.blink)",
        "+node.create_timer(0.5, blink)",
        "+self.blink_timer = rospy.Timer(rospy.Duration(0.5), self.blink)",
        "+rospy.Timer(rospy.Duration(0.5), blink)",
    ),
    "driver repeats scan_callback at 2 hz": ("function-conflict",) * 4,
    "driver repeats blink at parameter 'gain' hz": (
        "+self.blink_timer = self.create_timer(1.0 / self.get_parameter('gain').value, self.blink)",
        "+node.create_timer(1.0 / node.get_parameter('gain').value, blink)",
        "+rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)), self.blink",
        "+rospy.Timer(rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)), blink)",
    ),
    "driver has_parameter 'rate' of parameter_type int with default 5\n"
    "driver repeats tock at parameter 'rate' hz": (
        "+self.tock_timer = self.create_timer(1.0 / self.get_parameter('rate').value, self.tock)",
        "+node.create_timer(1.0 / node.get_parameter('rate').value, tock)",
        "+rospy.Duration(1.0 / rospy.get_param('~rate', 5)), self.tock",
        "+rospy.Timer(rospy.Duration(1.0 / rospy.get_param('~rate', 5)), tock)",
    ),
    "driver stop_repeating tick": (
        "-self.timer = self.create_timer(0.5, self.tick)",
        "-timer = node.create_timer(0.5, tick)",
        "-self.timer = rospy.Timer(rospy.Duration(0.5), self.tick)",
        "-timer = rospy.Timer(rospy.Duration(0.5), tick)",
    ),
    "driver stop_repeating tick\ndriver repeats tick at 5 hz": (
        "+self.timer = self.create_timer(0.2, self.tick)",
        "+timer = node.create_timer(0.2, tick)",
        "+self.timer = rospy.Timer(rospy.Duration(0.2), self.tick)",
        "+timer = rospy.Timer(rospy.Duration(0.2), tick)",
    ),
    "driver repeats tick at 5 hz": (
        "+self.timer = self.create_timer(0.2, self.tick)",
        "+timer = node.create_timer(0.2, tick)",
        "+self.timer = rospy.Timer(rospy.Duration(0.2), self.tick)",
        "+timer = rospy.Timer(rospy.Duration(0.2), tick)",
    ),
    "driver repeats tick at 2 hz": ("already-repeating",) * 4,
    f"unsubscribe driver from 'scan'\nsubscribe driver to {SCAN} with qos depth 5": (
        "+self.create_subscription(LaserScan, 'scan', self.scan_callback, 5)",
        "+node.create_subscription(LaserScan, 'scan', scan_callback, 5)",
        "+rospy.Subscriber('scan', LaserScan, self.scan_callback, queue_size=5)",
        "+rospy.Subscriber('scan', LaserScan, scan_callback, queue_size=5)",
    ),
    "subscribe driver to 'joy' of message_type sensor_msgs/Joy with qos sensor_data": (
        "+self.create_subscription(Joy, 'joy', self.joy_callback, qos_profile_sensor_data)",
        "+node.create_subscription(Joy, 'joy', joy_callback, qos_profile_sensor_data)",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist with qos best_effort, depth 3": (
        "+Twist, 'out', QoSProfile(depth=3, reliability=ReliabilityPolicy.BEST_EFFORT)",
        "+Twist, 'out', QoSProfile(depth=3, reliability=ReliabilityPolicy.BEST_EFFORT)",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist once": (
        "+self.out_is_heard = self.out_pub.get_subscription_count() > 0",
        "+out_is_heard = out_pub.get_subscription_count() > 0",
        "+self.out_pub = rospy.Publisher('out', Twist, queue_size=1, latch=True)",
        "+out_pub = rospy.Publisher('out', Twist, queue_size=1, latch=True)",
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist once": ("edit-refused",) * 4,
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos depth 10": (
        "+self.cmd_pub.publish(Twist())",
        "+cmd_pub.publish(Twist())",
        "+self.cmd_pub.publish(Twist())",
        "+cmd_pub.publish(Twist())",
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos depth 5": (
        ("edit-refused",) * 4
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos best_effort": (
        "edit-refused",
        "edit-refused",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist for_each 'scan'": (
        "+self.out_pub.publish(Twist())",
        "+out_pub.publish(Twist())",
        "+self.out_pub.publish(Twist())",
        "+out_pub.publish(Twist())",
    ),
    "create_message i of message_type std_msgs/Int8 and input data=parameter 'idle' + 1\n"
    "driver publish i to 'out' of message_type std_msgs/Int8 at 3 hz": (
        ("+if -128 <= number <= 127:",) * 4
    ),
    f"{GO}driver publish go to 'out' of message_type Twist at parameter 'gain' hz": (
        "+1.0 / self.get_parameter('gain').value, self.publish_out",
        "+node.create_timer(1.0 / node.get_parameter('gain').value, publish_out)",
        "+rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)),",
        "+rospy.Timer(rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)), publish_out)",
    ),
    "create_message go of message_type Twist and input linear.x=parameter 'gain' * 2\n"
    "driver publish go to 'out' of message_type Twist": (
        "+self.out_pub.publish(Twist(linear=Vector3(x=self.get_parameter('gain').value * 2)))",
        "+out_pub.publish(Twist(linear=Vector3(x=node.get_parameter('gain').value * 2)))",
        "+Twist(linear=Vector3(x=rospy.get_param('~gain', 1.0) * 2))",
        "+out_pub.publish(Twist(linear=Vector3(x=rospy.get_param('~gain', 1.0) * 2)))",
    ),
    "driver has_parameter 'levels' of parameter_type int_list with default [1, 2]\n"
    "create_message l of message_type std_msgs/Int8MultiArray and input data=parameter 'levels'\n"
    "driver publish l to 'out' of message_type std_msgs/Int8MultiArray": (
        "+self.out_pub.publish(Int8MultiArray(data=list(numbers)))",
        "+out_pub.publish(Int8MultiArray(data=list(numbers)))",
        "+if all(-128 <= each <= 127 for each in numbers):",
        "+if all(-128 <= each <= 127 for each in numbers):",
    ),
    "subscribe driver to 'levels' of message_type std_msgs/Int32MultiArray\n"
    "create_message l of message_type std_msgs/Int8MultiArray and input data=received.data\n"
    "driver publish l to 'out' of message_type std_msgs/Int8MultiArray for_each 'levels'": (
        "+numbers = msg.data.tolist()",
        "+numbers = msg.data.tolist()",
        "+if all(-128 <= each <= 127 for each in msg.data):",
        "+if all(-128 <= each <= 127 for each in msg.data):",
    ),
    "subscribe driver to 'levels' of message_type std_msgs/Int32MultiArray\n"
    "create_message l of message_type std_msgs/UInt64 and input data=received.data[2]\n"
    "driver publish l to 'out' of message_type std_msgs/UInt64 for_each 'levels'": (
        ("+if len(msg.data) > 2 and msg.data[2] >= 0:",) * 4
    ),
    f"{ADD}answering sum=received.a + 1": (
        "+return AddTwoInts.Response(sum=request.a + 1)",
        "+return AddTwoInts.Response(sum=request.a + 1)",
        "+return AddTwoIntsResponse(sum=request.a + 1)",
        "+return AddTwoIntsResponse(sum=request.a + 1)",
    ),
    "driver stop_service 'reset'\n"
    "driver provides_service 'reset' of service_type Trigger answering success=True": (
        ("edit-refused",) * 4
    ),
    f"{CALM} at 2 hz": (
        "+self.calm_timer = self.create_timer(0.5, self.call_calm)",
        "+node.create_timer(0.5, call_calm)",
        "+self.calm_timer = rospy.Timer(rospy.Duration(0.5), self.call_calm)",
        "+rospy.Timer(rospy.Duration(0.5), call_calm)",
    ),
    f"{CALM} at parameter 'gain' hz": (
        "+self.calm_timer = self.create_timer("
        "1.0 / self.get_parameter('gain').value, self.call_calm)",
        "+node.create_timer(1.0 / node.get_parameter('gain').value, call_calm)",
        "+rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)), self.call_calm",
        "+rospy.Timer(rospy.Duration(1.0 / rospy.get_param('~gain', 1.0)), call_calm)",
    ),
    GOAL: (
        "+self.fib_client = ActionClient(self, Fibonacci, 'fib')",
        "+fib_client = ActionClient(node, Fibonacci, 'fib')",
        "+self.fib_client = actionlib.SimpleActionClient('fib', FibonacciAction)",
        "+fib_client = actionlib.SimpleActionClient('fib', FibonacciAction)",
    ),
    f"{GOAL}\n{GOAL[:-1]}6": ("edit-refused",) * 4,
    "driver provides_action 'fib' of action_type Fibonacci": (
        "+async def execute_fib(self, goal_handle):",
        "edit-refused",
        "+def execute_fib(self, goal):",
        "+def execute_fib(goal):",
    ),
    "driver provides_action 'fib' of action_type Fibonacci calling blink": (
        "+async def blink(self, goal_handle):",
        "edit-refused",
        "+def blink(self, goal):",
        "+def blink(goal):",
    ),
    "driver provides_action 'fib' of action_type Fibonacci calling reset_callback": (
        ("function-conflict",) * 4
    ),
    "driver stop_action 'fib'": ("not-serving",) * 4,
    "driver stop_goal to 'fib'": ("not-sending",) * 4,
}  # fmt: skip
CASES = [
    pytest.param(file, statement, expected, id=f"{statement.splitlines()[-1]} | {file}")
    for statement, row in ROWS.items()
    for file, expected in zip(FILES, row, strict=True)
]


@pytest.mark.parametrize(("file", "statement", "expected"), CASES)
def test_a_statement_changes_a_file_or_says_why_not(
    tmp_path: Path, file: str, statement: str, expected: str
) -> None:
    codes, lines = changed(tmp_path, FILES[file], statement)
    if expected[0] not in "+-":
        assert expected in codes
        return
    assert not codes - {"uncalled-function", "read-once", "also-sent"}
    assert any(line.startswith(expected) for line in lines), lines
