"""What several statements say about their slots."""

LIBRARY_HELP = (
    "rospy, roscpp or nodelet for ROS 1, rclpy, rclcpp or component for ROS 2; without it, the one "
    "that is in use"
)
CALLBACK_HELP = "the function that is called; made if the file has none of that name"
QOS_HELP = "how messages are to arrive; without it, all of them, the last 10 kept"
