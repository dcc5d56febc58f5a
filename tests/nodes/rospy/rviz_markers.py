#!/usr/bin/env python
# A node grown over the years: every style at once.
import roslib; roslib.load_manifest('rviz_markers')
import sys, os, time
import rospy
from visualization_msgs.msg import *
from interactive_markers.interactive_marker_server import *
import tf.transformations as tft

server = None
pub_count=0

def processFeedback( feedback ):
    global pub_count
    p = feedback.pose.position
    print(feedback.marker_name + " is now at " + str(p.x))
    pub_count += 1
    if pub_count%10==0:  arr_pub.publish(MarkerArray())

def makeMarker( position, name = "marker" ) :
    int_marker = InteractiveMarker()
    int_marker.name = name
    server.insert(int_marker, processFeedback)

if __name__=="__main__":
    rospy.init_node("markers")
    arr_pub=rospy.Publisher("~array",MarkerArray,queue_size=1)
    one_pub  = rospy.Publisher ("~one", Marker, latch = True, queue_size = 1)
    server = InteractiveMarkerServer("markers")
    if len( sys.argv )>1 : rospy.set_param ( "~frame" , sys.argv[1] )
    frame=rospy.get_param("~frame","map") if len(sys.argv)<3 else sys.argv[2]
    tick=rospy.Timer(rospy.Duration(.01),frameCallback) if 'frameCallback' in globals() else None
    makeMarker( None )
    server.applyChanges()
    rospy.spin()
