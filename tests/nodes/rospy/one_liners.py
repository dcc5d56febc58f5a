import rospy; from std_msgs.msg import String, Bool; rospy.init_node('short')
if True: p = rospy.Publisher('p', String, queue_size=1); q = rospy.Publisher('q', Bool, queue_size=1)
class A: s = rospy.Subscriber('s', String, p.publish)
make = lambda topic: rospy.Publisher(topic, Bool, queue_size=1)
def start(pub=rospy.Publisher('start', Bool, queue_size=1)): pub.publish(True)
while not rospy.is_shutdown(): start(); rospy.sleep(1)
if (first := rospy.Publisher('first', Bool, queue_size=1)): first.publish(False)
assert rospy.get_param('~ready', True), 'not ready'
