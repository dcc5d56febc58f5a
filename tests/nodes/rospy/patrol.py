#!/usr/bin/env python3
"""Drives from goal to goal with move_base."""
from actionlib import SimpleActionClient, SimpleActionServer, GoalStatus
import actionlib as al
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from patrol_msgs.msg import PatrolAction
import rospy

GOALS = [(1.0, 0.0), (1.0, 1.0), (0.0, 0.0)]


class Patrol:
    def __init__(self):
        self.base = SimpleActionClient('move_base', MoveBaseAction)
        self.dock = al.SimpleActionClient(ns='dock', ActionSpec=MoveBaseAction)
        self.server = SimpleActionServer('patrol', PatrolAction, auto_start=False)
        self.server.register_goal_callback(self.on_goal)
        self.other = al.SimpleActionServer('patrol_once', PatrolAction, self.once, False)
        self.server.start()
        self.other.start()

    def on_goal(self):
        self.server.accept_new_goal()
        for x, y in GOALS:
            self.drive(x, y)
        self.server.set_succeeded()

    def once(self, goal):
        self.drive(*GOALS[0])
        self.other.set_succeeded()

    def drive(self, x, y):
        goal = MoveBaseGoal()
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x = x
        goal.target_pose.pose.position.y = y
        self.base.send_goal_and_wait(goal)
        return self.base.get_state() == GoalStatus.SUCCEEDED


if __name__ == '__main__':
    rospy.init_node(name='patrol')
    Patrol()
    rospy.spin()
