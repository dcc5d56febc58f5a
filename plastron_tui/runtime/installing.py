"""The one command that installs what is missing, where there is such a command."""

from __future__ import annotations

from plastron_tui.ros.catalog.distributions import EXTRA_DISTRIBUTION
from plastron_tui.ros.installations import rclpy_of_distribution

_EXTRAS = {EXTRA_DISTRIBUTION: "ros2", "jazzy": "ros2-jazzy"}
"""The extra of this package that brings a distribution of ROS 2."""

# The interface packages that have a wheel, and those that Debian packages for Python: others
# have to be built from their definitions, or come with a whole ROS.
_WHEELS = frozenset(
    [
        "action_msgs",
        "actionlib_msgs",
        "builtin_interfaces",
        "diagnostic_msgs",
        "geometry_msgs",
        "lifecycle_msgs",
        "nav_msgs",
        "rcl_interfaces",
        "rmw_fastrtps_cpp",
        "rosgraph_msgs",
        "sensor_msgs",
        "service_msgs",
        "shape_msgs",
        "std_msgs",
        "std_srvs",
        "stereo_msgs",
        "test_msgs",
        "trajectory_msgs",
        "type_description_interfaces",
        "unique_identifier_msgs",
        "visualization_msgs",
    ]
)
_DEBIAN = frozenset(
    [
        "actionlib_msgs",
        "diagnostic_msgs",
        "geometry_msgs",
        "map_msgs",
        "move_base_msgs",
        "nav_msgs",
        "pcl_msgs",
        "rosgraph_msgs",
        "roslaunch",
        "rosmaster",
        "sensor_msgs",
        "shape_msgs",
        "std_msgs",
        "std_srvs",
        "stereo_msgs",
        "tf2_msgs",
        "trajectory_msgs",
        "visualization_msgs",
    ]
)


def extra(distribution: str = EXTRA_DISTRIBUTION) -> str:
    """Return the command that installs a ROS 2 as Python packages.

    It is that of another distribution where there are no wheels of this one.
    """
    return f"pip install 'plastron-tui[{_EXTRAS.get(distribution, 'ros2')}]'"


def wheel(package: str, distribution: str = EXTRA_DISTRIBUTION) -> str | None:
    """Return the command that adds a ROS 2 package to the Python packages, None for none.

    The newest wheel is not that of an older distribution: the version of rclpy chooses it.
    """
    if package not in _WHEELS:
        return None
    command = f"pip install ros-{_dashed(package)}"
    rclpy = rclpy_of_distribution(distribution)
    if not rclpy or distribution == EXTRA_DISTRIBUTION:
        return command
    return f"{command} 'ros-rclpy=={rclpy}.*'"


def debian(package: str) -> str | None:
    """Return the command that adds a ROS 1 package to Debian's, None for none."""
    return f"sudo apt install python3-{_dashed(package)}" if package in _DEBIAN else None


def debian_definitions(package: str) -> str | None:
    """Return Debian's package with the definitions of a ROS 1 package, None for none."""
    return f"ros-{_dashed(package)}" if package in _DEBIAN else None


def of_distribution(package: str, distribution: str) -> str | None:
    """Return the command that adds a package to a sourced ROS, None where its name is unknown."""
    if not distribution:
        return None
    return f"sudo apt install ros-{distribution}-{_dashed(package)}"


def _dashed(package: str) -> str:
    return package.replace("_", "-")


_DEBIAN_HEADERS = {
    "dynamic_reconfigure": ("libdynamic-reconfigure-config-init-mutex-dev",),
    "nodelet": ("libnodeletlib-dev",),
    "pluginlib": ("pluginlib-dev",),
}
"""The packages of Debian with what code is built with, where their names follow no rule."""


def debian_headers(package: str) -> tuple[str, ...]:
    """Return Debian's packages with what code is built with that uses a ROS 1 package."""
    return _DEBIAN_HEADERS.get(package, (f"lib{_dashed(package)}-dev",))
