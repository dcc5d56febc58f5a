"""What the targets for C++ have in common: they differ in their dialect and templates alone."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
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
from plastron_tui.sources.cpp.mentioned import registered_classes
from plastron_tui.targets.base import API_VERSION, Target
from plastron_tui.targets.rendering import CannotRenderError, render_text

from .dialect import Dialect
from .planner import CppPlan, plan_node

SOURCE_TEMPLATE = "node.cpp.j2"
HEADER_TEMPLATE = "node.hpp.j2"

_TAKEN_NAMESPACES = frozenset({"main", "std"})


class CppTarget(Target):
    """Writes and edits the nodes of a client library for C++."""

    api_version: ClassVar[int] = API_VERSION
    writes: ClassVar[frozenset[EndpointKind]] = frozenset(EDITABLE)
    language: ClassVar[Language] = find_language("cpp")
    dialect: ClassVar[Dialect]

    def __init__(self, template_folder: Path | None = None) -> None:
        self._template_folder = template_folder
        self._layout = ""

    def set_layouts(self, layouts: Mapping[str, str]) -> None:
        """Let a project say whether new nodes have their class in a header of its own."""
        self._layout = layouts.get(self.language.name, "")

    def is_split(self, node: Node) -> bool:
        """Tell whether a node has its class in a header of its own."""
        del node
        return self._layout == "split" or (not self._layout and self.dialect.is_split)

    def plugin_class(self, node: Node) -> str | None:
        """Return the class by which a process of others loads a node, None for a program."""
        if not self.dialect.is_plugin:
            return None
        source = node.source
        if source is not None and source.library == self.name:
            registered = _registered(source)
            if registered is not None:
                return registered
        return f"{_namespace(node)}::{naming.class_name(node.name)}"

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a C++ file, or as a source and its header."""
        plan = plan_node(node, catalog, self.dialect)
        if isinstance(plan, Diagnostic):
            return Rendered(None, (plan,))
        is_split = self.is_split(node)
        namespace = _namespace(node) if is_split or self.dialect.is_plugin else ""
        folder, stem = _package(node), Path(self.file_name(node)).stem
        base = self.dialect.base_of(is_managed=node.is_managed)
        base_name = base.rpartition("::")[2]
        values = {
            "node": plan.node,
            "keeps_out_nan": plan.keeps_out_nan,
            "checks_parameters": plan.checks_parameters,
            "headers": self._headers(plan),
            "overloaded": plan.overloaded,
            "has_private": plan.has_private,
            "namespace": namespace,
            "is_split": is_split,
            "is_plugin": self.dialect.is_plugin,
            # A plugin ends with the process that it is in, and has no status of its own.
            "has_status": plan.node.ends and not self.dialect.is_plugin,
            "header": f"{folder}/{stem}.hpp" if is_split else "",
            "guard": _guard(f"{folder}/{stem}.hpp"),
            "base": base,
            # In a class of the same name, that name is the class itself.
            "base_name": base if base_name == plan.node.class_name else base_name,
        }
        try:
            files = [("{}.cpp", self._text(SOURCE_TEMPLATE, values))]
            if is_split:
                name = f"../include/{folder}/{{}}.hpp"
                files.append((name, self._text(HEADER_TEMPLATE, values)))
        except CannotRenderError as error:
            return Rendered(None, (error.diagnostic,))
        return Rendered(FileSet(tuple((name, text.encode()) for name, text in files)))

    def _headers(self, plan: CppPlan) -> tuple[str, ...]:
        """Return the headers that are not the standard library's, sorted."""
        dialect, node = self.dialect, plan.node
        found = {*plan.headers, dialect.header}
        if node.is_managed:
            found.add(dialect.managed_header)
        if node.action_servers or node.action_clients:
            found.add(dialect.action_header)
        if dialect.ros_version == 2 and any(each.descriptor for each in node.parameters):
            found.add("rcl_interfaces/msg/parameter_descriptor.hpp")
        if dialect.ros_version == 2 and plan.checks_parameters:
            found.add("rcl_interfaces/msg/set_parameters_result.hpp")
        return tuple(sorted(found - {""}))

    def edit(self, source: SourceUnit, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change the files of a unit by splices."""
        from plastron_tui.sources.cpp.editing import edit_cpp  # loads tree-sitter-cpp

        return edit_cpp(source, changes, catalog)

    def _text(self, template: str, values: dict[str, object]) -> str:
        folders = self.dialect.template_folders
        return render_text(folders, template, values, lay_out, self._template_folder)


def _registered(source: SourceUnit) -> str | None:
    """Return the class that a loaded node registers, None where its files do not say which."""
    found = [each for _, text in source.files.texts for each in registered_classes(text)]
    meant = {each.class_name.rpartition("::")[2] for each in source.nodes if each.class_name}
    named = [each for each in found if each.rpartition("::")[2] in meant]
    return next(iter(named or (found if len(found) == 1 else ())), None)


def _package(node: Node) -> str:
    """Return the package that a node is in, or what stands for it where it is in none."""
    return node.home.package if node.home is not None else naming.words(node.name)


def _namespace(node: Node) -> str:
    """Return the namespace of a node's class: its package, or its own name."""
    name = naming.words(_package(node))
    return name if naming.is_name(name) and name not in _TAKEN_NAMESPACES else f"{name}_nodes"


def _guard(header: str) -> str:
    """Return the macro by which a header is read once, as ament_cpplint wants it."""
    folder, _, name = header.rpartition("/")
    parts = (re.sub(r"\W", "_", part, flags=re.ASCII).upper() for part in (folder, name))
    return f"{'__'.join(parts)}_"


__all__ = ["CppPlan", "CppTarget"]
