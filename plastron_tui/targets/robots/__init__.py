"""Robots that are written new."""
