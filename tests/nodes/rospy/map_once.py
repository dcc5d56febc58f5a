#!/usr/bin/env python
"""Takes one map, writes it as an image, and leaves."""
import sys
import rospy
from nav_msgs.msg import OccupancyGrid, MapMetaData


def save(grid, path):
    with open(path, 'wb') as out:
        out.write(b'P5\n%d %d\n255\n' % (grid.info.width, grid.info.height))
        out.write(bytes(bytearray(254 if c == 0 else 0 if c == 100 else 205 for c in grid.data)))


if __name__ == '__main__':
    rospy.init_node('map_once')
    grid = rospy.wait_for_message('/map', OccupancyGrid, timeout=10.0)
    meta = rospy.wait_for_message(sys.argv[1], MapMetaData)
    save(grid, rospy.wait_for_message(topic='map_name', topic_type=type(grid)).info)
