import functools
import threading

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool

lock = threading.RLock()


def locked(function):
    @functools.wraps(function)
    def inner(*args, **kwargs):
        with lock:
            return function(*args, **kwargs)
    return inner


@functools.total_ordering
class Gripper(Node):
    def __init__(self):
        super().__init__('gripper')
        with lock:
            self.service = self.create_service(SetBool, 'grip', self.grip)
        try:
            self.joints = self.create_subscription(JointState, 'joint_states', self.on_joints, 1)
        except Exception as problem:
            self.get_logger().error(str(problem))
            raise
        else:
            self.declare_parameter('width', 0.08)

    @property
    def width(self):
        return self.get_parameter('width').value

    @functools.cached_property
    def pub(self):
        return self.create_publisher(JointState, 'gripped', 1)

    @locked
    def grip(self, request, response):
        response.success = request.data
        return response

    @staticmethod
    def on_joints(msg):
        print(msg.name)

    def __lt__(self, other):
        return self.width < other.width


rclpy.init()
rclpy.spin(Gripper())
