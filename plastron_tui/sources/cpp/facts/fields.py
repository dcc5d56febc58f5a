"""The fields of messages that the code of a unit reads or writes."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import FieldUse
from plastron_tui.sources.cpp.analysis import Analysis

from .message_types import MessageTypes
from .places import Conditionals, with_scopes


def field_uses(analysis: Analysis, types: MessageTypes) -> Iterator[FieldUse]:
    """Yield the fields that are used, each with all that leads to it."""
    for file in analysis.unit.files:
        conditionals = Conditionals(file)
        seen: set[int] = set()
        for node, scope in with_scopes(file, file.syntax.field_expressions):
            if node.id in seen or method_of(node) is not None or conditionals.has(node.start_byte):
                continue
            reach = types.of(node, scope)
            if reach is None or not reach.path or reach.names[-1].startswith("_"):
                # What begins with `_` is of the class, and of no definition.
                continue
            # `msg.pose` of `msg.pose.position` says nothing more.
            seen.update(_inner(node))
            is_set = _is_set(node)
            yield FieldUse(reach.type, reach.names, reach.spans, file.name, is_set=is_set)


def method_of(node: Node) -> str | None:
    """Return the name of the method that `a.f` names in `a.f()`, None where it names a field."""
    parent = node.parent
    called = None if parent is None else parent.child_by_field_name("function")
    if called is None or called.id != node.id:
        return None
    name = node.child_by_field_name("field")
    return "" if name is None or name.text is None else name.text.decode("utf-8", "replace")


def _is_set(node: Node) -> bool:
    """Tell whether a statement does nothing with a field but give it a value."""
    parent = node.parent
    if parent is None or parent.type != "assignment_expression":
        return False
    left, operator = (parent.child_by_field_name(each) for each in ("left", "operator"))
    is_plain = operator is not None and operator.type == "="
    return left is not None and left.id == node.id and is_plain


def _inner(node: Node) -> Iterator[int]:
    """Yield the expressions that a chain of fields and indices begins with."""
    holder = node.child_by_field_name("argument")
    while holder is not None:
        yield holder.id
        if holder.type == "call_expression":
            holder = holder.child_by_field_name("function")
        else:
            holder = holder.child_by_field_name("argument")
