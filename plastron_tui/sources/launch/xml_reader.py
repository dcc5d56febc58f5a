"""Launch files in XML, of either generation of ROS."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.launch import (
    Format,
    Group,
    Item,
    LaunchFile,
    Place,
    Unread,
)
from plastron_tui.sources.xml.document import Element, XmlDocument, read_xml

from . import ros1_elements, ros2_elements


class LaunchRead(NamedTuple):
    """A launch file that was read.

    Attributes:
        launch: what it says, None where it is no launch file.
        format: what it is written in.
        document: its XML, None for what is not XML.
        diagnostics: what is wrong with it.
    """

    launch: LaunchFile | None
    format: Format
    document: XmlDocument | None = None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_launch_xml(
    source: bytes, file: Path | None = None, ros_version: int | None = None
) -> LaunchRead:
    """Read a launch file in XML.

    Args:
        source: what the file holds.
        file: the file, for diagnostics and for its ending.
        ros_version: the generation of ROS that it is for, None where the file has to tell.
    """
    document, diagnostics = read_xml(source, file)
    if document is None:
        return LaunchRead(None, Format.XML, None, diagnostics)
    root = document.root
    version = ros_version or ros_version_of(document)
    format_ = Format.ROS1_XML if version == 1 else Format.XML
    if root.name != "launch":
        message = (
            f"the outermost element of a launch file is `<launch>`, and this is `<{root.name}>`"
        )
        found = Diagnostic(codes.BROKEN_LAUNCH, message, root.name_span, file)
        return LaunchRead(None, format_, document, (found,))
    reader = ros1_elements.item_of if version == 1 else ros2_elements.item_of
    items = tuple(read_items(root, reader))
    return LaunchRead(LaunchFile(items), format_, document)


def ros_version_of(document: XmlDocument) -> int:
    """Return the generation of ROS that a launch file is for, as its words tell."""
    votes = {1: 0, 2: 0}
    for element in document.root.walk():
        names = {each.name for each in element.attributes}
        if element.name == "node":
            votes[2] += "exec" in names or "namespace" in names
            votes[1] += "type" in names and "exec" not in names
        votes[1] += element.name in ("rosparam", "machine", "master", "test") or "ns" in names
        votes[2] += element.name.replace("-", "_") in ros2_elements.ONLY
        for each in element.attributes:
            votes[1] += "$(find " in each.value or "$(arg " in each.value
            votes[2] += "$(var " in each.value or "$(find-pkg-share " in each.value
    if votes[1] != votes[2]:
        return 1 if votes[1] > votes[2] else 2
    name = document.file.name if document.file is not None else ""
    return 1 if name.endswith(".launch") else 2


def read_items(
    element: Element, read: Callable[[Element], Item | None], depth: int = 0
) -> list[Item]:
    """Return what the elements within another one say."""
    found: list[Item] = []
    for child in element.children:
        item = read(child)
        if child.name == "group" and isinstance(item, Group):
            items = (*item.items, *read_items(child, read, depth + 1))
            item = Group(items, item.is_scoped, condition=item.condition, place=item.place)
        if item is None:
            item = Unread(f"`<{child.name}>`", place=place_of(child))
        found.append(item)
    return found


def place_of(element: Element) -> Place:
    """Return where an element stands."""
    return Place(element.span.start, element.span.end, element.line)
