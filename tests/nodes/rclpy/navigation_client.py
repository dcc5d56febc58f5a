import rclpy
import rclpy.action
from action_msgs.msg import GoalStatus
from nav2_msgs.action import FollowWaypoints, NavigateToPose
from rclpy.action import ActionClient as Client
from rclpy.node import Node


class Navigator(Node):
    def __init__(self):
        super().__init__('navigator')
        self.to_pose = rclpy.action.ActionClient(self, NavigateToPose, 'navigate_to_pose')
        self.follow = Client(node=self, action_type=FollowWaypoints, action_name='follow_waypoints')
        self.relay = rclpy.action.ActionServer(self, NavigateToPose, 'relay', self.relay_goal)

    def go(self, pose):
        goal = NavigateToPose.Goal(pose=pose)
        self.to_pose.wait_for_server()
        future = self.to_pose.send_goal_async(goal, feedback_callback=self.feedback)
        future.add_done_callback(self.accepted)

    def feedback(self, message):
        self.get_logger().info(str(message.feedback.distance_remaining))

    def accepted(self, future):
        handle = future.result()
        if handle.accepted:
            handle.get_result_async().add_done_callback(
                lambda f: f.result().status == GoalStatus.STATUS_SUCCEEDED)

    def relay_goal(self, handle):
        self.go(handle.request.pose)
        handle.succeed()
        return NavigateToPose.Result()


def main():
    rclpy.init()
    navigator = Navigator()
    spare = Client(navigator, NavigateToPose, 'spin')
    rclpy.spin(navigator)
