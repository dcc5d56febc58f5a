"""A driver that other nodes import; it starts no node of its own."""
import rospy
from sensor_msgs.msg import Range
from std_srvs.srv import Empty, EmptyResponse

_SERVICE = '~calibrate'


class Sonar(object):
    """One sonar."""

    def __init__(self, pin, frame='sonar'):
        self.pin = pin
        self.message = Range(min_range=rospy.get_param('~min', 0.02), max_range=4.0)
        self.message.header.frame_id = frame
        self.pub = rospy.Publisher('range', Range, queue_size=10)
        self.service = rospy.Service(_SERVICE, Empty, self.calibrate)

    def calibrate(self, request):
        return EmptyResponse()

    def measure(self):
        self.message.header.stamp = rospy.Time.now()
        self.pub.publish(self.message)
