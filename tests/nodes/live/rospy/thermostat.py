#!/usr/bin/env python
import rospy
from std_msgs.msg import Bool, Float32

target = 20.0
measured = 15.0

def target_callback(data):
    global target
    target = data.data

def measured_callback(data):
    global measured
    measured = data.data

def thermostat():
    pub = rospy.Publisher('heating', Bool, queue_size=10)
    error_pub = rospy.Publisher('error', Float32, queue_size=10)
    rospy.init_node('thermostat', anonymous=False)
    rospy.Subscriber('target', Float32, target_callback)
    rospy.Subscriber('measured', Float32, measured_callback)
    rate = rospy.Rate(50) # 50hz
    while not rospy.is_shutdown():
        pub.publish(measured < target)
        error_pub.publish(target - measured)
        rate.sleep()

if __name__ == '__main__':
    try:
        thermostat()
    except rospy.ROSInterruptException:
        pass
