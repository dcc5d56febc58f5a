"""What is written in Python: nodes of rospy and of rclpy, from templates or from each other."""
