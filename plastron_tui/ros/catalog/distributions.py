"""The ROS distributions that the catalog knows, and which of them stands for another one."""

from __future__ import annotations

DISTRIBUTIONS: dict[str, int] = {"noetic": 1, "humble": 2, "jazzy": 2, "kilted": 2, "lyrical": 2}
"""The ROS version of each distribution, the oldest first."""

EXTRA_DISTRIBUTION = "kilted"
"""What the extra `ros2` brings: of Lyrical, the long-term release since, there are no wheels."""

# What is neither in the catalog nor among these, such as `rolling`, is newer, and of ROS 2.
_OTHER_ROS1 = frozenset({"hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "one"})
_OLDER_ROS2 = frozenset({"ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy", "galactic"})


def version_of_distribution(name: str) -> int:
    """Return the ROS version of a distribution, whether or not it is in the catalog."""
    return DISTRIBUTIONS.get(name) or (1 if name in _OTHER_ROS1 else 2)


def usual_distribution(ros_version: int) -> str:
    """Return the distribution that counts for a generation of ROS where nothing tells another.

    It is the one that can be had by one command: Debian's, and that of the extra `ros2`.
    """
    return "noetic" if ros_version == 1 else EXTRA_DISTRIBUTION


def stand_in(name: str, ros_version: int) -> str:
    """Return the catalog's distribution of a generation of ROS that is nearest to one by name.

    For what came before the catalog's it is the oldest, for anything else the newest.
    """
    known = [each for each, version in DISTRIBUTIONS.items() if version == ros_version]
    if name in known:
        return name
    if name == "iron" and "jazzy" in known:
        return "jazzy"
    return known[0] if name in _OLDER_ROS2 else known[-1]
