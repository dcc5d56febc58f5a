"""What ROS knows: graph names, interface types and their fields, primitive values."""
