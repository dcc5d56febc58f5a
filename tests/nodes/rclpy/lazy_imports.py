"""ROS is imported when it is needed, and perhaps it is not there."""
import sys

try:
    import rclpy
    from sensor_msgs.msg import Joy
except ImportError:
    rclpy = None
    Joy = None

N = 7


class Pad:
    def __init__(self, name: str = 'pad') -> None:
        from rclpy.node import Node

        self._node: 'Node' = rclpy.create_node(name)
        self._node.create_subscription(Joy, f'joy{N}', self.on_joy, 10)
        self._node.create_publisher(Joy, f'{N=}', 10)

    def on_joy(self, joy):
        print(joy)


def main():
    if rclpy is None:
        return 1
    rclpy.init()
    pad = Pad()
    rclpy.spin(pad._node)


if __name__ == '__main__':
    sys.exit(main())
