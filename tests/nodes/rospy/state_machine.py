#!/usr/bin/env python
import rospy
import smach
import smach_ros
from std_msgs.msg import Empty, String


class Idle(smach.State):
    def __init__(self):
        smach.State.__init__(self, outcomes=['go', 'preempted'])
        self.started = False
        self.sub = rospy.Subscriber('/start', Empty, self.start)

    def start(self, _):
        self.started = True

    def execute(self, userdata):
        while not self.started:
            if self.preempt_requested():
                return 'preempted'
            rospy.sleep(0.1)
        return 'go'


class Say(smach.State):
    def __init__(self, what):
        smach.State.__init__(self, outcomes=['done'])
        self.what = what
        self.pub = rospy.Publisher('/say', String, queue_size=1)

    def execute(self, userdata):
        self.pub.publish(self.what)
        return 'done'


def main():
    rospy.init_node('greeter')
    sm = smach.StateMachine(outcomes=['end'])
    with sm:
        smach.StateMachine.add('IDLE', Idle(), transitions={'go': 'SAY', 'preempted': 'end'})
        smach.StateMachine.add('SAY', Say('hello'), transitions={'done': 'end'})
    server = smach_ros.IntrospectionServer('greeter', sm, '/SM_ROOT')
    server.start()
    sm.execute()
    server.stop()


if __name__ == '__main__':
    main()
