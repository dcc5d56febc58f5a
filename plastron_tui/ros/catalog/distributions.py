"""The ROS distributions that the catalog knows."""

from __future__ import annotations

import os
from collections.abc import Mapping

DISTRIBUTIONS: dict[str, int] = {"noetic": 1, "humble": 2, "jazzy": 2, "kilted": 2}
"""The ROS version of each distribution, the oldest first."""

_DEFAULT = {1: "noetic", 2: "jazzy"}

# ROS 2 distributions that are not in the catalog; the catalog's nearest release stands in.
_OLDER_ROS2 = frozenset({"ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy", "galactic"})


def default_distribution(ros_version: int, environ: Mapping[str, str] = os.environ) -> str:
    """Return the distribution to use where nobody named one.

    The sourced `ROS_DISTRO` decides when it is of this ROS version. One of ROS 2 that the
    catalog does not have stands for the nearest that it has: the oldest for what came before
    it, the newest for anything else, such as `rolling`.
    """
    sourced = environ.get("ROS_DISTRO", "").strip().lower()
    known = [name for name, version in DISTRIBUTIONS.items() if version == ros_version]
    if sourced in known:
        return sourced
    is_ros2 = ros_version == 2 and environ.get("ROS_VERSION", "2").strip() == "2"
    if not sourced or sourced in DISTRIBUTIONS or not is_ros2:
        return _DEFAULT[ros_version]
    if sourced == "iron":
        return "jazzy"
    return known[0] if sourced in _OLDER_ROS2 else known[-1]
