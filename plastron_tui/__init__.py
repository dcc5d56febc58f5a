"""Plastron: an English-like language for ROS nodes, with a terminal studio."""

__version__ = "0.1.0"
