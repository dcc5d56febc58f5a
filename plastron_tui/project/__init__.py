"""What is around a program: its settings, the ROS that it is for, what it loads, its files."""
