"""Scripts for the Python of a ROS environment, which has no Plastron: each stands alone."""
