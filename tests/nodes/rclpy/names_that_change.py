import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

TOPIC = 'one'
if '--two' in sys.argv:
    TOPIC = 'two'
MODE = 'slow'
GROWN = 'root'
GROWN += '/leaf'


def faster():
    global MODE
    MODE = 'fast'


class Changing(Node):
    KIND = 'class'
    SAME = 'same'

    def __init__(self, i, SAME):
        super().__init__(f'changing_{i}')
        self.topic = 'a'
        self.only = 'only'
        self.KIND = 'instance'
        self.late = None
        p = self.create_publisher(String, TOPIC, 1)
        q = self.create_publisher(String, MODE, 1)
        r = self.create_publisher(String, GROWN, 1)
        s = self.create_publisher(String, self.topic, 1)
        t = self.create_publisher(String, self.only, 1)
        u = self.create_publisher(String, self.KIND, 1)
        v = self.create_publisher(String, SAME, 1)
        x = self.create_publisher(String, 'x' if i else 'y', 1)
        y = self.create_publisher(String, self.SAME, 1)

    def move(self):
        self.topic = 'b'
        self.late = 'now'
        self.w = self.create_publisher(String, self.late, 1)


rclpy.init()
nodes = [Changing(i, 'not the same') for i in range(2)]
