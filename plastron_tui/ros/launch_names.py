"""How the names of launch files end, and what they are in.

From the ROS 2 documentation, "Creating a launch file" (`NAME_launch.py`, `.xml` and `.yaml`), and
the ROS wiki, "roslaunch/XML" (`NAME.launch`); people write a dot or a hyphen for the underscore as
well.
"""

from __future__ import annotations

from collections.abc import Mapping

LAUNCH_ENDINGS: Mapping[str, str] = {
    ".launch": "xml",
    ".launch.xml": "xml",
    "_launch.xml": "xml",
    "-launch.xml": "xml",
    ".launch.py": "py",
    "_launch.py": "py",
    "-launch.py": "py",
    ".launch.yaml": "yaml",
    ".launch.yml": "yaml",
    "_launch.yaml": "yaml",
    "-launch.yaml": "yaml",
    "_launch.yml": "yaml",
}
"""The language of each ending: `xml`, `py` or `yaml`."""


def launch_language(name: str) -> str | None:
    """Return what a file is written in, None where its name is not one of a launch file."""
    return next((found for end, found in LAUNCH_ENDINGS.items() if name.endswith(end)), None)


def launch_stem(name: str) -> str:
    """Return the name of a launch file without its ending."""
    return next((name.removesuffix(end) for end in LAUNCH_ENDINGS if name.endswith(end)), name)
