import sys

import rclpy
from rclpy.node import Node


class Own(Node):
    def __init__(self):
        self.title = 'own'
        super().__init__(self.title)


class Constant(Node):
    NAME = 'constant'

    def __init__(self, **kwargs):
        super().__init__(self.NAME, **kwargs)


class ByClass(Node):
    def __init__(self):
        super().__init__(type(self).__name__.lower())


class TwoNames(Node):
    def __init__(self):
        if '--second' in sys.argv:
            super().__init__('second')
        else:
            super().__init__('first')


class Guarded(Node):
    def __init__(self):
        try:
            super().__init__('guarded')
        except rclpy.exceptions.InvalidNodeNameException:
            raise


class Keyword(Node):
    def __init__(self):
        super().__init__(namespace='ns', node_name='keyword')


class Argument(Node):
    def __init__(self, name):
        super().__init__(name)


class Late(Node):
    def __init__(self):
        self.values = [0]
        self.setup('ignored')
        Node.__init__(self, 'late')

    def setup(self, name):
        list.__init__(self.values, name)


def main():
    rclpy.init()
    for kind in (Own, Constant, ByClass, TwoNames, Guarded, Keyword, Late):
        rclpy.spin_once(kind(), timeout_sec=0.1)
