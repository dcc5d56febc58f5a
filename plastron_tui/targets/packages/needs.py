"""What the nodes of a package need of other packages, by what their files name."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.package_keys import key_of_header, key_of_module

from .spec import PackagedNode, PackageSpec, interfaces_name

# Nodelets are looked for in packages alone that depend on `nodelet` (the wiki page "pluginlib").
_LOADED_BY = {1: {"nodelet", "pluginlib"}, 2: {"rclcpp_components"}}


def needs_of(
    spec: PackageSpec, node: PackagedNode
) -> tuple[frozenset[str], tuple[Diagnostic, ...]]:
    """Return the packages and rosdep keys that a node needs, and what nobody knows.

    Args:
        spec: the package.
        node: one of its nodes.
    """
    own = {spec.name, *(each.module for each in spec.scripts)}
    known = spec.packages | {interfaces_name(spec.name)}
    keys = set(node.node.packages)
    if node.plugin is not None:
        keys |= _LOADED_BY[spec.ros_version]
    diagnostics = []
    for name in sorted(node.imports):
        if name.partition("/" if node.is_built else ".")[0] in own:
            continue
        find = key_of_header if node.is_built else key_of_module
        key = find(name, spec.ros_version, known)
        if key is not None:
            keys.add(key)
            continue
        verb, tag = ("includes", "depend") if node.is_built else ("imports", "exec_depend")
        message = f"`{node.file}` {verb} `{name}`, and no package is known that has it"
        help_ = f"add what brings it to package.xml, as `<{tag}>KEY</{tag}>`"
        diagnostics.append(Diagnostic(codes.UNKNOWN_IMPORT, message, node.span, help=help_))
    return frozenset(keys), tuple(diagnostics)
