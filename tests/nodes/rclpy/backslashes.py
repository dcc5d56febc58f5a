import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import Float32


class Lift(Node):
    def __init__(self):
        super().__init__( \
            'lift')
        self.declare_parameters('', [ \
            ('floors', \
             5), \
            ( \
                'speed', 1.0),
        ])
        self.server = ActionServer(self, Fibonacci,\
                 'go_to_floor', goal_callback=self.on_goal, \
            execute_callback=self.execute, \
                cancel_callback=self.on_cancel)
        self.height = \
            self.create_publisher( \
                Float32, \
                'height', \
                10)
        self.create_subscription(Float32, \
            'wanted', self.on_wanted, \
            10)
        self.create_timer( \
            0.1, \
            self.tick)


rclpy.init()
rclpy.spin( \
    Lift())
