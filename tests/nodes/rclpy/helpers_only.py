"""Helpers for nodes; holds nothing of its own."""
from __future__ import annotations

import rclpy
from rclpy.duration import Duration
from rclpy.time import Time


def older(clock, stamp, seconds: float) -> bool:
    """Tell whether the stamp is too old: node.create_timer(…) would not."""
    return clock.now() - Time.from_msg(stamp) > Duration(seconds=seconds)


def spin(node) -> None:
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.1)
