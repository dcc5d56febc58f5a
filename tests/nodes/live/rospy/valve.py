#!/usr/bin/env python3
import rospy
from std_msgs.msg import Bool, Float64
from std_srvs.srv import SetBool, Trigger


def set_valve(request):
    global is_open
    is_open = request.data
    state.publish(is_open)
    return {'success': True, 'message': 'opened' if is_open else 'closed'}


def ask(request):
    return is_open, 'open' if is_open else 'shut'


def on_pressure(msg):
    if msg.data > limit and is_open:
        rospy.logerr('pressure %.1f is too high', msg.data)
        set_closed()
    flow.publish(msg.data * 2 if is_open else 0)


def set_closed():
    global is_open
    is_open = False
    state.publish(False)


if __name__ == '__main__':
    rospy.init_node('valve')
    is_open = True
    limit = rospy.get_param('~limit', 5.0)
    state = rospy.Publisher('valve/open', Bool, queue_size=10)
    flow = rospy.Publisher('valve/flow', Float64, queue_size=10)
    rospy.Service('valve/set', SetBool, set_valve)
    rospy.Service('valve/ask', Trigger, ask)
    rospy.Subscriber('pressure', Float64, on_pressure)
    rospy.spin()
