#!/usr/bin/env python
import rospy
from trajectory_msgs.msg import JointTrajectory
from control_msgs.srv import (QueryTrajectoryState,
                              QueryCalibrationState)

rospy.init_node(
    'spread',
    anonymous=True
)

trajectories = \
    rospy \
    .Publisher(
        # where the controller listens
        'arm_controller/command',

        JointTrajectory,  # what it takes
        queue_size=(
            1
        ),
    )

state = (
    rospy.ServiceProxy(
        'arm_controller/'
        'query_state',
        QueryTrajectoryState,
    )
)
calibration = [
    rospy
    .ServiceProxy(
        ('calibration'), (QueryCalibrationState)
    ),
][0]
