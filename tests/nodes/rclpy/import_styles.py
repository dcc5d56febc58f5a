import rclpy, rclpy.action as action
import std_msgs.msg
import std_msgs.msg as sm, nav_msgs.srv
from std_msgs import msg
from geometry_msgs import msg as geo
from std_srvs import srv
from rclpy import node as ros_node, create_node as make
from sensor_msgs.msg import (
    Image,        # pictures
    LaserScan as Scan,
)
from example_interfaces.srv import AddTwoInts as Add; from example_interfaces import action as actions
from actionlib_msgs.msg._goal_id import GoalID


class Imports(ros_node.Node):
    def __init__(self):
        super().__init__('imports')
        self.a = self.create_publisher(std_msgs.msg.String, 'a', 1)
        self.b = self.create_publisher(sm.Int32, 'b', 1)
        self.c = self.create_publisher(msg.Bool, 'c', 1)
        self.d = self.create_publisher(geo.Pose, 'd', 1)
        self.e = self.create_publisher(Image, 'e', 1)
        self.f = self.create_publisher(Scan, 'f', 1)
        self.g = self.create_publisher(GoalID, 'g', 1)
        self.h = self.create_client(srv.Empty, 'h')
        self.i = self.create_client(nav_msgs.srv.GetMap, 'i')
        self.j = self.create_client(Add, 'j')
        self.k = action.ActionClient(self, actions.Fibonacci, 'k')


def main():
    rclpy.init()
    node = make('made')
    node.create_publisher(msg.Empty, 'l', 1)
