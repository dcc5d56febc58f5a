#!/usr/bin/env python3
"""Median filter over the last scans."""
from collections import deque
from statistics import median
from typing import Deque, List

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from sensor_msgs.msg import LaserScan


class ScanFilter(Node):
    def __init__(self) -> None:
        super().__init__("scan_filter")
        self.declare_parameter(
            "window",
            5,
            ParameterDescriptor(
                description="how many scans",
                integer_range=[IntegerRange(from_value=1, to_value=50, step=1)],
            ),
        )
        self._window: int = self.get_parameter("window").value
        self._scans: Deque[List[float]] = deque(maxlen=self._window)
        self._sub = self.create_subscription(
            LaserScan, "scan", self._on_scan, qos_profile_sensor_data
        )
        self._pub = self.create_publisher(
            LaserScan,
            "scan_filtered",
            qos_profile=qos_profile_sensor_data,
        )

    def _on_scan(self, scan: LaserScan) -> None:
        self._scans.append(list(scan.ranges))
        scan.ranges = [median(beam) for beam in zip(*self._scans)]
        self._pub.publish(scan)


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(ScanFilter())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
