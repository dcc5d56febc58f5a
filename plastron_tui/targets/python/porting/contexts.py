"""From rclpy to rospy: `with rclpy.init():`, and executors, which rospy has none of."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.splices import Splice, apply, delete_item, line_end, line_start
from plastron_tui.sources.python.syntax import parse, parts_of

from .port_state import Work, walk

_EXECUTORS = frozenset(
    f"rclpy.executors.{name}" for name in ("SingleThreadedExecutor", "MultiThreadedExecutor")
)
_CONTEXT = "rclpy_context_of_the_port()"
"""Stands in a `with` until all else is rewritten."""

_WITH = f"with {_CONTEXT}".encode("ascii")


def port_context(work: Work, call: Node) -> None:
    """Note that `with rclpy.init():` goes, if it is one."""
    item = call.parent
    if item is not None and item.type == "with_item":
        work.done.add(call.id)
        work.replace(call, _CONTEXT)


def leave_try(work: Work, statement: Node) -> None:
    """Note that a `try` goes, which has nothing beside its body any more."""
    work.cut(Splice(statement.start_byte, statement.start_byte + len("try"), _WITH))


def without_contexts(text: bytes) -> bytes:
    """Take away each `with` that was noted, and let its body begin where it began."""
    while _CONTEXT.encode("ascii") in text:
        syntax = parse(text)
        items = [node for node in walk(syntax.root) if node.type == "with_item"]
        item = next((each for each in items if syntax.slice(each) == _CONTEXT), None)
        if item is None or item.parent is None or item.parent.parent is None:
            return text
        clause, statement = item.parent, item.parent.parent
        if len(parts_of(clause)) > 1:
            text = apply(text, [delete_item(text, parts_of(clause), item)])
        else:
            text = apply(text, _dedented(text, statement, clause))
    return text


def _dedented(text: bytes, statement: Node, clause: Node) -> list[Splice]:
    """Return what takes the first line of a `with` away, and moves the others to its left."""
    body = statement.child_by_field_name("body")
    assert body is not None
    at = line_start(text, body.start_byte)
    if at <= statement.start_byte:
        return [Splice(statement.start_byte, body.start_byte)]
    width = body.start_point.column - statement.start_point.column
    strings = [node for node in walk(body) if node.type == "string"]
    header = line_end(text, clause.end_byte)
    splices = [Splice(line_start(text, statement.start_byte), header)]
    at = header
    while at < body.end_byte:
        end = line_end(text, at)
        blank = len(text[at:end]) - len(text[at:end].lstrip(b" \t"))
        if not any(each.start_byte < at < each.end_byte for each in strings):
            splices.append(Splice(at, at + min(width, blank)))
        at = end
    return splices


def port_executors(work: Work) -> None:
    """Let rospy's own threads do what an executor does, where that is only to spin nodes."""
    for node in work.analysis.captures.get("assignment", []):
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        callee = right.child_by_field_name("function") if right is not None else None
        is_made = callee is not None and set(work.qualified(callee)) & _EXECUTORS
        if is_made and left is not None and left.type == "identifier":
            _port_executor(work, node, work.slice(left))


def _port_executor(work: Work, made: Node, name: str) -> None:
    """Rewrite all that is done with an executor, if every use of it is known."""
    owner = work.scope(made).lookup(name)
    uses = [
        node
        for node in walk(work.analysis.syntax.root)
        if node.type == "identifier"
        and work.slice(node) == name
        and owner is not None
        and (found := work.scope(node).lookup(name)) is not None
        and found[0] is owner[0]
        and not made.start_byte <= node.start_byte < made.end_byte
    ]
    calls = [(node.parent.parent, node.parent) for node in uses if node.parent is not None]
    gone, spins = [], []
    for call, callee in calls:
        part = callee.child_by_field_name("attribute")
        method = work.slice(part) if part is not None else ""
        if call is None or call.type != "call":
            return
        statement = statement_of(call)
        is_alone = statement.named_children == [call]
        given = parts_of(call.child_by_field_name("arguments"))
        is_name = len(given) == 1 and given[0].type in ("identifier", "attribute")
        if method == "spin" and not given:
            spins.append(call)
        elif is_alone and (method == "shutdown" or (method.endswith("_node") and is_name)):
            gone.append(statement)
        else:
            return
    for call in spins:
        work.done.update(node.id for node in walk(call))
        work.replace(call, "rospy.spin()")
    for statement in (statement_of(made), *gone):
        work.delete(statement)
