"""Robots as URDF describes them.

Lengths are in metres, masses in kilograms, angles in radians, forces in newtons. Sources: the
specification (wiki.ros.org/urdf/XML), and what its parser takes (urdfdom: `link.cpp`,
`joint.cpp`, `pose.h`).
"""
