#!/usr/bin/env python
import sys
import rospy
from beginner_tutorials.srv import AddTwoInts, AddTwoIntsRequest


def ask(x, y):
    rospy.wait_for_service('add_two_ints')
    try:
        call = rospy.ServiceProxy('add_two_ints', AddTwoInts)
        return call(AddTwoIntsRequest(x, y)).sum
    except rospy.ServiceException as e:
        print("call failed: %s" % e)


class Asker(object):
    def __init__(self):
        self.fast = rospy.ServiceProxy(
            service_class=AddTwoInts,
            persistent=True,
            name="/math/add")

    def ask(self, a, b):
        return self.fast(a=a, b=b)


if __name__ == "__main__":
    print(ask(int(sys.argv[1]), int(sys.argv[2])))
