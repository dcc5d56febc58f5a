"""Whether all that may declare a parameter of a node is among the C++ files that are read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.cpp.analysis import Analysis, NodeSite
from plastron_tui.sources.cpp.arguments import call_of
from plastron_tui.sources.cpp.scopes import CppFile, Function, Scope, last_name, scope_at, type_text

from .handed_out import MAKING, handed_out
from .helped_parameters import HELPERS, helper_calls

_DECLARING = re.compile(
    rb"\b(?!undeclare_|allow_undeclared_|automatically_declare_)\w*declare\w*\b", re.I
)
_BASES = ("rclcpp::Node", "rclcpp_lifecycle::LifecycleNode", "std::")
_NAV2_BASES = ("nav2::LifecycleNode", "nav2_util::LifecycleNode")
"""Nodes that declare parameters for themselves, which those that derive from them do not read."""
_HARMLESS = ("diagnostic_updater::", "message_filters::", "rclcpp::", "rclcpp_action::",
             "rclcpp_lifecycle::", "std::", "tf2_ros::")  # fmt: skip
"""Where what gets a node declares no parameter of it, but for the qualities of topics."""
_OWN_NAMES = (*_HARMLESS, "BT::", "camera_info_manager::",
              "image_transport::", "laser_proc::", "moveit::", "pluginlib::")  # fmt: skip
"""Where what gets a node declares no parameter that the code of the node reads itself."""
_FUNCTIONS = frozenset(
    {
        *HELPERS,
        "add_callback_group", "add_node", "bind", "create_client", "create_generic_publisher",
        "create_generic_subscription", "create_publisher", "create_server", "create_service",
        "create_subscription", "create_timer", "create_wall_timer", "get", "make_pair", "move",
        "remove_node", "spin", "spin_node_once", "spin_node_some", "spin_some",
        "spin_until_future_complete", "static_pointer_cast", "subscribe", "swap",
    }
)  # fmt: skip


class Wholeness(NamedTuple):
    """How much is known of what a node declares, see `ParameterFacts`."""

    is_whole: bool = False
    is_own: bool = False


def wholeness(analysis: Analysis, maker: NodeSite) -> Wholeness:
    """Tell whether the call sites of a node are all that declares parameters of it."""
    owner = maker.owner
    if owner is not None and not is_defined(analysis, owner, called=True):
        return Wholeness()
    return Wholeness() if _declares_beside(analysis) else rest_wholeness(analysis, maker)


def rest_wholeness(analysis: Analysis, maker: NodeSite) -> Wholeness:
    """Tell the same but for the methods of the node's class that are not read."""
    owner = maker.owner
    if owner is not None and not _is_of(analysis, owner, (*_BASES, *_NAV2_BASES)):
        return Wholeness()
    if any(True for _ in _other_declarations(analysis)):
        return Wholeness()
    files = analysis.unit.files
    handed = [each for file in files for each in handed_out(analysis, file)]
    is_own = all(_is_harmless(analysis, *each, _OWN_NAMES) for each in handed)
    is_whole = owner is None or knows_bases(analysis, owner)
    is_whole = is_whole and all(_is_harmless(analysis, *each, _HARMLESS) for each in handed)
    return Wholeness(is_own and is_whole, is_own)


def is_elsewhere(analysis: Analysis, maker: NodeSite) -> bool:
    """Tell whether a node's class is one of a header whose methods other sources define."""
    owner = maker.owner
    if owner is None or not owner.file.name:
        return False
    is_open = False
    for name in owner.functions:
        known = analysis.unit.functions_of(owner, name)
        bodies = [each for each in known if each.scope is not None]
        if any(not each.file.name for each in bodies):
            return False
        own = [each for each in bodies if not each.file.is_beside]
        is_open = is_open or not (own or all(map(_is_without_body, known)))
    return is_open


def _declares_beside(analysis: Analysis) -> bool:
    """Tell whether a source whose call sites are others' may declare in methods of the classes."""
    unit = analysis.unit
    return any(
        file.syntax.has(_DECLARING)
        and any(
            each.qualifier and unit.class_of_function(each) is not None
            for scope in file.scopes
            for functions in scope.functions.values()
            for each in functions
        )
        for file in unit.all_files
        if file.is_beside
    )


def is_handed_out(analysis: Analysis, file: CppFile) -> bool:
    """Tell whether a node is given to something that may create more of it."""
    return not all(_is_harmless(analysis, *each, _HARMLESS) for each in handed_out(analysis, file))


def knows_bases(analysis: Analysis, owner: Scope) -> bool:
    """Tell whether a class, as far as it is not read, is a node of ROS 2 and nothing else."""
    return _is_of(analysis, owner, _BASES)


def _is_of(analysis: Analysis, owner: Scope, bases: tuple[str, ...]) -> bool:
    found = [
        analysis.types.expand(base, owner).partition("<")[0]
        for base in analysis.unit.foreign_bases(owner)
    ]
    return all(base in bases or base.startswith("std::") for base in found)


def is_defined(analysis: Analysis, owner: Scope, *, called: bool = False) -> bool:
    """Tell whether all methods of a class and its bases are read, or those that are called."""
    unit = analysis.unit
    for each in unit.bases(owner):
        for name, functions in each.functions.items():
            if called and name != each.name and name not in unit.calls:
                continue
            known = unit.functions_of(each, name)
            is_open = any(one.scope is None and not _is_without_body(one) for one in functions)
            if is_open and not any(one.scope is not None for one in known):
                return False
    return True


def _is_without_body(function: Function) -> bool:
    """Tell whether a method is not to be defined: it is pure, or the compiler's."""
    code = function.file.syntax.code
    return b"=" in code[function.declarator.end_byte : function.node.end_byte]


def _other_declarations(analysis: Analysis) -> Iterator[Node]:
    """Yield the names with `declare` that stand elsewhere than in a known call site."""
    known = {
        (id(site.file), site.call.name_node.start_byte)
        for site in analysis.sites
        if site.call.name_node is not None
    }
    known |= {
        (id(call.scope.file), call.name_node.start_byte)
        for call in helper_calls(analysis)
        if call.name_node is not None
    }
    own = analysis.unit.functions
    for file in analysis.unit.files:
        for found in file.syntax.matches(_DECLARING):
            node = file.syntax.root.descendant_for_byte_range(found.start(), found.end())
            if node is None or not node.type.endswith("identifier"):
                continue
            if (id(file), node.start_byte) not in known and file.syntax.word(node) not in own:
                yield node


def _is_harmless(
    analysis: Analysis, file: CppFile, given: Node | None, known: tuple[str, ...]
) -> bool:
    """Tell whether what gets an argument surely declares nothing of a node."""
    listed = None if given is None else given.parent
    call = listed.parent if listed is not None else None
    if call is None or listed is None:
        return False
    if _is_for_method(analysis, file, listed):
        return True
    scope = scope_at(file, call.start_byte)
    if call.type == "call_expression":
        return _is_harmless_call(analysis, call, scope, known)
    if call.type == "function_declarator":
        declaration = call.parent
        made = None if declaration is None else declaration.child_by_field_name("type")
        return made is not None and _is_harmless_type(
            analysis, file.syntax.word(made), scope, known
        )
    if call.type == "new_expression":
        made = call.child_by_field_name("type")
        return made is not None and _is_harmless_type(
            analysis, file.syntax.word(made), scope, known
        )
    if call.type in ("field_initializer", "init_declarator", "compound_literal_expression"):
        first = call.child_by_field_name("type") or call.named_children[0]
        if call.type == "compound_literal_expression":
            return _is_harmless_type(analysis, file.syntax.word(first), scope, known)
        name = last_name(first, scope)
        variable = analysis.unit.lookup(name, scope, call.end_byte) if name else None
        if variable is not None:
            return _is_harmless_type(analysis, variable.type, scope, known)
        # A base class, or a constructor of the class itself.
        return _is_harmless_type(analysis, file.syntax.word(first), scope, known)
    return False


def _is_for_method(analysis: Analysis, file: CppFile, listed: Node) -> bool:
    """Tell whether a method of the files stands among arguments, which gets the node."""
    pointers = (each for each in listed.named_children if each.type == "pointer_expression")
    names = ("".join(file.syntax.word(each).split()).rpartition("::")[2] for each in pointers)
    return any(name.lstrip("&") in analysis.unit.functions for name in names)


def _is_harmless_call(analysis: Analysis, node: Node, scope: Scope, known: tuple[str, ...]) -> bool:
    call = call_of(node, scope, scope.file.syntax)
    if call is None:
        return False
    if call.name in MAKING and call.type_nodes:
        made = scope.file.syntax.word(call.type_nodes[0])
        return _is_harmless_type(analysis, made, scope, known)
    own = analysis.unit.functions.get(call.name)
    if call.name in _FUNCTIONS or own is not None:
        return own is None or any(each.scope is not None for each in own)
    if call.receiver is not None:
        type_ = analysis.receivers.type_of(call.receiver, scope)
        return bool(type_) and _is_harmless_type(analysis, type_, scope, known)
    return _is_harmless_type(analysis, call.qualified, scope, known)


def _is_harmless_type(analysis: Analysis, text: str, scope: Scope, known: tuple[str, ...]) -> bool:
    """Tell whether objects of a type declare nothing of a node that they get."""
    plain = analysis.types.expand(type_text(text), scope)
    for wrapper in ("std::shared_ptr<", "std::unique_ptr<", "std::optional<"):
        plain = plain.removeprefix(wrapper)
    plain = plain.partition("<")[0].removesuffix(">")
    own = analysis.unit.find_class(plain, scope)
    return plain.startswith(known) if own is None else is_defined(analysis, own, called=True)
