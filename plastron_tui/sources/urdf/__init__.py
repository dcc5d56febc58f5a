"""Robots that exist: URDF, and xacro by its XML alone; read, and changed in place."""
