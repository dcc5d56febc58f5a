#!/usr/bin/env python3
# vim: set fileencoding=iso-8859-1 :
# Zählt die Türen, © Jürgen
import rclpy
from std_msgs.msg import String

rclpy.init()
knoten = rclpy.create_node('tueren')
größe = knoten.declare_parameter('größe', 3).value
öffnen = knoten.create_publisher(String, 'oeffnen', 1)
öffnen.publish(String(data='é')); zählen = knoten.create_subscription(String, 'zaehlen', öffnen.zähle, 1)
