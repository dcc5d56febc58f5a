#!/usr/bin/env python3
import math

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from orchard_interfaces.msg import MotorState
from orchard_interfaces.srv import SetGear
from rclpy.executors import ExternalShutdownException
from std_srvs.srv import Trigger

from orchard_driver.base import DeviceNode
from orchard_driver.names import CMD_VEL, MOTOR_STATE

MAX_RPM = 120.0


class MotorDriver(DeviceNode):
    def __init__(self):
        super().__init__('motor_driver', default_rate=20.0)
        self.declare_parameters(
            namespace='',
            parameters=[
                ('port', '/dev/ttyUSB0'),
                ('baud', 115200),
                ('wheel_radius', 0.165),
                ('wheel_names', ['left', 'right']),
                ('reverse', False),
            ],
        )
        self.radius = self.get_parameter('wheel_radius').get_parameter_value().double_value
        self.port = self.get_parameter('port').value
        self.gear = 1
        self.x = 0.0
        self.target = Twist()

        self.state_pub = self.create_publisher(MotorState, MOTOR_STATE, 10)
        self.odom_pub = self.create_publisher(Odometry, 'odom', 10)
        self.cmd_sub = self.create_subscription(Twist, CMD_VEL, self.on_cmd, 10)
        self.gear_srv = self.create_service(SetGear, 'set_gear', self.on_gear)
        self.stop_srv = self.create_service(Trigger, '~/stop', self.on_stop)

    def on_cmd(self, msg):
        self.target = msg
        if abs(msg.linear.x) > 1.5:
            self.get_logger().warn(f'too fast: {msg.linear.x:.2f} m/s')

    def on_gear(self, request, response):
        response.success = request.gear in (1, 2)
        if response.success:
            self.gear = request.gear
            response.message = f'gear {self.gear}'
        else:
            response.message = 'no such gear'
        return response

    def on_stop(self, request, response):
        self.target = Twist()
        response.success = True
        response.message = 'stopped'
        return response

    def poll(self):
        rpm = self.target.linear.x / (2 * math.pi * self.radius) * 60.0
        state = MotorState()
        state.stamp = self.get_clock().now().to_msg()
        state.left_rpm = min(rpm, MAX_RPM)
        state.right_rpm = min(rpm, MAX_RPM)
        state.temperatures = [31.5, 30.0]
        state.is_stalled = False
        self.state_pub.publish(state)

        self.x += self.target.linear.x * 0.05
        odom = Odometry()
        odom.header = self.header()
        odom.child_frame_id = 'base_footprint'
        odom.pose.pose.position.x = self.x
        odom.pose.pose.orientation.w = 1.0
        odom.twist.twist = self.target
        self.odom_pub.publish(odom)


def main(args=None):
    rclpy.init(args=args)
    node = MotorDriver()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
