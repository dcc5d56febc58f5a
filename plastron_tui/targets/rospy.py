"""The target `rospy`: Python nodes for ROS 1."""

from __future__ import annotations

import keyword
from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from plastron_tui.model.source import Change, SourceFile
from plastron_tui.model.values import Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType, InterfaceName

from .base import ReadResult, Rendered, Target
from .dialect import Dialect, plain_scalar
from .imports import Imports
from .rendering import render_python


class RospyTarget(Target):
    """Writes, reads and edits rospy nodes."""

    name: ClassVar[str] = "rospy"
    ros_version: ClassVar[int] = 1

    def __init__(self, template_folder: Path | None = None) -> None:
        self._template_folder = template_folder

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a new Python file."""
        return render_python(node, catalog, DIALECT, self._template_folder)

    def read(self, path: Path, text: bytes) -> ReadResult:
        """Read the nodes and endpoints of a Python file."""
        from .python import read_python  # loads tree-sitter-python

        return read_python(path, text, self.name)

    def edit(self, source: SourceFile, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change a Python file by splices."""
        from .python import edit_python  # loads tree-sitter-python

        return edit_python(source, changes, catalog, DIALECT)

    def port(self, node: Node, source: SourceFile, catalog: Catalog) -> Rendered:
        """Bring a node that was loaded from a Python file of the other ROS."""
        if source.library not in ("rospy", "rclpy"):
            return super().port(node, source, catalog)
        from .porting import port_python  # loads tree-sitter-python

        return port_python(source, catalog, self.name)


class _Rospy(Dialect):
    __slots__ = ()

    def scalar(self, type_: FieldType, value: Value, imports: Imports) -> str:
        """Write one value; a time is a pair of seconds and nanoseconds."""
        if type_.name in {"time", "duration"} and isinstance(value, tuple):
            seconds, nanoseconds = map(plain_scalar, value)
            return f"rospy.{type_.name.capitalize()}({seconds}, {nanoseconds})"
        return plain_scalar(value)

    def field(self, name: str) -> str:
        """Return a field's name; genpy puts `_` behind one that is a word of Python's own."""
        return f"{name}_" if keyword.iskeyword(name) else name

    def request(self, type_: InterfaceName, imports: Imports) -> str:
        """Return the request class that genpy makes beside a service's class."""
        return imports.use(f"{type_.package}.srv", f"{type_.name}Request")

    def response(self, type_: InterfaceName, imports: Imports) -> str:
        """Return an empty response of the class that genpy makes beside a service's class."""
        return f"{imports.use(f'{type_.package}.srv', f'{type_.name}Response')}()"


DIALECT = _Rospy(
    library="rospy",
    ros_version=1,
    standard=("threading", "time"),
    modules=("rospy",),
    symbols=(),
    module_names=frozenset({"SERVICE_TIMEOUT", "main", "node"}),
    method_names=frozenset(),
    attribute_names=frozenset({"ask", "call", "call_services"}),
)
