"""Launch files in XML, as people write them."""

from __future__ import annotations

from plastron_tui.ros.launch import Argument, Item, LaunchFile
from plastron_tui.sources.launch.new_elements import new_element
from plastron_tui.sources.xml.layout import Style
from plastron_tui.sources.xml.new_element import render

_STYLE = Style(b"\n", b"  ", '"', "/>")
_INDENT = b"  "


def write_xml(launch: LaunchFile, ros_version: int) -> str:
    """Return the text of a launch file.

    Raises:
        CannotWriteError: this generation of ROS has no words for something in it.
    """
    lines = [b'<?xml version="1.0"?>' if ros_version == 1 else b"", b"<launch>"]
    before: Item | None = None
    for item in launch.items:
        is_argument = isinstance(item, Argument)
        if before is not None and not (is_argument and isinstance(before, Argument)):
            lines.append(b"")
        lines.append(_INDENT + render(new_element(item, ros_version), _STYLE, _INDENT))
        before = item
    lines.append(b"</launch>")
    return b"\n".join(line for at, line in enumerate(lines) if line or at).decode() + "\n"
