import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    talker = rclpy.create_node('talker')
    listener = rclpy.create_node(node_name='listener')
    pub = talker.create_publisher(String, 'chatter', 10)
    sub = listener.create_subscription(String, 'chatter', lambda m: print(m.data), 10)
    timer = talker.create_timer(1.0, lambda: pub.publish(String(data='hi')))
    executor = rclpy.get_global_executor()
    executor.add_node(talker)
    executor.add_node(listener)
    while rclpy.ok():
        executor.spin_once()


def other():
    rclpy.init()
    node = rclpy.create_node('other')
    node.create_client(load('Reset'), 'reset')
    talker = node
    return talker


def load(name):
    import importlib
    return getattr(importlib.import_module('robot_interfaces.srv'), name)


if __name__ == '__main__':
    main()
