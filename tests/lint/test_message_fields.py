"""Fields that messages do not have: named where that is sure, and not where it is not."""

from __future__ import annotations

import pytest
from message_programs import diagnostics, fixed, marked, node, script, tick, told

STAND_IN = """
try:
    from geometry_msgs.msg import Twist
except ImportError:
    class Twist:
        turn = 0.0

"""
READ = {
    "of a class that stands in for one": tick("Twist().turn").replace(
        "class Worker", f"{STAND_IN}class Worker"
    ),
    "of a message that is made": tick("""
        msg = Twist()
        msg.linear.w = 1.0  # wrong
        msg.linear.x = 1.0
        print(msg.angle)  # wrong
        msg.linear.x += msg.liner.x  # wrong
        msg.linear.z, msg.angular.q = 1.0, 2.0  # wrong
    """),
    "of one by the module that has it": tick("""
        msg = std_msgs.msg.String()
        msg.text = 'a'  # wrong
        other = geometry.Twist()
        other.lineal.x = 1.0  # wrong
        geometry.Pose().positions  # wrong
    """),
    "of a subscription": node("""
        def on_odometry(self, msg):
            x = msg.pose.position.x  # wrong
            y = msg.pose.pose.position.y
            pose = msg.pose.pose
            print(pose.orientation.yaw)  # wrong
            twist: Twist = msg.twist.twist
            self.get_logger().info(f'{twist.linear.x} {msg.twists}')  # wrong
    """),
    "of what an attribute holds": node("""
        def on_odometry(self, msg):
            self.last = msg.pose.pose

        def tick(self):
            print(self.last.position.x, self.last.orientation.w)
            print(self.last.pose.position.x)  # wrong
            self.goal = PoseStamped()
            self.goal.head.frame_id = 'map'  # wrong
            for goal in self.goals:
                self.goal.heading = 1.0
                self.goal = goal

        def set(self, goal):
            self.goal = goal
            self.goal.anything = 1
    """),
    "of elements": node("""
        def on_poses(self, msg):
            for pose in msg.poses:
                print(pose.position.x, pose.pos.x)  # wrong
            for number, pose in enumerate(msg.poses):
                pose.orientations  # wrong
            names = [each.posn for each in msg.poses]  # wrong
            msg.poses[0].position.x
            msg.poses[0].positions.x  # wrong
            msg.poses.position  # wrong
            first = msg.poses[-1]
            first.header  # wrong
            len(msg.poses)
            print(msg.poses.pop().position, msg.poses.pop(0).place)  # wrong
            msg.poses.append(Pose())
            for pose in msg.poses[1:]:
                pose.header  # wrong
    """),
    "of a lambda, and what it hands on": node("""
        def on_scan(self, msg, name):
            print(msg.ranges[0], msg.distances)  # wrong
            print(min(msg.ranges), msg.ranges.index(0.5), msg.ranges.tolist())
    """),
    "of requests and responses": node("""
        def on_set(self, request, response):
            response.succes = request.data  # wrong
            response.message = request.state  # wrong
            return response

        def tick(self):
            request = SetBool.Request()
            request.value = True  # wrong
            answer = self.client.call(request)
            print(answer.success, answer.data)  # wrong

        async def later(self):
            answer = await self.client.call_async(SetBool.Request(data=True))
            print(answer.ok)  # wrong

        def over(self):
            future = self.client.call_async(SetBool.Request())
            print(future.result().message, future.result().msg)  # wrong
    """),
    "of what futures bring": node("""
        def tick(self):
            self.client.call_async(SetBool.Request()).add_done_callback(self.on_answer)
            future = self.counter.send_goal_async(Fibonacci.Goal())
            future.add_done_callback(self.on_goal)

        def on_answer(self, future):
            print(future.result().success, future.result().succeeded)  # wrong

        def on_goal(self, future):
            handle = future.result()
            if not handle.accepted:
                return
            self.pending = handle.get_result_async()
            self.pending.add_done_callback(self.on_result)

        def on_result(self, future):
            print(future.result().status, future.result().result.sequence)
            print(future.result().result.order)  # wrong

        async def at_once(self):
            handle = await self.counter.send_goal_async(Fibonacci.Goal())
            answer = await handle.get_result_async()
            print(answer.result.seq)  # wrong
    """),
    "of actions": node("""
        def on_count(self, goal_handle):
            goal_handle.request.order
            goal_handle.request.number  # wrong
            goal_handle.succeed()
            feedback = Fibonacci.Feedback()
            feedback.partial = []  # wrong
            result = Fibonacci.Result()
            result.seq = feedback.sequence  # wrong
            return result

        def more(self):
            ActionServer(self, Fibonacci, 'a', self.on_count, goal_callback=self.on_asked)

        def on_asked(self, request):
            print(request.order, request.orders)  # wrong

        def tick(self):
            goal = Fibonacci.Goal()
            goal.oder = 3  # wrong
            self.counter.send_goal_async(goal, feedback_callback=self.on_feedback)

        def on_feedback(self, msg):
            print(msg.feedback.sequence, msg.feedback.sequences)  # wrong
    """),
    "of a callback for messages of two types, or of two subscribers": node("""
        def on_either(self, msg):
            print(msg.linear, msg.position, msg.pose)  # wrong

        def more(self):
            self.create_subscription(Twist, 'a', self.on_either, 10)
            self.create_subscription(Pose, 'b', self.on_either, 10)
            scans = message_filters.Subscriber(self, LaserScan, 'scan')
            self.poses = message_filters.Subscriber(self, PoseStamped, 'pose')
            both = message_filters.ApproximateTimeSynchronizer([scans, self.poses], 10, 0.1)
            both.registerCallback(self.on_both)

        def on_both(self, scan, pose):
            print(scan.ranges, pose.pose)
            print(scan.range)  # wrong
            print(pose.position)  # wrong
    """),
    "of what libraries give": tick("""
        found = self.buffer.lookup_transform('map', 'base', Time())
        print(found.transform.translation.x, found.translation)  # wrong
        image = self.bridge.cv2_to_imgmsg(self.frame, 'bgr8')
        image.head.frame_id = 'camera'  # wrong
    """),
    "of what functions of the file give": node("""
        def pose(self, x):
            pose = Pose()
            pose.position.x = x
            return pose

        def tick(self):
            pose = self.pose(1.0)
            print(pose.position.x, pose.x)  # wrong
            other = copy.deepcopy(pose)
            other.point = None  # wrong
            self.show(pose)

        def show(self, it):
            print(it.position, it.place)  # wrong
    """),
    "by keyword": tick("""
        Twist(linear=Vector3(x=1.0, w=2.0))  # wrong
        String(text='a')  # wrong
        self.texts.publish(String(Data='a'))  # wrong
        Twist(linear=Vector3(), check_fields=True)
    """),
    "of classes, and constants": tick("""
        marker = Marker()
        marker.type = Marker.CUBE
        marker.type = Marker.CUB  # wrong
        marker.action = marker.ADDED  # wrong
        DiagnosticStatus.WARNING  # wrong
        DiagnosticStatus.WARN
    """),
    "of the other generation of ROS": tick("""
        header = Header()
        header.seq = 1  # wrong
        header.stamp.secs  # wrong
        header.stamp.to_sec()  # wrong
        header.stamp.sec
        header.stamp.nanosec
    """),
    "in rospy": script("""
        def on_odometry(msg):
            print(msg.pose.position.x)  # wrong
            print(msg.header.seq, msg.header.stamp.secs, msg.header.stamp.to_sec())
            print(msg.header.stamp.sec)  # wrong
            print(msg.header.stamp.nanosec)  # wrong

        def on_set(request):
            answer = SetBoolResponse()
            answer.msg = str(request.data)  # wrong
            return SetBoolResponse(sucess=True)  # wrong

        rospy.Subscriber('odom', Odometry, on_odometry)
        rospy.Service('set', SetBool, on_set)
        set_bool = rospy.ServiceProxy('set', SetBool)
        answer = set_bool(True)
        answer.success
        answer.succeeded  # wrong
        set_bool.call(SetBoolRequest(True)).text  # wrong
        msg = rospy.wait_for_message('odom', Odometry)
        msg.twist.linear  # wrong
        goal = FibonacciGoal()
        goal.orders = 2  # wrong
        client = actionlib.SimpleActionClient('count', FibonacciAction)
        client.get_result().sequences  # wrong
    """),
}


@pytest.mark.parametrize("text", READ.values(), ids=READ)
def test_named_are_fields_that_a_message_does_not_have(text: str) -> None:
    assert told(text, "RM201") == marked(text)


UNSURE = {
    "a name of two messages": tick("""
        msg = Twist()
        if self.stopped:
            msg = TwistStamped()
        msg.twist.linear.x = 1.0
    """),
    "one message or another": tick("""
        msg = Twist() if self.plain else PoseStamped()
        msg.pose.position.x = 1.0
    """),
    "what is asked before": node("""
        def on_odometry(self, msg):
            if hasattr(msg, 'velocity'):
                print(msg.velocity)
            try:
                print(msg.speed)
            except AttributeError:
                pass
            if isinstance(msg, Twist):
                print(msg.linear)
    """),
    "what a callback gets for two types": node("""
        def on_either(self, msg):
            print(msg.linear, msg.position)

        def more(self):
            self.create_subscription(Twist, 'a', self.on_either, 10)
            self.create_subscription(Pose, 'b', self.on_either, 10)
    """),
    "a parameter that some callers give something else": node("""
        def tick(self):
            self.show(Pose())
            self.show(self.unknown())

        def show(self, it):
            print(it.anything)
    """),
    "a function that others call by the same name": node("""
        def publish(self, world):
            self.texts.publish(String(data=world.name))
    """),
    "a type that a class which derives may replace": node("""
        type = Twist

        def more(self):
            self.create_subscription(self.type, 'a', self.on_it, 10)

        def on_it(self, msg):
            print(msg.twist)
    """),
    "what rclpy's messages have besides": tick("""
        msg = Twist()
        msg.get_fields_and_field_types()
        msg.SLOT_TYPES, msg.__slots__, Twist.__name__
        String().data.split(',')[0].upper()
        Float64MultiArray().data.tolist()
    """),
    "a file for both generations of ROS": tick("""
        Header().seq = 1
    """).replace(
        "import rclpy\n", "try:\n    import rospy\nexcept ImportError:\n    import rclpy\n"
    ),
    "a type of nobody's": tick("""
        from somebody_msgs.msg import Thing
        Thing().anything = 1
    """),
    "what a variable is given in a loop": node("""
        def on_odometry(self, msg):
            for _ in range(2):
                msg = msg.pose
                print(msg.covariance)
    """),
}


@pytest.mark.parametrize("text", UNSURE.values(), ids=UNSURE)
def test_nothing_is_told_of_what_may_be_something_else(text: str) -> None:
    assert told(text, "RM201") == []


def test_a_slip_is_mended_and_another_thing_is_not() -> None:
    text = tick("""
        msg = Twist()
        msg.liner.x = 1.0
        msg.Angular.z = 1.0
        msg.rotation.z = 1.0
    """)
    after = fixed(text, "RM201")
    assert "msg.linear.x = 1.0" in after
    assert "msg.angular.z = 1.0" in after
    assert "msg.rotation.z = 1.0" in after


def test_a_diagnostic_says_what_there_is() -> None:
    text = tick("Vector3().w")
    (found,) = diagnostics(text, "RM201")
    assert found.message == "`geometry_msgs/Vector3` has no field `w`"
    assert found.help == "it has `x`, `y`, `z`"
    assert found.span is not None
    assert text[found.span.start : found.span.end] == "w"


@pytest.mark.parametrize(
    ("line", "message", "help_"),
    [
        (
            "SetBool.Request().success",
            "`success` is a field of the response of `std_srvs/SetBool`, not of its request",
            "the definition has it in the part of the response",
        ),
        (
            "GetParameters.Response().names",
            "`names` is a field of the request of `rcl_interfaces/GetParameters`, "
            "not of its response",
            "the definition has it in the part of the request",
        ),
        ("Pose().positions", None, "did you mean `position`?"),
        ("Pose().posture", None, "it has `position`, `orientation`"),
        ("Odometry().header.frame", None, "did you mean `frame_id`?"),
        ("Twist().linear_x", None, "did you mean `linear.x`?"),
        ("Twist().linear_w", None, "did you mean `linear`?"),
        ("Twist(linear_x=1.0)", None, "did you mean `linear`?"),
        ("Twist().x", None, "it has `linear`, `angular`"),
        ("Odometry().pose.position", None, "did you mean `pose.pose.position`?"),
        ("PoseStamped().frame_id", None, "did you mean `header.frame_id`?"),
        ("PoseArray().poses[0].position_x", None, "did you mean `position.x`?"),
        ("PoseArray().position", None, "it has `header`, `poses`"),
    ],
)
def test_a_diagnostic_offers_what_may_be_meant(line: str, message: str | None, help_: str) -> None:
    imports = "from rcl_interfaces.srv import GetParameters\n"
    found = diagnostics(imports + tick(f"print({line})"), "RM201")[0]
    assert message in (None, found.message)
    assert found.help == help_
    assert found.fix is None


def test_a_type_is_found_in_one_of_the_modules_that_are_imported_whole() -> None:
    text = script("""
        from interactive_markers.menu_handler import *
        from visualization_msgs.msg import *
        marker = InteractiveMarker()
        marker.heading.frame_id = 'world'  # wrong
        marker.header.frame_id = 'world'

        def on_odometry(msg):
            print(msg.poses)  # wrong

        rospy.Subscriber(rospy.get_param('~topic', 'odom'), Odometry, on_odometry)
    """)
    assert told(text, "RM201") == marked(text)
