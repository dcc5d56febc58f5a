"""What nothing needs any more once an endpoint is gone: callbacks and includes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.splices import line_end, line_start

from .. import interface_types
from ..analysis import Analysis, Site
from ..scopes import CppFile, Function
from .deletions import Deletions

_LOGS = re.compile(r"(?:ROS|NODELET|RCLCPP)_(?:INFO|DEBUG|WARN|ERROR)\w*\s*\(")
_VOID = re.compile(r"\(void\)\s*\w+|static_cast<void>\(\w+\)")
_KINDS = {
    EndpointKind.PUBLISHER: InterfaceKind.MESSAGE,
    EndpointKind.SUBSCRIPTION: InterfaceKind.MESSAGE,
    EndpointKind.SERVICE: InterfaceKind.SERVICE,
    EndpointKind.CLIENT: InterfaceKind.SERVICE,
    EndpointKind.ACTION_SERVER: InterfaceKind.ACTION,
    EndpointKind.ACTION_CLIENT: InterfaceKind.ACTION,
}


def functions_of(analysis: Analysis, site: Site) -> Iterator[list[Function]]:
    """Yield the functions that an endpoint calls, each with all its declarations."""
    named = [each for each in site.callback.functions if not each.file.is_beside]
    if not named:
        return
    owner = analysis.unit.class_of_function(named[0])
    same = [
        each
        for each in analysis.unit.functions.get(named[0].name, [])
        if analysis.unit.class_of_function(each) is owner
    ]
    yield same


def has_uses(analysis: Analysis, functions: Sequence[Function], gone: Deletions) -> bool:
    """Tell whether anything that stays names a function, but for itself."""
    name = functions[0].name
    own = {(each.file.name, each.declarator.start_byte) for each in functions}
    bodies = [(each.file, each.node.start_byte, each.node.end_byte) for each in functions]
    pattern = re.compile(rb"(?<![A-Za-z0-9_])" + re.escape(name.encode()) + rb"(?!\w)")
    for file in analysis.unit.files:
        for found in pattern.finditer(file.syntax.code):
            if gone.covers(file, found.start()):
                continue
            node = file.syntax.root.named_descendant_for_byte_range(found.start(), found.end())
            if node is None or not node.type.endswith("identifier"):
                continue
            if any(each is file and start <= found.start() < end for each, start, end in bodies):
                continue
            if not _is_declarator(node, file, own):
                return True
    return False


def _is_declarator(node: Node, file: CppFile, own: set[tuple[str, int]]) -> bool:
    inner: Node | None = node
    for _ in range(4):
        if inner is None:
            return False
        if inner.type == "function_declarator":
            return (file.name, inner.start_byte) in own
        inner = inner.parent
    return False


def is_stub(function: Function) -> bool:
    """Tell whether a function does nothing but log, as a new one does."""
    return all(_is_log(each, function) for each in _body(function))


def is_idle(function: Function, gone: Deletions) -> bool:
    """Tell whether nothing is left of what a function did."""
    body = _body(function)
    return bool(body) and all(gone.covers(function.file, each.start_byte) for each in body)


def _body(function: Function) -> list[Node]:
    body = function.node.child_by_field_name("body")
    return [] if body is None else [each for each in body.named_children if each.type != "comment"]


def _is_log(node: Node, function: Function) -> bool:
    text = function.file.syntax.word(node).strip().rstrip(";")
    is_answer = text in ("return true", "return")
    return is_answer or bool(_LOGS.match(text) or _VOID.fullmatch(text))


def remove_function(function: Function, gone: Deletions) -> None:
    """Take out a definition or a declaration."""
    gone.statement(function.file, function.node)


def unused_includes(
    analysis: Analysis, sites: Sequence[Site], gone: Deletions
) -> Iterator[tuple[CppFile, int, int]]:
    """Yield the lines that include types which no file of the unit names any more."""
    for type_, kind in dict.fromkeys(
        (site.endpoint.type, _KINDS.get(site.endpoint.kind)) for site in sites
    ):
        if type_ is None or kind is None or _is_named(analysis, type_.name, gone):
            continue
        headers = {interface_types.header(type_, kind, analysis.ros_version)}
        if kind is InterfaceKind.ACTION and analysis.ros_version == 1:
            headers = {
                interface_types.header(type_, kind, 1, part)
                for part in ("Action", "Goal", "Result", "Feedback")
            }
        for file in analysis.unit.files:
            if file.is_beside:
                continue
            text = file.syntax.text
            for include in file.syntax.includes:
                if include.path in headers:
                    start = line_start(text, include.start)
                    yield file, start, line_end(text, start)


def _is_named(analysis: Analysis, name: str, gone: Deletions) -> bool:
    """Tell whether code that stays has a word for a type, or for what is made of it."""
    pattern = re.compile(
        rb"(?<![A-Za-z0-9_])" + re.escape(name.encode()) + rb"(?:Const)?(?:Ptr)?(?!\w)"
    )
    return any(
        not gone.covers(file, found.start())
        for file in analysis.unit.files
        for found in pattern.finditer(file.syntax.code)
    )
