"""Whether all that may declare a parameter of a node is read."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis, NodeSite
from plastron_tui.sources.python.scopes import BindingKind

from .aliased_parameters import aliases
from .base_files import read_bases
from .closed import handed_out

_DECLARING = re.compile(rb"\b(?:declare_parameters?|_declare_parameter\w*)\b")
_MANY = re.compile(r"declare_parameters?")
_HARMLESS = frozenset(
    {
        "cv_bridge", "diagnostic_updater", "image_geometry", "message_filters", "numpy",
        "rclpy", "sensor_msgs_py", "tf2_geometry_msgs", "tf2_py", "tf2_ros", "tf_transformations",
    }
)  # fmt: skip
"""What gets a node and declares no parameter of it, but for the qualities of topics."""
_OWN_NAMES = _HARMLESS | {"nav2_simple_commander", "py_trees_ros"}
"""What gets a node and declares no parameter that the code of the node reads itself."""
_DECLARE_NOTHING = sys.stdlib_module_names | {"rclpy"}
"""Modules of whose classes none declares a parameter of what derives from it."""
_DEEPEST = 4
_MOST = 64


class Wholeness(NamedTuple):
    """How much is known of what a node declares, see `ParameterFacts`."""

    is_whole: bool
    is_own: bool


def wholeness(analysis: Analysis, maker: NodeSite) -> Wholeness:
    """Tell whether the call sites of a node are all that declares parameters of it."""
    return Wholeness(*(_declares_all(analysis, maker, each) for each in (_HARMLESS, _OWN_NAMES)))


def _declares_all(analysis: Analysis, maker: NodeSite, known: frozenset[str]) -> bool:
    if analysis.syntax.errors or not _is_harmless(analysis, known):
        return False
    bases = () if maker.owner is None else read_bases(analysis, maker.owner, _DECLARE_NOTHING)
    return bases is not None and all(_is_harmless(each.file, known) for each in bases)


def _is_harmless(analysis: Analysis, known: frozenset[str]) -> bool:
    """Tell whether a file leaves its nodes to nothing that may declare more."""
    if any(True for _ in _other_declarations(analysis)):
        return False
    return all(_is_harmless_call(analysis, call, known) for call in handed_out(analysis))


def _other_declarations(analysis: Analysis) -> Iterator[Node]:
    """Yield the names of declaring methods that stand elsewhere than in a known call site."""
    sites = {site.call.id for site in analysis.sites}
    root = analysis.syntax.root
    own = {each.name for each in analysis.scopes.all if each.kind == "function"}
    aliased = {alias.method.id for alias in aliases(analysis)}
    for found in _DECLARING.finditer(analysis.syntax.text):
        node = root.descendant_for_byte_range(found.start(), found.end())
        if node is None or node.type != "identifier" or _MANY.fullmatch(found[0].decode()) is None:
            continue
        around = node.parent
        if node.id in aliased or (around is not None and around.type == "function_definition"):
            continue
        call = around.parent if around is not None and around.type == "attribute" else around
        is_call = call is not None and call.type == "call"
        if is_call and call is not None and call.id in sites:
            continue
        if not (is_call and found[0].decode() in own):
            yield node


def _is_harmless_call(analysis: Analysis, call: Node, known: frozenset[str]) -> bool:
    """Tell whether a call gets a node and surely declares nothing of it."""
    callee = call.child_by_field_name("function")
    scope = analysis.scopes.at(call.start_byte)
    names = analysis.resolver.qualified(callee, scope)
    return bool(names) and all(_is_harmless_name(analysis, name, known) for name in names)


def _is_harmless_name(analysis: Analysis, name: str, known: frozenset[str]) -> bool:
    first = name.partition(".")[0]
    if first in known or first in sys.stdlib_module_names:
        return True
    held = analysis.package.bound(name) if analysis.package is not None else None
    return held is not None and _declares_nothing(held[0], set(), 1)


def _declares_nothing(module: Analysis, seen: set[int], depth: int) -> bool:
    """Tell whether neither a module of the package nor what it imports there has a declaration."""
    if id(module) in seen:
        return True
    seen.add(id(module))
    if depth > _DEEPEST or len(seen) > _MOST or _DECLARING.search(module.syntax.text):
        return False
    package = module.package
    for bindings in module.scopes.module.bindings.values():
        for binding in bindings[:1]:
            if binding.kind is not BindingKind.IMPORT or package is None:
                continue
            held = package.bound(binding.target)
            if held is not None and not _declares_nothing(held[0], seen, depth + 1):
                return False
    return not module.scopes.module.star_imports
