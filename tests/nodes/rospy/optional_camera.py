#!/usr/bin/env python
import contextlib
import rospy
from sensor_msgs.msg import CameraInfo, Image
from std_srvs.srv import SetBool

try:
    from dynamic_reconfigure.server import Server
except ImportError:
    Server = None

rospy.init_node('optional_camera')


@contextlib.contextmanager
def publisher(topic, kind):
    pub = rospy.Publisher(topic, kind, queue_size=1)
    yield pub
    pub.unregister()


if rospy.get_param('~depth', False):
    depth = rospy.Publisher('depth', Image, queue_size=1)
elif rospy.get_param('~color', True):
    depth = rospy.Publisher('color', Image, queue_size=1)
else:
    depth = None

try:
    calibration = rospy.wait_for_message('camera_info', CameraInfo, 2)
except rospy.ROSException:
    calibration = None
finally:
    power = rospy.ServiceProxy('power', SetBool)

with publisher('debug', Image) as debug, open('/dev/null') as null:
    latest = rospy.Subscriber('image', Image, debug.publish)
    while not rospy.is_shutdown():
        with contextlib.suppress(rospy.ROSInterruptException):
            rospy.sleep(1)
        ok = power(True) if depth else None
