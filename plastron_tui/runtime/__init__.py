"""Real ROS: which one is there, its nodes as processes, and the graph that they make."""
