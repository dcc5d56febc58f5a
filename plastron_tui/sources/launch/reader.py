"""Launch files in whatever they are written in, as their names tell."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from plastron_tui.regular_files import read_regular, reason
from plastron_tui.ros.launch_names import launch_language
from plastron_tui.ros.launch_started import Opened

from .python_reader import read_launch_python
from .xml_reader import LaunchRead, read_launch_xml

LARGEST = 2_000_000
"""In bytes: far more than any launch file that people write."""


def is_launch_file(file: Path) -> bool:
    """Tell whether a file is a launch file, as its name tells."""
    return launch_language(file.name) is not None


def read_launch(source: bytes, file: Path) -> LaunchRead:
    """Read a launch file; one whose name tells nothing is XML."""
    language = launch_language(file.name)
    if language == "py":
        return read_launch_python(source, file)
    if language == "yaml":
        from .yaml_reader import read_launch_yaml

        return read_launch_yaml(source, file)
    # Where the words of a file are those of both, `*.launch.xml` is of ROS 2 (its documentation).
    return read_launch_xml(source, file)


def open_included(path: Path, beyond: Callable[[Path], str]) -> Opened:
    """Read a launch file that another one includes, or say why it is left out.

    Args:
        path: the file.
        beyond: says why a file may not be read, "" where it may.
    """
    if not path.is_absolute():
        return Opened(None, 2, "", "its path has to be a whole one")
    why = beyond(path)
    if why:
        return Opened(None, 2, "", why)
    try:
        source = read_regular(path, LARGEST)
    except (OSError, ValueError) as error:
        return Opened(None, 2, "", reason(error))
    read = read_launch(source, path)
    if read.launch is None:
        why = read.diagnostics[0].message if read.diagnostics else "it is no launch file"
        return Opened(None, 2, "", why)
    return Opened(read.launch, read.format.ros_version, str(path.parent))


def file_content(path: str, beyond: Callable[[Path], str]) -> str | None:
    """Return the text of a file that a launch file wants to have, None where it may not be read.

    Args:
        path: the file.
        beyond: says why a file may not be read, "" where it may.
    """
    file = Path(path)
    if not file.is_absolute() or beyond(file):
        return None
    try:
        return read_regular(file, LARGEST).decode()
    except (OSError, ValueError):
        return None
