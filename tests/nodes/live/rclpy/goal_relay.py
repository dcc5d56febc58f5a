import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Empty


class GoalRelay(Node):
    def __init__(self):
        super().__init__('goal_relay')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.goal = PoseStamped()
        self.goal.header.frame_id = 'map'
        self.pub = self.create_publisher(PoseStamped, 'goal', latched)
        self.done_pub = self.create_publisher(Empty, 'cancelled', 10)
        self.create_subscription(PoseStamped, 'goal_in', self.goal_callback, latched)
        self.create_subscription(Empty, 'cancel', self.cancel_callback, 10)

    def goal_callback(self, msg):
        self.goal = msg
        self.goal.header.stamp = self.get_clock().now().to_msg()
        self.pub.publish(self.goal)

    def cancel_callback(self, _):
        self.goal.pose.position.x = 0.0
        self.pub.publish(self.goal)
        self.done_pub.publish(Empty())


def main():
    rclpy.init()
    relay = GoalRelay()
    try:
        rclpy.spin(relay)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        relay.destroy_node()


if __name__ == '__main__':
    main()
