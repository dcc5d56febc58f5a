"""What the targets for Python have in common: they differ in their dialect alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from plastron_tui.model.source import Change, SourceFile
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog

from .base import ReadResult, Rendered, Target
from .dialect import Dialect
from .rendering import render_python

_PORTED = frozenset({"rospy", "rclpy"})


class PythonTarget(Target):
    """Writes, reads and edits the nodes of a client library for Python."""

    dialect: ClassVar[Dialect]

    def __init__(self, template_folder: Path | None = None) -> None:
        self._template_folder = template_folder

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a new Python file."""
        return render_python(node, catalog, self.dialect, self._template_folder)

    def read(self, path: Path, text: bytes) -> ReadResult:
        """Read the nodes and endpoints of a Python file."""
        from .python import read_python  # loads tree-sitter-python

        return read_python(path, text, self.name)

    def edit(self, source: SourceFile, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change a Python file by splices."""
        from .python import edit_python  # loads tree-sitter-python

        return edit_python(source, changes, catalog, self.dialect)

    def port(self, node: Node, source: SourceFile, catalog: Catalog) -> Rendered:
        """Bring a node that was loaded from a Python file of the other ROS."""
        if source.library not in _PORTED:
            return super().port(node, source, catalog)
        from .porting import port_python  # loads tree-sitter-python

        return port_python(source, catalog, self.name)

    def is_worse(self, text: bytes, *others: bytes) -> bool:
        """Tell whether a text is no Python, or breaks more of it, than each of the others."""
        from .compiling import syntax_error
        from .python.syntax import parse

        if parse(text).errors > max((parse(other).errors for other in others), default=0):
            return True
        # Tabs and blanks mixed up are no error to tree-sitter.
        is_broken = syntax_error(text) is not None
        return is_broken and all(syntax_error(other) is None for other in others)

    def definitions(self, text: bytes, name: str) -> int:
        """Count the functions and methods of a name that a Python text defines."""
        from .python.words import definitions

        return definitions(text, name)

    def mentions(self, text: bytes, name: str) -> bool:
        """Tell whether Python code has a name; strings and comments are no code."""
        from .python.words import mentions

        return mentions(text, name)

    def lines_of_code(self, text: bytes) -> Counter[bytes]:
        """Return the lines of a Python text without blank lines and imports."""
        from .python.words import lines_of_code

        return lines_of_code(text)
