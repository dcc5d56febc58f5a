import sys
import rclpy
import geometry_msgs.msg

if sys.platform == 'win32':
    import msvcrt
else:
    import termios
    import tty

KEYS = {'w': (1.0, 0.0), 's': (-1.0, 0.0), 'a': (0.0, 1.0), 'd': (0.0, -1.0)}


def get_key(settings):
    if sys.platform == 'win32':
        return msvcrt.getwch()
    tty.setraw(sys.stdin.fileno())
    key = sys.stdin.read(1)
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    return key


def main():
    settings = None if sys.platform == 'win32' else termios.tcgetattr(sys.stdin)
    rclpy.init()
    node = rclpy.create_node('teleop_twist_keyboard')
    pub = node.create_publisher(geometry_msgs.msg.Twist, 'cmd_vel', 10)
    stamped = node.declare_parameter('stamped', False).value
    if stamped:
        pub2 = node.create_publisher(geometry_msgs.msg.TwistStamped, 'cmd_vel_stamped', 10)
    try:
        while True:
            key = get_key(settings)
            if key == '\x03':
                break
            twist = geometry_msgs.msg.Twist()
            twist.linear.x, twist.angular.z = KEYS.get(key, (0.0, 0.0))
            pub.publish(twist)
    finally:
        pub.publish(geometry_msgs.msg.Twist())


if __name__ == '__main__':
    main()
