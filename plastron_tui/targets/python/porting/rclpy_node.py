"""From rospy to rclpy: what makes the node, and what runs it."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python import literals
from plastron_tui.sources.python.analysis import NodeSite
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.syntax import parts_of

from .insertion_point import first_call, top_level
from .port_state import COMMENT, Mark, Work, first_of, walk
from .rewriting import begins_line, first_statement, put_before, replace_by_opposite

_INTERRUPT = ("rospy.ROSInterruptException", "rospy.exceptions.ROSInterruptException")
_INTERRUPTS = "KeyboardInterrupt, ExternalShutdownException, ROSInterruptException"

_SPIN = """\
def {spin}():
    \"\"\"Handle what comes until ROS ends; log what a callback raises.\"\"\"
    while rclpy.ok():
        try:
            rclpy.spin({node})
        except (KeyboardInterrupt, ExternalShutdownException):
            break
        except Exception:
            if rclpy.ok():
                {node}.get_logger().error(traceback.format_exc())
"""
_THREAD = """\
def {thread}():
    \"\"\"Handle what comes in a thread, until the program ends.\"\"\"
    thread = threading.Thread(target={spin}, daemon=True)
    thread.start()
    atexit.register(thread.join)
    atexit.register(rclpy.try_shutdown)
"""
# The handler of rclpy does not wake what sleeps at a rate.
_TERM = """\
    signal.signal(signal.SIGTERM, lambda number, frame: rclpy.try_shutdown())
"""
_WAIT = """\
def {wait}():
    \"\"\"Wait until ROS ends, while a thread handles what comes.\"\"\"
    try:
        while rclpy.ok():
            time.sleep(0.1)
    except KeyboardInterrupt:
        pass
"""


def port_running(work: Work, node: str) -> bool:
    """Rewrite what runs the node, outside of callbacks; tell whether a thread has to spin."""
    anywhere = ("rospy.is_shutdown", "rospy.signal_shutdown")
    calls: dict[str, list[Node]] = {name: [] for name in ("rospy.spin", "rospy.Rate", *anywhere)}
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is not None:
            is_free = not work.is_in_callback(call)
            for name in work.qualified(callee):
                found = name.replace("rospy.client.", "rospy.").replace("rospy.core.", "rospy.")
                found = found.replace("rospy.timer.", "rospy.")
                if found in calls and (is_free or found in anywhere):
                    calls[found].append(call)
            if is_free and "roslib.load_manifest" in work.qualified(callee):
                work.delete(statement_of(call))
    listens = {EndpointKind.SUBSCRIPTION, EndpointKind.SERVICE, EndpointKind.TIMER}
    is_listening = any(site.endpoint.kind in listens for site in work.analysis.sites)
    in_thread = bool(calls["rospy.Rate"]) or (is_listening and not calls["rospy.spin"])
    spin, wait = work.free_name("spin"), work.free_name("wait")
    for call in calls["rospy.Rate"]:
        callee = call.child_by_field_name("function")
        given = parts_of(call.child_by_field_name("arguments"))
        if callee is not None:
            work.replace(callee, f"{node}.create_rate")
        for each in given[1:] + [each for each in given[:1] if each.type == "keyword_argument"]:
            work.mark(call, work.slice(each).partition("=")[0], "`create_rate` takes a frequency")
    for call in calls["rospy.is_shutdown"]:
        replace_by_opposite(work, call, "rclpy.ok()")
    for call in calls["rospy.signal_shutdown"]:
        work.replace(call, "rclpy.try_shutdown()")
    _port_handed_over(work)
    for call in calls["rospy.spin"]:
        work.replace(call, f"{wait}()" if in_thread else f"{spin}()")
    if in_thread or calls["rospy.spin"]:
        work.helpers.append(_SPIN.format(spin=spin, node=node))
        work.imports.add("from rclpy.executors import ExternalShutdownException")
        work.imports.add("import traceback")
    if in_thread:
        thread = work.free_name("spin_in_thread")
        has_signals = any(
            b"disable_signals" in (each.call.text or b"")
            for each in work.analysis.nodes
            if each.call
        )
        work.helpers.append(
            _THREAD.format(thread=thread, spin=spin) + ("" if has_signals else _TERM)
        )
        work.imports.update(("import atexit", "import threading"))
        if not has_signals:
            work.imports.add("import signal")
    if in_thread and calls["rospy.spin"]:
        work.helpers.append(_WAIT.format(wait=wait))
        work.imports.add("import time")
    _port_interrupts(work)
    return in_thread


def _port_handed_over(work: Work) -> None:
    """Rewrite `rospy.signal_shutdown` where it is an argument, of what starts a thread, say."""
    for node in walk(work.analysis.syntax.root):
        is_name = node.type in ("attribute", "identifier")
        is_argument = node.parent is not None and node.parent.type == "argument_list"
        if is_name and is_argument and "rospy.signal_shutdown" in work.qualified(node):
            work.replace(node, "lambda reason: rclpy.try_shutdown()")


def _port_interrupts(work: Work) -> None:
    """Rewrite `except rospy.ROSInterruptException`."""
    for node in walk(work.analysis.syntax.root):
        if node.type not in ("attribute", "identifier") or node.parent is None:
            continue
        parent = node.parent
        if parent.type not in ("except_clause", "as_pattern", "tuple"):
            continue
        if not set(work.qualified(node)) & set(_INTERRUPT):
            continue
        outer = parent.parent.type if parent.parent is not None else ""
        if parent.type == "except_clause" or outer == "except_clause":
            is_item = parent.type == "tuple"
            has_first = is_item and "KeyboardInterrupt" in work.slice(parent)
            names = _INTERRUPTS.partition(", ")[2] if has_first else _INTERRUPTS
            work.replace(node, names if is_item else f"({names})")
            work.imports.add("from rclpy.executors import ExternalShutdownException")
            work.imports.add("from rclpy.exceptions import ROSInterruptException")


def make_node(work: Work, node: str, *, in_thread: bool) -> None:
    """Make the node where it is there before all that needs it."""
    inits = [each for each in work.analysis.nodes if each.call is not None]
    sites = [site.call for site in work.analysis.sites]
    if not inits:
        first = first_of(sites)
        work.constants.append(f"{node} = None")
        if first is not None:
            work.mark(first, "the node", f"set `{node}` to the node, which no line of it makes")
        return
    is_global = any(init.scope.enclosing("function") is not None for init in inits)
    if is_global and not _module_sites(work, inits[0]):
        work.constants.append(f"{node} = None")
    for init in inits:
        _place(work, init, node, in_thread, can_move=len(inits) == 1)


def _place(work: Work, init: NodeSite, node: str, in_thread: bool, *, can_move: bool) -> None:
    assert init.call is not None
    statement = statement_of(init.call)
    written = init.expression if init.name is None else literals.string(init.name)
    lines = ["rclpy.init()", f"{node} = rclpy.create_node({written or literals.string('node')})"]
    if in_thread:
        lines.append(f"{work.free_name('spin_in_thread')}()")
    for option in _options(work, init, node, lines):
        remedy = _OPTIONS.get(option)
        work.marks.append(Mark(init.call, option, remedy, has_comment=True))
        lines.insert(1, f"{COMMENT}{option}")
    work.done.add(init.call.id)
    function = init.scope.enclosing("function")
    anchor = _anchor(work, init) if can_move and init.name is not None else statement
    if function is not None and anchor.start_byte >= function.start:
        body = function.node.child_by_field_name("body")
        assert body is not None
        put_before(work, first_statement(body), [f"global {node}"])
    if anchor.id == statement.id and not begins_line(work, statement):
        work.replace(statement, "; ".join(line for line in lines if line[0] != "#"))
        return
    put_before(work, anchor, lines)
    if statement.type == "expression_statement":
        work.delete(statement)


_OPTIONS = {"anonymous": "ROS 2 makes no name unique: start the node under a name of its own"}


def _options(work: Work, init: NodeSite, node: str, lines: list[str]) -> list[str]:
    """Return the options of `init_node` that have to be ported by hand.

    The name of an anonymous node ends in the number of its process, as it does in rospy.
    """
    assert init.call is not None
    options = []
    for each in parts_of(init.call.child_by_field_name("arguments"))[1:]:
        name, value = each.child_by_field_name("name"), each.child_by_field_name("value")
        option = work.slice(name) if name is not None else "options of the node"
        given = work.slice(value) if value is not None else ""
        if (option, given) == ("anonymous", "True") and init.expression:
            named = f'f"{init.name}_{{os.getpid()}}"'
            if init.name is None:
                named = f'f"{{{init.expression}}}_{{os.getpid()}}"'
            if init.name is not None or init.expression.isidentifier():
                lines[1] = f"{node} = rclpy.create_node({named})"
                work.imports.add("import os")
                continue
        if (option, given) == ("disable_signals", "True"):
            lines[0] = "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)"
            work.imports.add("from rclpy.signals import SignalHandlerOptions")
            continue
        if option not in ("name", "node_name") and given != "False":
            options.append(option)
    return options


def _anchor(work: Work, init: NodeSite) -> Node:
    """Return the statement before which the node is made: no endpoint is made before it."""
    assert init.call is not None
    early = _module_sites(work, init)
    function = init.scope.enclosing("function")
    if early:
        return top_level(early[0])
    if function is not None:
        body = function.node.child_by_field_name("body")
        assert body is not None
        return first_statement(body)
    top = top_level(init.call)
    body = top.child_by_field_name("consequence") or top.child_by_field_name("body")
    if body is not None and body.named_child_count:
        return first_statement(body)
    return first_call(work, top)


def has_node(work: Work, place: Node) -> bool:
    """Tell whether the node is made for sure where a place of the file is run.

    A function is taken to run behind it, where it does not make the node itself; so is a node
    that no line of the file makes.
    """
    function = work.scope(place).enclosing("function")
    inits = [each for each in work.analysis.nodes if each.call is not None]
    anchors = []
    for init in inits:
        assert init.call is not None
        can_move = len(inits) == 1 and init.name is not None
        anchors.append(_anchor(work, init) if can_move else statement_of(init.call))
    if function is None and work.scope(place).enclosing("lambda") is not None:
        return True
    if function is not None:
        anchors = [each for each in anchors if function.start <= each.start_byte < function.end]
        return all(each.start_byte <= place.start_byte for each in anchors)
    return any(
        work.scope(each).enclosing("function") is None and each.start_byte <= place.start_byte
        for each in anchors
    )


def _module_sites(work: Work, init: NodeSite) -> list[Node]:
    """Return the endpoints that the module makes itself, before the statement with `init_node`."""
    assert init.call is not None
    top = top_level(init.call)
    is_in_function = init.scope.enclosing("function") is not None
    return [
        site.call
        for site in work.analysis.sites
        if site.scope.enclosing("function") is None
        and top_level(site.call).id != top.id
        and (is_in_function or site.call.start_byte < top.start_byte)
    ]
