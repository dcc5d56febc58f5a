"""A node in a package that exists: what the package's files have to say of it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.sources.packages import Changed, add_built_node, add_node
from plastron_tui.targets.packages.built import NODELET_BASE, built_nodes
from plastron_tui.targets.packages.dependencies import dependencies_of
from plastron_tui.targets.packages.needs import needs_of
from plastron_tui.targets.packages.plugins import plugin_name
from plastron_tui.targets.packages.spec import BuildType, PackagedNode, PackageSpec

if TYPE_CHECKING:
    from plastron_tui.model.package_source import PackageSource

Notes = tuple[Diagnostic, ...]


def with_node(
    source: PackageSource,
    texts: Mapping[str, bytes],
    node: PackagedNode,
    file: str,
    known: frozenset[str],
) -> tuple[Changed, Notes]:
    """Return a package that has a node, and what of the node's needs nobody knows.

    Args:
        source: the package.
        texts: what its files hold by now.
        node: the node.
        file: its main file, by its path in the package.
        known: the packages with interface types that are known.
    """
    spec = PackageSpec(
        source.name,
        source.ros_version,
        nodes=(node,),
        packages=known,
        build_type=None if node.is_built else BuildType.AMENT_PYTHON,
    )
    if node.is_built:
        return _built(source, texts, spec, file)
    dependencies, unknown = dependencies_of(spec)
    keys = [each.key for each in dependencies if each.tag == "exec_depend"]
    return add_node(source, texts, node.executable, file, keys), unknown


def _built(
    source: PackageSource, texts: Mapping[str, bytes], spec: PackageSpec, file: str
) -> tuple[Changed, Notes]:
    """Let a package build its node, as a new package with nothing else would."""
    from plastron_tui.sources.cmake.targets import NewTarget
    from plastron_tui.sources.xml.plugins import PluginClass

    [built] = built_nodes(spec)
    node = built.node
    keys, unknown = needs_of(spec, node)
    target = NewTarget(
        node.executable,
        file,
        "/".join((*PurePosixPath(file).parts[:-2], "include")) if built.has_header else "",
        built.packages,
        built.linked,
        node.plugin,
        source.name in node.node.packages,
    )
    plugin = None
    if node.plugin is not None and source.ros_version == 1:
        described = f"The node {node.node.name}"
        plugin = PluginClass(plugin_name(spec, node), node.plugin, NODELET_BASE, described)
    return add_built_node(source, texts, target, sorted(keys), plugin), unknown
