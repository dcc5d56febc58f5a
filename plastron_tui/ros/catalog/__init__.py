"""The interface types of each ROS distribution, read from YAML when first needed."""
