#!/usr/bin/env python3
"""Bridges MQTT and ZeroMQ to ROS: three libraries that all have publishers."""
import paho.mqtt.client as mqtt
import rospy
import zmq
from std_msgs.msg import String

from telemetry import Publisher, Subscriber as TelemetrySubscriber
from webhooks import Service


class Timer:
    """A stop watch, of this file."""

    def __init__(self, period, callback):
        self.period = period
        self.callback = callback


class Bridge:
    def __init__(self):
        self.context = zmq.Context()
        self.socket = self.context.socket(zmq.SUB)
        self.broker = mqtt.Client()
        self.broker.Publisher('mqtt/up', String)
        self.broker.subscribe('mqtt/down', 0)
        self.remote = Publisher('telemetry', String)
        self.local = TelemetrySubscriber('telemetry', String, self.down)
        self.hook = Service('hook', String, self.down)
        self.watch = Timer(rospy.Duration(1), self.down)
        self.up = rospy.Publisher('mqtt_up', String, queue_size=10)
        self.broker.get_param('~host', 'localhost')
        self.broker.on_message = self.down

    def down(self, *args):
        self.up.publish(String(str(args)))


if __name__ == '__main__':
    rospy.init_node('mqtt_bridge')
    bridge = Bridge()
    bridge.broker.loop_start()
    rospy.spin()
