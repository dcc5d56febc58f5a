#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from rclpy.executors import ExternalShutdownException
from geometry_msgs.msg import Twist
from std_msgs.msg import Float32, Bool


class CruiseControl(Node):
    def __init__(self):
        super().__init__('cruise')
        self.declare_parameter('max_speed', 2.0)
        self.maxSpeed = self.get_parameter('max_speed').value
        self.speed = 0.0
        self.cmdPub = self.create_publisher(Twist, '/cruise/cmd_vel', 10)
        self.limitPub = self.create_publisher(Bool, '/cruise/limited', 10)
        self.speedSub = self.create_subscription(Float32, 'speed', self.speedCallback, 10)
        self.timer = self.create_timer(0.02, self.timerCallback)

    def speedCallback(self, msg):
        self.speed = min(msg.data, self.maxSpeed)
        self.limitPub.publish(Bool(data=msg.data > self.maxSpeed))

    def timerCallback(self):
        cmd = Twist()
        cmd.linear.x = self.speed
        self.cmdPub.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    node = CruiseControl()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        if rclpy.ok():
            rclpy.shutdown()


if __name__ == '__main__':
    main()
