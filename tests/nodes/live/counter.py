#!/usr/bin/env python3
from std_msgs.msg import *
from std_srvs.srv import Trigger, TriggerResponse
from rospy import init_node, Publisher, Service, Subscriber, spin

ticks = 0
total = None


def on_tick(message):
    global ticks
    ticks += 1
    total.publish(ticks)


def reset(_):
    global ticks
    ticks = 0
    return TriggerResponse(success=True, message="back to 0")


def main():
    global total
    init_node("counter")
    total = Publisher("total", Int32, queue_size=5)
    Subscriber("tick", Empty, on_tick)
    Service("reset", Trigger, reset)
    spin()


if __name__ == "__main__":
    main()
