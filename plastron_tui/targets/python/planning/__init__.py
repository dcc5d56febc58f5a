"""The plan of a Python file: a file for each group of what a node has."""

from .planner import Planner

__all__ = ["Planner"]
