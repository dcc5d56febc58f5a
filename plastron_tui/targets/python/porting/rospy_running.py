"""From rclpy to rospy: what runs the nodes, and what ends them."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.splices import Splice, line_start
from plastron_tui.sources.python.syntax import parts_of

from .contexts import port_context
from .port_state import Work, walk
from .rospy_endings import leave_empty_clauses, port_shutdown

_INTERRUPTS = (
    "rclpy.executors.ExternalShutdownException",
    "rclpy.exceptions.ROSInterruptException",
)


def port_rospy_running(work: Work) -> None:
    """Rewrite what runs the nodes, outside of callbacks."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is None or work.is_in_callback(call):
            continue
        names = set(work.qualified(callee))
        statement = statement_of(call)
        is_alone = statement.type == "expression_statement" and statement.named_children == [call]
        if names & {"rclpy.init"} and is_alone:
            work.delete(statement)
        elif names & {"rclpy.init"}:
            port_context(work, call)
        elif names & {"rclpy.spin_once"} and is_alone:
            _port_spin_once(work, call)
        elif names & {"rclpy.spin"}:
            _port_spin(work, call, statement if is_alone else None)
        elif names & {"rclpy.shutdown", "rclpy.try_shutdown"}:
            port_shutdown(work, call, is_alone=is_alone)
        elif callee.type == "attribute":
            _port_method(work, call, callee, statement if is_alone else None)
    for node in walk(work.analysis.syntax.root):
        parent = node.parent
        if parent is None or node.type not in ("identifier", "attribute"):
            continue
        is_caught = parent.type in ("except_clause", "as_pattern", "tuple")
        if is_caught and set(work.qualified(node)) & set(_INTERRUPTS):
            work.replace(node, "rospy.ROSInterruptException")
    leave_empty_clauses(work)


def _port_spin_once(work: Work, call: Node) -> None:
    """Wait as long as for what comes, which rospy handles in threads of its own."""
    arguments = Arguments.of(call, work.analysis.syntax)
    given, limit = arguments.get(Argument(0, "node")), arguments.get(Argument(-1, "timeout_sec"))
    if arguments.is_open or given is None or given.type not in ("identifier", "attribute"):
        return
    statement = statement_of(call)
    body = statement.parent
    loop = body.parent if body is not None else None
    is_loop = loop is not None and loop.type == "while_statement"
    is_idle = body is not None and body.named_children == [statement]
    if is_loop and is_idle:
        # The loop asks again as soon as what it waits for may have come.
        work.replace(call, "rospy.sleep(0.1)")
    elif limit is not None and limit.type != "none":
        work.replace(call, f"rospy.sleep({work.text(limit)})")
        if is_loop and work.slice(limit) not in ("0", "0.0"):
            work.mark(call, "spin_once ends at the first message", _SPIN_ONCE)


_SPIN_ONCE = "`rospy.sleep` waits as long as it is told: wait for what the callback sets"


def _port_spin(work: Work, call: Node, alone: Node | None) -> None:
    """Spin without the node; an argument that makes the node is evaluated before."""
    arguments = call.child_by_field_name("arguments")
    given = parts_of(arguments)
    first = given[0] if given else None
    if first is not None and first.type == "keyword_argument":
        first = first.child_by_field_name("value")
    if first is None or first.type == "attribute" or first.type == "identifier":
        work.replace(call, "rospy.spin()")
        return
    text = work.analysis.syntax.text
    opening, closing = ("", "") if first.type == "call" else ("(", ")")
    if alone is None:
        opening, closing = "(" + opening, closing + ", rospy.spin())[1]"
    else:
        indent = text[line_start(text, alone.start_byte) : alone.start_byte]
        gap = "; " if indent.strip() else "\n" + indent.decode("ascii", "replace")
        closing += f"{gap}rospy.spin()"
    # What is in the argument may be rewritten itself, so only the text around it goes.
    work.done.add(call.id)
    encode = work.analysis.syntax.encode
    work.cut(Splice(call.start_byte, first.start_byte, encode(opening)))
    work.cut(Splice(first.end_byte, call.end_byte, encode(closing)))


def _port_method(work: Work, call: Node, callee: Node, alone: Node | None) -> None:
    part = callee.child_by_field_name("attribute")
    name = work.slice(part) if part is not None else ""
    if name == "destroy_node" and alone is not None and not _is_own(work, callee):
        holder = callee.child_by_field_name("object")
        if holder is not None and holder.type == "call" and "super" not in work.slice(holder):
            work.cut(Splice(holder.end_byte, call.end_byte))
        else:
            work.delete(alone)
    elif name == "create_rate":
        arguments = call.child_by_field_name("arguments")
        inner = work.text(arguments) if arguments is not None else "()"
        work.replace(call, f"rospy.Rate{inner}")


def _is_own(work: Work, callee: Node) -> bool:
    """Tell whether a method may be one of the file, which ends more than the node."""
    holder = callee.child_by_field_name("object")
    is_base = holder is not None and work.slice(holder).startswith("super(")
    return not is_base and any(each.name == "destroy_node" for each in work.analysis.scopes.all)
