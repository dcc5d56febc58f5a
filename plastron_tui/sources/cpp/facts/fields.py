"""The fields of messages that the code of a unit reads or writes."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import FieldUse
from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.scopes import CppFile

from .message_types import MessageTypes
from .places import Conditionals, span_of, with_scopes

_CONSTANT = re.compile(rb"(?<=::)\s*\b([A-Z][A-Z0-9_]*[A-Z0-9])\b(?!\s*(?:::|\(|<))")


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
        yield from _constants(file, types)


def _constants(file: CppFile, types: MessageTypes) -> Iterator[FieldUse]:
    """Yield the constants of messages that are named, `Status::IDLE`.

    In a definition they are in capitals, which sets them apart from the types in the class.
    """
    conditionals = Conditionals(file)
    found = []
    for each in file.syntax.matches(_CONSTANT):
        node = file.syntax.root.descendant_for_byte_range(each.start(1), each.end(1))
        whole = None if node is None else node.parent
        if node is None or whole is None or whole.type != "qualified_identifier":
            continue
        name = whole.child_by_field_name("name")
        while (outer := whole.parent) is not None and outer.type == "qualified_identifier":
            whole = outer
        declared = None if whole.parent is None else whole.parent.child_by_field_name("declarator")
        is_read = declared is None or declared.id != whole.id
        if node.type == "identifier" and name is not None and name.id == node.id and is_read:
            found.append((node, whole))
    for (node, whole), (_, scope) in zip(
        found, with_scopes(file, [each for each, _ in found]), strict=True
    ):
        if conditionals.has(node.start_byte):
            continue
        owner = file.syntax.word(whole).rpartition("::")[0]
        reach = types.of_type(owner, scope)
        if reach is not None and not reach.path and not reach.is_list:
            yield FieldUse(reach.type, (file.syntax.word(node),), (span_of(node),), file.name)


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
