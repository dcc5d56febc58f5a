"""What the targets for C++ have in common: they differ in their dialect and templates alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import EDITABLE, EndpointKind
from plastron_tui.model.source import Change, FileSet, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources import find_language
from plastron_tui.sources.base import Language, Rendered
from plastron_tui.sources.cpp import naming
from plastron_tui.sources.cpp.layout import lay_out
from plastron_tui.targets.base import API_VERSION, Target
from plastron_tui.targets.rendering import CannotRenderError, render_text

from .dialect import Dialect
from .planner import CppPlan, plan_node

SOURCE_TEMPLATE = "node.cpp.j2"
HEADER_TEMPLATE = "node.hpp.j2"


class CppTarget(Target):
    """Writes and edits the nodes of a client library for C++."""

    api_version: ClassVar[int] = API_VERSION
    writes: ClassVar[frozenset[EndpointKind]] = frozenset(EDITABLE)
    language: ClassVar[Language] = find_language("cpp")
    dialect: ClassVar[Dialect]

    def __init__(self, template_folder: Path | None = None) -> None:
        self._template_folder = template_folder

    def is_split(self, node: Node) -> bool:
        """Tell whether a node has its class in a header of its own."""
        del node
        return self.name == "component"

    def plugin_class(self, node: Node) -> str | None:
        """Return the class by which a process of others loads a node, None for a program."""
        if not self.dialect.is_plugin:
            return None
        return f"{_namespace(node)}::{naming.class_name(node.name)}"

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a C++ file, or as a source and its header."""
        plan = plan_node(node, catalog, self.dialect)
        if isinstance(plan, Diagnostic):
            return Rendered(None, (plan,))
        is_split = self.is_split(node)
        namespace = _namespace(node) if is_split or self.dialect.is_plugin else ""
        stem = Path(self.file_name(node)).stem
        values = {
            "node": plan.node,
            "headers": plan.headers,
            "overloaded": plan.overloaded,
            "has_private": plan.has_private,
            "namespace": namespace,
            "is_split": is_split,
            "header": f"{_namespace(node)}/{stem}.hpp" if is_split else "",
        }
        try:
            files = [("{}.cpp", self._text(SOURCE_TEMPLATE, values))]
            if is_split:
                name = f"../include/{_namespace(node)}/{{}}.hpp"
                files.append((name, self._text(HEADER_TEMPLATE, values)))
        except CannotRenderError as error:
            return Rendered(None, (error.diagnostic,))
        return Rendered(FileSet(tuple((name, text.encode()) for name, text in files)))

    def edit(self, source: SourceUnit, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change the files of a unit by splices."""
        from plastron_tui.sources.cpp.editing import edit_cpp  # loads tree-sitter-cpp

        return edit_cpp(source, changes, catalog)

    def _text(self, template: str, values: dict[str, object]) -> str:
        folders = self.dialect.template_folders
        return render_text(folders, template, values, lay_out, self._template_folder)


def _namespace(node: Node) -> str:
    """Return the namespace of a node's class: its package, or its own name."""
    return naming.words(node.home.package if node.home is not None else node.name)


__all__ = ["CppPlan", "CppTarget"]
