"""Whether all that creates the endpoints of a unit's nodes is read with its files."""

from __future__ import annotations

import re

from plastron_tui.sources.cpp.analysis import Analysis

from .whole_parameters import is_defined, is_handed_out, knows_bases

_KNOWN = frozenset(
    {
        "Eigen", "actionlib", "angles", "boost", "cv_bridge", "dynamic_reconfigure", "eigen3",
        "eigen_conversions", "laser_geometry", "linux", "octomap", "pcl_ros",
        "image_transport", "message_filters", "nodelet", "opencv", "opencv2", "pcl",
        "pcl_conversions", "pluginlib", "ros", "sys", "tf", "tf2", "tf2_geometry_msgs", "tf2_ros",
        "tf_conversions", "yaml-cpp",
        *("assert.h", "ctype.h", "errno.h", "fcntl.h", "float.h", "getopt.h", "inttypes.h"),
        *("limits.h", "math.h", "pthread.h", "signal.h", "stdarg.h", "stdbool.h", "stdint.h"),
        *("stdio.h", "stdlib.h", "string.h", "strings.h", "termios.h", "time.h", "unistd.h"),
    }
)  # fmt: skip
"""Where the headers lie whose classes create no endpoint of ROS 1 that a reader does not see."""
_TYPES = ("_msgs", "_srvs", "_interfaces", "_actions")


def is_closed(analysis: Analysis) -> bool:
    """Tell whether no other code may create an endpoint of a node of the files.

    So it is not where a class has a base, or a method, that is not read, where a node is given to
    what the files do not define, or where a part of them does not parse.
    """
    unit = analysis.unit
    if any(file.syntax.errors for file in unit.files):
        return False
    for node in analysis.nodes:
        if node.owner is not None and not is_defined(analysis, node.owner):
            return False
        is_of_ros2 = analysis.ros_version == 2
        if is_of_ros2 and node.owner is not None and not knows_bases(analysis, node.owner):
            return False
    if analysis.ros_version == 1:
        # Any object may make a node handle of its own.
        return has_known_headers(analysis)
    return not any(is_handed_out(analysis, file) for file in unit.files)


def has_known_headers(analysis: Analysis) -> bool:
    """Tell whether each header is read, or is one of those that create nothing unseen."""
    return not any(is_unknown(analysis, path) for path in unread_headers(analysis))


def is_unknown(analysis: Analysis, path: str) -> bool:
    """Tell whether a header that is not read may have a class that does more than is seen."""
    first = path.partition("/")[0]
    return not (first in _KNOWN or first.endswith(_TYPES) or _is_of_type(analysis, path))


def _is_of_type(analysis: Analysis, path: str) -> bool:
    """Tell whether a header is that of a message, `pkg/Name.h`, as the code uses the name."""
    package, _, last = path.rpartition("/")
    if not package or not last.endswith(".h"):
        return False
    name = re.escape(last.removesuffix(".h").encode())
    word = re.compile(
        rb"\b%s::%s\b|\b%s(?:(?:Const)?Ptr\b|::(?:Const)?Ptr\b|::Request\b)|<\s*%s\s*>"
        % (re.escape(package.encode()), name, name, name)
    )
    return last.endswith("Config.h") or any(
        word.search(file.syntax.code) for file in analysis.unit.files
    )


def unread_headers(analysis: Analysis) -> list[str]:
    """Return the headers that are included and not read, but for those of the language."""
    names = [file.name for file in analysis.unit.files[1:]]
    read = {name.rpartition("/")[2] for name in names if "{" not in name}
    # Their names leave out the main file's stem, which nobody here knows.
    of_main = sum("{" in name for name in names)
    found: dict[str, None] = {}
    for file in analysis.unit.files:
        for include in file.syntax.includes:
            is_standard = "/" not in include.path and "." not in include.path
            if not is_standard and include.path.rpartition("/")[2] not in read:
                found[include.path] = None
    own = [path for path in found if _is_of_main(path, names)]
    if of_main and len({path.rpartition("/")[2] for path in own}) <= of_main:
        return [path for path in found if path not in own]
    return list(found)


def _is_of_main(path: str, names: list[str]) -> bool:
    """Tell whether an include may name a header that is called as the main file is."""
    for name in names:
        before, braces, after = name.rpartition("/")[2].partition("{}")
        last = path.rpartition("/")[2]
        if braces and last.startswith(before) and last.endswith(after):
            outer = path.rpartition("/")[0]
            return name.rpartition("/")[0].endswith(outer)
    return False
