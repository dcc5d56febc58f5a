"""From rospy to rclpy: what a file does beside its callbacks.

rospy calls callbacks from the moment that a subscriber is made; rclpy while it spins.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from tree_sitter import Node

from .port_state import Work

_QUESTIONS = frozenset({"input", "raw_input"})
_TAKES_LONG = _QUESTIONS | frozenset(
    {
        "time.sleep",
        "rospy.sleep",
        "rospy.wait_for_service",
        "matplotlib.pyplot.show",
        "matplotlib.pyplot.pause",
        "pylab.show",
        "os.system",
        "subprocess.call",
        "subprocess.run",
        "subprocess.check_call",
    }
)
_LOOPS = frozenset({"exec_", "mainloop", "serve_forever", "waitKey", "wait_for_service"})
"""Methods that run until somebody ends them: of windows, and of servers."""


def is_busy_before_spin(work: Work, listens: set[int], spins: set[int]) -> bool:
    """Tell whether the main line does what takes long between an endpoint and `rospy.spin`.

    Args:
        work: the file.
        listens: the ids of the calls that make what calls functions of the file.
        spins: the ids of the calls of `rospy.spin`.
    """
    is_listening = False
    for node in _main_line(work):
        if node.id in spins:
            return False
        is_listening |= node.id in listens
        if is_listening and (node.type == "while_statement" or _takes_long(work, node)):
            return True
    return False


def asks_user(work: Work) -> bool:
    """Tell whether the file waits for what its user enters, outside of callbacks."""
    return any(
        work.slice(callee) in _QUESTIONS and not work.is_in_callback(call)
        for call in work.analysis.captures.get("call", [])
        if (callee := call.child_by_field_name("function")) is not None
    )


def _takes_long(work: Work, node: Node) -> bool:
    callee = node.child_by_field_name("function") if node.type == "call" else None
    if callee is None:
        return False
    names = {work.slice(callee), *work.qualified(callee)}
    return bool(names & _TAKES_LONG) or work.slice(callee).rpartition(".")[2] in _LOOPS


def _main_line(work: Work) -> Iterator[Node]:
    """Yield what runs, in its order, and in the functions of the file that it calls, once."""
    bodies: dict[str, list[Node]] = defaultdict(list)
    for scope in work.analysis.scopes.all:
        body = scope.node.child_by_field_name("body")
        if scope.kind == "function" and body is not None:
            is_maker = scope.name == "__init__" and scope.parent is not None
            bodies[scope.parent.name if is_maker and scope.parent else scope.name].append(body)
    pending = [(work.analysis.syntax.root, False)]
    while pending:
        node, is_run = pending.pop()
        if not is_run and node.type not in ("function_definition", "lambda"):
            pending.append((node, True))
            pending += [(each, False) for each in reversed(node.named_children)]
        elif is_run:
            yield node
            callee = node.child_by_field_name("function") if node.type == "call" else None
            name = work.slice(callee).rpartition(".")[2] if callee is not None else ""
            pending += [(each, False) for each in reversed(bodies.pop(name, []))]
