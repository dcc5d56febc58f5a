"""From rclpy to rospy: annotations of the node, which is no object in rospy."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.python.scopes import BindingKind
from plastron_tui.sources.python.splices import Splice

from .port_state import Work, walk

_WORD = re.compile(r"[A-Za-z_][\w.]*")
_CHECKED_ONLY = "TYPE_CHECKING"


def leave_annotations(work: Work) -> None:
    """Take away annotations that name a class of nodes, and what is imported for them alone."""
    classes = work.analysis.library.node_classes
    names = {
        name
        for name, bindings in work.analysis.scopes.module.bindings.items()
        if bindings and all(each.kind is BindingKind.IMPORT for each in bindings)
        if {each.target for each in bindings} <= classes
    } | classes
    for node in walk(work.analysis.syntax.root):
        if node.type == "type" and names & set(words := _WORD.findall(work.slice(node))):
            _leave(work, node, set(words))
        elif node.type == "if_statement":
            _leave_check(work, node)


def _leave(work: Work, annotation: Node, words: set[str]) -> None:
    """Take an annotation away, where what it is of stays a statement or a parameter."""
    holder = annotation.parent
    if holder is None:
        return
    before = annotation.prev_named_sibling
    value = holder.child_by_field_name("value") or holder.child_by_field_name("right")
    if holder.type not in ("typed_parameter", "function_definition") and value is None:
        return
    if before is None:
        return
    work.done.update(each.id for each in walk(annotation))
    work.freed |= words
    end, text = annotation.end_byte, b""
    if holder.type == "typed_default_parameter" and value is not None:
        end, text = value.start_byte, b"="
    work.cut(Splice(before.end_byte, end, text))


def _leave_check(work: Work, statement: Node) -> None:
    """Take away an `if TYPE_CHECKING:` that nothing is left in."""
    condition, body = (statement.child_by_field_name(each) for each in ("condition", "consequence"))
    if condition is None or body is None or statement.child_by_field_name("alternative"):
        return
    is_check = work.slice(condition).rpartition(".")[2] == _CHECKED_ONLY
    if is_check and all(map(work.is_gone, body.named_children)):
        work.freed.update(_WORD.findall(work.slice(condition)))
        work.delete(statement)
