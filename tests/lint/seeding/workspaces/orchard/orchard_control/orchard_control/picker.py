import math

import rclpy
from geometry_msgs.msg import Point, PointStamped, Quaternion, Vector3
from orchard_interfaces.msg import ToolCommand
from rclpy.node import Node
from rclpy.parameter import Parameter
from sensor_msgs.msg import JointState
from std_msgs.msg import Float32MultiArray, Int32


def quaternion_of(yaw):
    return Quaternion(x=0.0, y=0.0, z=math.sin(yaw / 2), w=math.cos(yaw / 2))


class Picker(Node):
    JOINTS = ['shoulder', 'elbow', 'wrist']

    def __init__(self, **options):
        super().__init__('picker', **options)
        self.declare_parameter('arm.reach', 0.9)
        self.declare_parameter('arm.joints', self.JOINTS)
        self.declare_parameter('grip_force', Parameter.Type.DOUBLE)
        self.declare_parameter('dry_run', False)
        self.picked = 0
        self.angles = [0.0] * 3
        self.commands = self.create_subscription(
            msg_type=ToolCommand,
            topic='tool/command',
            callback=self.handle_command,
            qos_profile=10,
        )
        self.joints = self.create_publisher(JointState, 'joint_states', 10)
        self.tip = self.create_publisher(PointStamped, 'tool/tip', 10)
        self.forces = self.create_publisher(Float32MultiArray, 'tool/forces', 10)
        self.total = self.create_publisher(Int32, 'picked', 10)
        self.create_timer(0.1, self.publish_joints)

    def handle_command(self, command: ToolCommand):
        if command.command == ToolCommand.CLOSE and not self.get_parameter('dry_run').value:
            self.picked += len(command.fingers)
        self.total.publish(Int32(data=self.picked))
        self.forces.publish(Float32MultiArray(data=[command.force, command.force]))

    def publish_joints(self):
        state = JointState()
        state.header.stamp = self.get_clock().now().to_msg()
        state.name = self.JOINTS
        state.position = self.angles
        self.joints.publish(state)
        self.tip.publish(self.tip_at(Point(x=0.1, y=0.0, z=self.get_parameter('arm.reach').value)))

    def tip_at(self, point):
        tip = PointStamped()
        tip.header.frame_id = 'arm_base'
        tip.header.stamp = self.get_clock().now().to_msg()
        tip.point = point
        return tip

    def offset(self):
        return Vector3(x=0.0, y=0.05, z=0.0)


def main(args=None):
    rclpy.init(args=args)
    with_overrides = Picker()
    rclpy.spin(with_overrides)
    rclpy.shutdown()
