"""Bringing a Python node that somebody wrote for one ROS to the other.

What makes the node and its endpoints is rewritten where it stands, and so is what means the same
in other words for sure: what rospy makes messages of by itself, plain logs, the time of a stamp.
Every other line is carried over as it is. A line that the other ROS would not understand gets a
comment, `# port by hand: …`, and a warning.
"""

from .port import port_python

__all__ = ["port_python"]
