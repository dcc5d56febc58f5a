import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Float32, String


class Window:
    """A window that owns a node instead of being one."""

    def __init__(self):
        if not rclpy.ok():
            rclpy.init()
        self.node = rclpy.create_node('window')
        self.pub = self.node.create_publisher(Float32, 'slider', 10)
        self.sub = None
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        threading.Thread(target=self.executor.spin, daemon=True).start()

    def connect(self, topic):
        if self.sub is not None:
            self.node.destroy_subscription(self.sub)
        self.sub = self.node.create_subscription(String, topic, self.show, 10)

    def show(self, msg):
        print(msg.data)

    def moved(self, value):
        self.pub.publish(Float32(data=value))


if __name__ == '__main__':
    Window().connect('labels')
