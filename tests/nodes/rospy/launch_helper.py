#!/usr/bin/env python
"""Starts nodes with roslaunch's API and waits until they answer."""
import roslaunch
import rosnode
import rospy
from controller_manager_msgs.srv import LoadController, SwitchController
from std_msgs.msg import String

NAMESPACE = 'arm'


def start(package, kind, name):
    node = roslaunch.core.Node(package, kind, name=name, namespace=NAMESPACE)
    launch = roslaunch.scriptapi.ROSLaunch()
    launch.start()
    return launch.launch(node)


def controllers(names):
    manager = '/' + NAMESPACE + '/controller_manager'
    load = rospy.ServiceProxy(manager + '/load_controller', LoadController)
    switch = rospy.ServiceProxy('%s/switch_controller' % manager, SwitchController)
    for name in names:
        load(name)
    switch(start_controllers=names, stop_controllers=[], strictness=2)


if __name__ == '__main__':
    rospy.init_node('starter')
    rospy.set_param("robot_description", open('robot.urdf').read())
    process = start('robot_state_publisher', 'robot_state_publisher', 'state_publisher')
    controllers(rospy.get_param('~controllers'))
    rospy.Publisher('started', String, queue_size=1, latch=True).publish(str(rosnode.get_node_names()))
    rospy.spin()
