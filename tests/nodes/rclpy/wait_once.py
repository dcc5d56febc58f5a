import rclpy
from nav_msgs.msg import OccupancyGrid
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('wait_once')
    ok, grid = wait_for_message(OccupancyGrid, node, '/map', time_to_wait=5.0)
    ok, text = wait_for_message(msg_type=String, node=node, topic='text')
    print(ok, grid, text)


if __name__ == '__main__':
    main()
