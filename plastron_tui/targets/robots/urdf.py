"""A robot as a URDF file, formatted as people write it."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.ros.robots.description import Description, Link
from plastron_tui.ros.robots.materials import shared
from plastron_tui.ros.robots.tree import branches
from plastron_tui.sources.urdf.new_elements import joint_element, link_element, material_element
from plastron_tui.sources.xml.layout import Style
from plastron_tui.sources.xml.new_element import NewElement, encoded, escaped_value, render

_STYLE = Style(b"\n", b"  ", '"', "/>")
_INDENT = b"  "


def write_urdf(robot: Description) -> bytes:
    """Return the text of a robot's file.

    Materials come first, and are meant by their names from there on; a link stands behind the
    joint that holds it, from the root on.
    """
    name = escaped_value(robot.name, '"')
    lines = [b'<?xml version="1.0"?>', encoded(f'<robot name="{name}">')]
    previous = ""
    for element in _elements(shared(robot)):
        if previous and not previous == element.name == "material":
            lines.append(b"")
        lines.append(_INDENT + render(element, _STYLE, _INDENT))
        previous = element.name
    lines.append(b"</robot>")
    return b"\n".join(lines) + b"\n"


def _elements(robot: Description) -> Iterator[NewElement]:
    yield from map(material_element, robot.materials.values())
    written: set[str] = set()
    for branch in branches(robot):
        if branch.joint is not None:
            yield joint_element(branch.joint)
        written.add(branch.link)
        yield link_element(robot.links[branch.link])
    rest: list[Link] = [link for name, link in robot.links.items() if name not in written]
    yield from map(link_element, rest)
