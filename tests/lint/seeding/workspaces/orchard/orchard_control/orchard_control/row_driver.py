import time

import rclpy
from geometry_msgs.msg import PoseStamped, Twist
from nav_msgs.msg import Odometry
from orchard_driver.names import CMD_VEL
from orchard_interfaces.action import DriveRow
from orchard_interfaces.msg import MotorState
from orchard_interfaces.srv import SetGear
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float64


class RowDriver(Node):
    """Drives along one row, as an action."""

    def __init__(self):
        super().__init__('row_driver')
        self.group = ReentrantCallbackGroup()
        self.declare_parameter('max_speed', 0.8)
        self.declare_parameter('gain', 1.2)
        self.declare_parameter('stop_distance', 0.5)
        self.declare_parameter('use_gears', True)
        self.declare_parameter('waypoints', [0.0, 5.0, 10.0])
        self.position = 0.0
        self.stalled = False
        self.cmd = self.create_publisher(Twist, CMD_VEL, 10)
        self.goal_pub = self.create_publisher(PoseStamped, 'row_goal', 10)
        self.error_pub = self.create_publisher(Float64, '~/error', 10)
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.create_subscription(MotorState, 'motor_state', self.on_state, 10)
        self.gear_client = self.create_client(SetGear, 'set_gear', callback_group=self.group)
        self.server = ActionServer(
            self,
            DriveRow,
            'drive_row',
            execute_callback=self.execute,
            goal_callback=self.on_goal,
            cancel_callback=self.on_cancel,
            callback_group=self.group,
        )

    def on_odom(self, msg):
        self.position = msg.pose.pose.position.x

    def on_state(self, state):
        self.stalled = state.is_stalled
        if max(state.left_rpm, state.right_rpm) > 110.0:
            self.get_logger().info('near the limit')

    def on_goal(self, goal_request):
        limit = self.get_parameter('max_speed').value
        return GoalResponse.ACCEPT if goal_request.speed <= limit else GoalResponse.REJECT

    def on_cancel(self, goal_handle):
        return CancelResponse.ACCEPT

    def shift(self, gear):
        request = SetGear.Request()
        request.gear = gear
        future = self.gear_client.call_async(request)
        future.add_done_callback(self.on_shifted)

    def on_shifted(self, future):
        result = future.result()
        if not result.success:
            self.get_logger().error(result.message)

    def send_goal_pose(self, target):
        pose = PoseStamped()
        pose.header.stamp = self.get_clock().now().to_msg()
        pose.header.frame_id = 'map'
        pose.pose.position.x = target
        pose.pose.orientation.w = 1.0
        self.goal_pub.publish(pose)

    def execute(self, goal_handle):
        goal = goal_handle.request
        if self.get_parameter('use_gears').value:
            self.shift(2)
        target = self.get_parameter('waypoints').value[-1]
        self.send_goal_pose(target)
        feedback = DriveRow.Feedback()
        command = Twist()
        while rclpy.ok() and self.position < target and not self.stalled:
            error = target - self.position
            command.linear.x = min(goal.speed, self.get_parameter('gain').value * error)
            self.cmd.publish(command)
            self.error_pub.publish(Float64(data=error))
            feedback.progress = self.position / target
            goal_handle.publish_feedback(feedback)
            time.sleep(0.1)
        self.cmd.publish(Twist())
        goal_handle.succeed()
        result = DriveRow.Result()
        result.reached = not self.stalled
        result.distance = self.position
        return result


def main(args=None):
    rclpy.init(args=args)
    node = RowDriver()
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    executor.spin()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
