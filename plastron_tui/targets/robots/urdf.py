"""A robot as a URDF file, formatted as people write it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from plastron_tui.ros.robots.description import Body, Description, Link, Material
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
    shared = with_shared_materials(robot)
    name = escaped_value(robot.name, '"')
    lines = [b'<?xml version="1.0"?>', encoded(f'<robot name="{name}">')]
    for at, element in enumerate(_elements(shared)):
        is_material = element.name == "material"
        if at and not (is_material and lines[-1]):
            lines.append(b"")
        lines.append(_INDENT + render(element, _STYLE, _INDENT))
    lines.append(b"</robot>")
    return b"\n".join(lines) + b"\n"


def with_shared_materials(robot: Description) -> Description:
    """Return a robot whose links mean their materials by name, wherever that means the same."""
    materials = dict(robot.materials)
    for material in _painted(robot):
        if material.rgba is not None or material.texture is not None:
            materials.setdefault(material.name, material)

    def named(body: Body) -> Body:
        material = body.material
        if material is None or materials.get(material.name) != material:
            return body
        return body._replace(material=Material(material.name))

    links = {
        name: link._replace(visuals=tuple(map(named, link.visuals)))
        for name, link in robot.links.items()
    }
    return replace(robot, links=links, materials=materials)


def _painted(robot: Description) -> Iterator[Material]:
    for link in robot.links.values():
        for body in link.visuals:
            if body.material is not None:
                yield body.material


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
