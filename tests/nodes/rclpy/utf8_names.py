# -*- coding: utf-8 -*-
"""机器人 — robot ✓ 🤖"""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

ГОРОД = 'moscow'


class Робот(Node):
    def __init__(self):
        super().__init__('robot')
        self.издатель = self.create_publisher(String, f'/{ГОРОД}/привет', 1)
        print('🤖🤖'); self.таймер = self.create_timer(1.0, self.тик)

    def тик(self):
        self.издатель.publish(String(data='你好'))


rclpy.init()
rclpy.spin(Робот())
