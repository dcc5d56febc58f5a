#!/usr/bin/env python3
import rospy
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

words = []

def add(msg):
    words.append(msg.data.strip())
    rospy.loginfo("%d words" % len(words))
    count_pub.publish(", ".join(words))

def flush(req):
    if not words:
        return TriggerResponse(False, "nothing to say")
    sentence = " ".join(words).capitalize() + "."
    del words[:]
    sentence_pub.publish(sentence)
    return TriggerResponse(True, sentence)

rospy.init_node("joiner")
count_pub = rospy.Publisher("words_so_far", String, queue_size=3)
sentence_pub = rospy.Publisher("sentence", String, queue_size=3, latch=True)
rospy.Subscriber("word", String, add)
rospy.Service("flush", Trigger, flush)
rospy.spin()
