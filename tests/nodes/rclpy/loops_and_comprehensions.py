from functools import partial

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from std_srvs.srv import Empty


class Fleet(Node):
    def __init__(self, count: int = 3):
        super().__init__('fleet')
        self.names = [f'robot{i}' for i in range(count)]
        self.pubs = {name: self.create_publisher(Twist, f'/{name}/cmd_vel', 1) for name in self.names}
        self.subs = [
            self.create_subscription(
                Odometry, '/' + name + '/odom', partial(self.on_odom, name), 10)
            for name in self.names
            if not name.endswith('0')
        ]
        self.resets = []
        for i, name in enumerate(self.names):
            reset = self.create_client(Empty, '/{}/reset'.format(name))
            self.resets.append(reset)
            if i == 0:
                continue
            self.create_timer(0.1 * i, lambda name=name: self.drive(name))
        self.periods = tuple(self.get_parameter(key) for key in self.names)

    def on_odom(self, name, msg):
        self.get_logger().info(name)

    def drive(self, name):
        self.pubs[name].publish(Twist())


def main():
    rclpy.init()
    rclpy.spin(Fleet())
