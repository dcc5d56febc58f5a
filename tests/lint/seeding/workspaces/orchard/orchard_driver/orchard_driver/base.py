from rclpy.node import Node
from std_msgs.msg import Header


class DeviceNode(Node):
    """What all nodes of devices have in common."""

    def __init__(self, name, default_rate=10.0):
        super().__init__(name)
        self.declare_parameter('rate', default_rate)
        self.declare_parameter('frame_id', 'base_link')
        rate = self.get_parameter('rate').value
        self.poll_timer = self.create_timer(1.0 / rate, self.poll)

    def poll(self):
        raise NotImplementedError

    def header(self):
        header = Header()
        header.stamp = self.get_clock().now().to_msg()
        header.frame_id = self.get_parameter('frame_id').value
        return header
