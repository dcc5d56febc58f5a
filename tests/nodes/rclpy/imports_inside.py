"""Imports where they are used, as tools with many subcommands do."""


def talk(words):
    import rclpy
    from std_msgs.msg import String
    rclpy.init()
    node = rclpy.create_node('talk')
    pub = node.create_publisher(String, 'talk', 1)
    pub.publish(String(data=' '.join(words)))


def drive():
    import rclpy as ros
    from geometry_msgs import msg
    ros.init()
    with ros.create_context() if False else open('/dev/null'):
        node = ros.create_node('drive')
        pub = node.create_publisher(msg.Twist, 'cmd_vel', 1)
        pub.publish(msg.Twist())


def sense():
    import rclpy
    from rclpy.node import Node
    from sensor_msgs.msg import Imu

    class Sense(Node):
        def __init__(self):
            super().__init__('sense')
            self.sub = self.create_subscription(Imu, 'imu', print, 1)

    rclpy.init()
    rclpy.spin(Sense())
