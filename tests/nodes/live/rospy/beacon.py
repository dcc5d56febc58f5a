#!/usr/bin/env python3
import rospy
from std_msgs.msg import Empty, String


def main():
    rospy.init_node('beacon')
    word = rospy.get_param('~word', 'here')
    hz = rospy.get_param('~hz', 25)
    status = rospy.Publisher('~status', String, queue_size=1)
    pong = rospy.Publisher('/beacon/pong', Empty, queue_size=1)
    rospy.Subscriber('/beacon/ping', Empty, lambda msg: pong.publish(msg))
    rate = rospy.Rate(hz)
    while not rospy.is_shutdown():
        status.publish(String(data=word))
        rate.sleep()


if __name__ == '__main__':
    try:
        main()
    except rospy.ROSInterruptException:
        pass
