import rclpy
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import Int8, String

NAME = 'second'


def main():
    rclpy.init()
    first = Node('first')
    second = Node(NAME, use_global_arguments=False)
    third = LifecycleNode(node_name='third')
    fourth = rclpy.node.Node(f'{first.get_name()}_fourth')
    a = first.create_publisher(Int8, 'a', 1)
    b = second.create_publisher(Int8, 'b', 1)
    c = third.create_lifecycle_publisher(String, 'c', 1)
    d = fourth.create_subscription(String, 'd', lambda m: None, 1)
    for node in (first, second, third, fourth):
        rclpy.spin_once(node, timeout_sec=0.1)
