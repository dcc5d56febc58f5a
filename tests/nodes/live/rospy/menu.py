#!/usr/bin/env python3
import json

import rospy
from std_msgs.msg import String, UInt32

PRICES = {"tea": 2, "cake": 3}


class Menu:
    def __init__(self):
        self.orders = {}
        self.bill = rospy.Publisher("bill", String, queue_size=1)
        self.sum = rospy.Publisher("sum", UInt32, queue_size=1)
        for dish in sorted(PRICES):
            rospy.Subscriber("order/" + dish, String, self.order, callback_args=dish)

    def order(self, msg, dish):
        self.orders.setdefault(msg.data, []).append(dish)
        self.bill.publish(json.dumps(self.orders, sort_keys=True))
        self.sum.publish(sum(PRICES[d] for each in self.orders.values() for d in each))


if __name__ == "__main__":
    rospy.init_node("menu", anonymous=True)
    menu = Menu()
    rospy.spin()
