"""Fields of messages that a file reads and writes."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import FieldUse
from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.python.syntax import FUNCTIONS

from .handed_messages import Held
from .message_values import MessageValues, field_of

_ASKED = re.compile(rb"""\b(?:hasattr|getattr|setattr|delattr)\s*\(\s*[^,()]+,\s*['"](\w+)['"]""")
_HANDLERS = frozenset({"except_clause", "except_group_clause"})


def field_uses(messages: MessageValues) -> Iterator[FieldUse]:
    """Yield the fields of messages that are read or written.

    What the code asks for before (`hasattr`), or is ready not to find (`except AttributeError`), is
    left out.
    """
    text = messages.analysis.syntax.text
    asked = {name.decode() for name in _ASKED.findall(text)}
    is_ready = b"AttributeError" in text
    for node in messages.analysis.syntax.captures("messages").get("attribute", []):
        if _is_looked_into(node):
            continue
        holder, name = node.child_by_field_name("object"), node.child_by_field_name("attribute")
        if holder is None or name is None:
            continue
        held = messages.held(node) if messages.held(holder) else ()
        found = [each for each in held if not each.behind and each.path]
        if held and len(found) == len(held):
            spans = tuple(_spans(messages, node))
        elif not held and (type_ := messages.class_of(holder)) is not None:
            found, spans = [Held(type_, (messages.analysis.syntax.slice(name),))], (_span(name),)
        else:
            continue
        if asked.intersection(found[0].path) or (is_ready and _is_expected(node)):
            continue
        first, *others = (field_of(each) for each in found)
        yield FieldUse(first.type, first.path, spans, others=tuple(others), is_set=_is_set(node))


def _is_set(node: Node) -> bool:
    """Whether a statement does nothing with a field but give it a value."""
    parent = node.parent
    while parent is not None and parent.type in ("pattern_list", "tuple_pattern"):
        node, parent = parent, parent.parent
    left = None if parent is None else parent.child_by_field_name("left")
    is_assigned = parent is not None and parent.type == "assignment"
    return is_assigned and left is not None and left.id == node.id


def _is_looked_into(node: Node) -> bool:
    """Whether a longer path has a node: `msg.pose` in `msg.pose.x` and in `msg.pose[0].x`."""
    parent = node.parent
    while parent is not None and parent.type == "subscript":
        value = parent.child_by_field_name("value")
        if value is None or value.id != node.id:
            return False
        node, parent = parent, parent.parent
    if parent is None or parent.type != "attribute":
        return False
    holder = parent.child_by_field_name("object")
    return holder is not None and holder.id == node.id


def _spans(messages: MessageValues, node: Node) -> list[Span]:
    """Return where the names of a path stand, from the first behind the variable on."""
    found: list[Span] = []
    current: Node | None = node
    while current is not None:
        if current.type == "attribute":
            holder, name = (current.child_by_field_name(each) for each in ("object", "attribute"))
        elif current.type == "subscript":
            holder = name = current.child_by_field_name("value")
        else:
            break
        if holder is None or name is None or not messages.held(holder):
            break
        if current.type == "subscript":
            index = current.child_by_field_name("subscript")
            if index is not None and index.type != "slice":
                found.append(Span(holder.end_byte, current.end_byte))
        else:
            found.append(_span(name))
        current = holder
    return found[::-1]


def _span(node: Node) -> Span:
    return Span(node.start_byte, node.end_byte)


def _is_expected(node: Node) -> bool:
    """Whether something catches that there is no such attribute."""
    current: Node | None = node
    while current is not None and current.type not in FUNCTIONS:
        inner, current = current, current.parent
        if current is not None and current.type == "with_statement":
            # `with pytest.raises(AttributeError):`
            head = current.named_children[0] if current.named_child_count else None
            if head is not None and b"AttributeError" in (head.text or b""):
                return True
        if current is None or current.type != "try_statement":
            continue
        body = current.child_by_field_name("body")
        if body is not None and is_inside(inner, body):
            handlers = [each for each in current.named_children if each.type in _HANDLERS]
            if any(b"AttributeError" in (each.text or b"") for each in handlers):
                return True
    return False
