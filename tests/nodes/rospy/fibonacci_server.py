#!/usr/bin/env python
import rospy
import actionlib
import actionlib_tutorials.msg


class FibonacciAction(object):
    _feedback = actionlib_tutorials.msg.FibonacciFeedback()
    _result = actionlib_tutorials.msg.FibonacciResult()

    def __init__(self, name):
        self._action_name = name
        self._as = actionlib.SimpleActionServer(self._action_name, actionlib_tutorials.msg.FibonacciAction,
                                                execute_cb=self.execute_cb, auto_start=False)
        self._as.start()

    def execute_cb(self, goal):
        numbers = [0, 1]
        for _ in range(1, goal.order):
            if self._as.is_preempt_requested():
                self._as.set_preempted()
                return
            numbers.append(numbers[-1] + numbers[-2])
            self._feedback.sequence = numbers
            self._as.publish_feedback(self._feedback)
        self._result.sequence = numbers
        self._as.set_succeeded(self._result)


if __name__ == '__main__':
    rospy.init_node('fibonacci')
    server = FibonacciAction(rospy.get_name())
    rospy.spin()
