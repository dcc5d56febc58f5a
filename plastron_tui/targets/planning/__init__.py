"""The plan of a node's file: what is in it, whatever language it is written in."""

from .planner import plan_parts, summary

__all__ = ["plan_parts", "summary"]
