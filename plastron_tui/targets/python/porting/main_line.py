"""From rospy to rclpy: what a file does beside its callbacks.

rospy calls callbacks from the moment that a subscriber is made; rclpy while it spins.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.python.syntax import FUNCTIONS

from .port_state import Work, walk

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

_TURNS = "callbacks of rclpy take turns: it takes groups of their own and several threads"


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
        if not is_run and node.type not in FUNCTIONS:
            pending.append((node, True))
            pending += [(each, False) for each in reversed(node.named_children)]
        elif is_run:
            yield node
            callee = node.child_by_field_name("function") if node.type == "call" else None
            name = work.slice(callee).rpartition(".")[2] if callee is not None else ""
            pending += [(each, False) for each in reversed(bodies.pop(name, []))]


def mark_waiting_loops(work: Work) -> None:
    """Mark a loop of a callback that waits for what another callback sets: those take turns."""
    names = {key: _assigned(work, each.node) for key, each in work.callbacks.items()}
    setting = Counter(name for each in names.values() for name in each)
    for key, function in work.callbacks.items():
        set_elsewhere = {name for name, count in setting.items() if count > (name in names[key])}
        for loop in walk(function.node):
            if loop.type == "while_statement" and set_elsewhere & _read(work, loop):
                work.mark(loop, "waits for another callback", _TURNS)


def _assigned(work: Work, place: Node) -> set[str]:
    """Return the attributes and global names that a function sets."""
    targets = (
        each.child_by_field_name("left") for each in walk(place) if each.type == "assignment"
    )
    shared = {
        work.slice(name)
        for each in walk(place)
        if each.type == "global_statement"
        for name in each.named_children
    }
    names = {work.slice(each): each.type for each in targets if each is not None}
    return {name for name, kind in names.items() if kind == "attribute" or name in shared}


def _read(work: Work, place: Node) -> set[str]:
    names = (each for each in walk(place) if each.type in ("identifier", "attribute"))
    return {work.slice(each) for each in names}
