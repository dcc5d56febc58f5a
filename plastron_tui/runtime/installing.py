"""The one command that installs what is missing, where there is such a command."""

from __future__ import annotations

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


def wheel(package: str) -> str | None:
    """Return the command that adds a ROS 2 package to the Python packages, None for none."""
    return f"pip install ros-{_dashed(package)}" if package in _WHEELS else None


def debian(package: str) -> str | None:
    """Return the command that adds a ROS 1 package to Debian's, None for none."""
    return f"sudo apt install python3-{_dashed(package)}" if package in _DEBIAN else None


def of_distribution(package: str, distribution: str) -> str | None:
    """Return the command that adds a package to a sourced ROS, None where its name is unknown."""
    if not distribution:
        return None
    return f"sudo apt install ros-{distribution}-{_dashed(package)}"


def _dashed(package: str) -> str:
    return package.replace("_", "-")
