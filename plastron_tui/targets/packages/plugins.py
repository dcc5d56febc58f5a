"""The description of a package's nodelets (the wiki pages "nodelet", "pluginlib/PluginFormat")."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from .built import NODELET_BASE, BuiltNode, built_nodes
from .spec import PackagedNode, PackageSpec

NODELET = "nodelet"
"""The package that loads nodelets, and the tag that it looks for in package.xml."""


def has_plugins(spec: PackageSpec) -> bool:
    """Tell whether a package of ROS 1 has nodelets."""
    return spec.ros_version == 1 and any(each.plugin is not None for each in spec.built)


def plugin_name(spec: PackageSpec, node: PackagedNode) -> str:
    """Return what a manager loads a nodelet by: `PACKAGE/CLASS`."""
    assert node.plugin is not None, "it is a nodelet"
    return f"{spec.name}/{node.plugin.rpartition('::')[2]}"


def plugins_xml(spec: PackageSpec) -> bytes:
    """Return the description of the nodelets of a package, each in a library of its own."""
    lines = ["<class_libraries>"]
    for each in built_nodes(spec):
        lines += (f"  {line}" for line in _library(each))
    return "".join(f"{line}\n" for line in (*lines, "</class_libraries>")).encode()


def _library(built: BuiltNode) -> Iterator[str]:
    if built.plugin is None:
        return
    yield f"<library path={quoteattr(f'lib/lib{built.library}')}>"
    yield "  <class"
    yield f"    name={quoteattr(plugin_name(built.spec, built.node))}"
    yield f"    type={quoteattr(built.plugin)}"
    yield f"    base_class_type={quoteattr(NODELET_BASE)}>"
    yield f"    <description>{escape(f'The node {built.node.node.name}')}</description>"
    yield "  </class>"
    yield "</library>"
