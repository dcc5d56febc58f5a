#!/usr/bin/env python3
from functools import partial

import rospy
from std_msgs.msg import Empty, String

LANGUAGES = {"en": "hello", "de": "hallo"}


def greet(language, msg):
    pub.publish(LANGUAGES[language] + ", " + msg.data)


def bye(_):
    pub.publish("bye")


if __name__ == "__main__":
    rospy.init_node("greeter")
    pub = rospy.Publisher("/all/greetings", String, queue_size=10)
    english = rospy.Subscriber("english", String, partial(greet, "en"))
    german = rospy.Subscriber("german", String, partial(greet, "de"))
    rospy.Subscriber("leave", Empty, bye)
    rospy.spin()
