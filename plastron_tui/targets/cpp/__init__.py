"""The targets that are written in C++: roscpp, nodelet, rclcpp and component."""
