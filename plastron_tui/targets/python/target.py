"""What the targets for Python have in common: they differ in their dialect alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from plastron_tui.model.kinds import EDITABLE, EndpointKind
from plastron_tui.model.source import Change, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources import find_language
from plastron_tui.sources.base import Language, Rendered
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.line_length import find_line_length
from plastron_tui.targets.base import API_VERSION, Target

from .rendering import render_python

_PORTED = frozenset({"rospy", "rclpy"})


class PythonTarget(Target):
    """Writes, edits and ports the nodes of a client library for Python."""

    api_version: ClassVar[int] = API_VERSION
    writes: ClassVar[frozenset[EndpointKind]] = frozenset(EDITABLE)
    language: ClassVar[Language] = find_language("python")
    dialect: ClassVar[Dialect]

    def __init__(self, template_folder: Path | None = None) -> None:
        self._template_folder = template_folder

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a new Python file."""
        return render_python(node, catalog, self.dialect, self._template_folder)

    def edit(self, source: SourceUnit, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change a Python file by splices."""
        from plastron_tui.sources.python import edit_python  # loads tree-sitter-python

        line_length = find_line_length(source.path)
        return edit_python(source, changes, catalog, self.dialect, line_length)

    def port(self, node: Node, source: SourceUnit, catalog: Catalog) -> Rendered:
        """Bring a node that was loaded from a Python file of the other ROS."""
        if source.library not in _PORTED:
            return super().port(node, source, catalog)
        from .porting import port_python  # loads tree-sitter-python

        return port_python(source, catalog, self.name, find_line_length(source.path))
