"""From rospy to rclpy: the endpoints, the node behind them, and what runs it."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.targets import literals
from plastron_tui.targets.python.calls import Argument
from plastron_tui.targets.python.scopes import Scope
from plastron_tui.targets.python.sites import NodeSite, Site
from plastron_tui.targets.python.splices import line_start

from .leftovers import mark_leftovers, mark_plain_publishing
from .placing import add_header, first_call, top_level
from .types import port_imports
from .work import COMMENT, Mark, Work, first_of, statement_of, walk

_GONE = frozenset({"rospy", "roslib"})
_LEFT = _GONE | {"actionlib", "rosgraph", "rosnode", "rosservice", "rostopic", "rosparam", "genpy"}
_LEFT |= {"tf", "tf2_ros", "dynamic_reconfigure", "roslaunch", "rosbag"}

_INTERRUPT = ("rospy.ROSInterruptException", "rospy.exceptions.ROSInterruptException")
_INTERRUPTS = "KeyboardInterrupt, ExternalShutdownException, ROSInterruptException"

_ATTRIBUTES = {
    "secs": "a time of ROS 2 has `sec`",
    "nsecs": "a time of ROS 2 has `nanosec`",
    "to_sec": "a time of ROS 2 has `sec` and `nanosec`",
    "to_nsec": "a time of ROS 2 has `sec` and `nanosec`",
    "seq": "a header of ROS 2 has no `seq`",
    "get_num_connections": "`get_subscription_count` of a publisher",
    "unregister": "`destroy` of the endpoint",
}

_SPIN = """\
def {spin}():
    \"\"\"Handle what comes, until ROS ends.\"\"\"
    try:
        rclpy.spin({node})
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
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


def port_to_rclpy(work: Work) -> None:
    """Rewrite what makes a rospy node and its endpoints, and mark the rest of rospy."""
    node = work.free_name("node")
    port_imports(work, _GONE)
    runs_in_thread = _port_running(work, node)
    for site in reversed(work.analysis.sites):
        _port_site(work, site, node)
    _make_node(work, node, runs_in_thread)
    mark_plain_publishing(work)
    mark_leftovers(work, _LEFT, _ATTRIBUTES, _remedies(node))
    work.imports.add("import rclpy")
    add_header(work)


def _remedies(node: str) -> dict[str, str]:
    log = {
        f"rospy.{old}": f"`{node}.get_logger().{new}(...)`, with one text"
        for old, new in {
            "loginfo": "info",
            "logwarn": "warning",
            "logerr": "error",
            "logdebug": "debug",
            "logfatal": "fatal",
        }.items()
    }
    return log | {
        "rospy.Time.now": f"`{node}.get_clock().now().to_msg()`",
        "rospy.get_rostime": f"`{node}.get_clock().now().to_msg()`",
        "rospy.get_time": f"`{node}.get_clock().now().nanoseconds / 1e9`",
        "rospy.get_param": f"`{node}.declare_parameter(name, default).value`",
        "rospy.sleep": "`time.sleep(...)`",
        "rospy.is_shutdown": "`not rclpy.ok()`",
        "rospy.wait_for_service": "`wait_for_service` of the client",
        "rospy.on_shutdown": "`rclpy.get_default_context().on_shutdown(...)`",
        "rospy.get_name": f"`{node}.get_name()`",
        "rospy.Duration": "`rclpy.duration.Duration(seconds=...)`",
        "rospy.signal_shutdown": "`rclpy.shutdown()`",
        "rospy.Rate": f"`{node}.create_rate(...)`",
        "actionlib": "`rclpy.action`",
        "tf": "`tf2_ros`",
    }


def _port_site(work: Work, site: Site, node: str) -> None:
    """Rewrite the call that makes an endpoint."""
    if site.endpoint.kind not in _WRITERS or site.arguments.is_open:
        return
    given = {
        key: site.arguments.get(argument)
        for key, argument in (("name", site.shape.name), ("type", site.shape.type))
        if argument is not None
    }
    name, type_ = given.get("name"), given.get("type")
    if name is None or (type_ is None and site.shape.type is not None):
        return
    wanted = _WRITERS[site.endpoint.kind](work, site, node, _name(work, site, name))
    if wanted is not None:
        work.replace(site.call, wanted)


def _name(work: Work, site: Site, name: Node) -> str:
    """Write the name; a private one has a slash behind its `~` in ROS 2."""
    written = work.text(name)
    if site.endpoint.name is not None and site.endpoint.name.startswith("~"):
        if name.type == "string" and "~" in written:
            return written.replace("~/", "~").replace("~", "~/", 1)
        work.mark(site.call, "a private name", "ROS 2 writes `~/name`, with a slash")
    return written


def _publisher(work: Work, site: Site, node: str, name: str) -> str | None:
    _mark_options(work, site, {"latch": "`DurabilityPolicy.TRANSIENT_LOCAL` in a `QoSProfile`"})
    return f"{node}.create_publisher({_type(work, site)}, {name}, {_depth(work, site, 7)})"


def _subscription(work: Work, site: Site, node: str, name: str) -> str | None:
    type_ = _type(work, site)
    callee = site.shape.callees[0]
    if callee == "message_filters.Subscriber":
        if (
            site.shape.callback is None
            and "wait_for_message" in work.slice(site.call).split("(")[0]
        ):
            timeout = site.arguments.get(Argument(2, "timeout"))
            work.imports.add("from rclpy.wait_for_message import wait_for_message")
            limit = f", time_to_wait={work.text(timeout)}" if timeout is not None else ""
            return f"wait_for_message({type_}, {node}, {name}{limit})[1]"
        function = site.call.child_by_field_name("function")
        assert function is not None
        return f"{work.slice(function)}({node}, {type_}, {name})"
    callback = site.arguments.get(Argument(2, "callback"))
    extra = site.arguments.get(Argument(3, "callback_args"))
    called = work.text(callback) if callback is not None else "lambda message: None"
    if extra is not None and callback is not None:
        called = f"lambda message: {_called(called)}(message, {work.text(extra)})"
    return f"{node}.create_subscription({type_}, {name}, {called}, {_depth(work, site, 4)})"


def _service(work: Work, site: Site, node: str, name: str) -> str | None:
    handler = site.arguments.get(Argument(2, "handler"))
    if handler is None:
        return None
    called = work.text(handler)
    function = work.callback_of(site)
    if function is None:
        called = f"lambda request, response: {_called(called)}(request)"
    else:
        _append_parameter(work, function, "response=None")
        _mark_returns(work, function)
    return f"{node}.create_service({_type(work, site)}, {name}, {called})"


def _client(work: Work, site: Site, node: str, name: str) -> str | None:
    return f"{node}.create_client({_type(work, site)}, {name})"


def _timer(work: Work, site: Site, node: str, name: str) -> str | None:
    period = site.arguments.get(site.shape.name)
    callback = site.arguments.get(Argument(1, "callback"))
    if period is None or callback is None:
        return None
    _mark_options(work, site, {"oneshot": "cancel the timer when it is called"})
    called = work.text(callback)
    function = work.callback_of(site)
    if function is None:
        called = f"lambda: {_called(called)}(None)"
    else:
        _give_default(work, function)
    return f"{node}.create_timer({_seconds(work, period)}, {called})"


_WRITERS = {
    EndpointKind.PUBLISHER: _publisher,
    EndpointKind.SUBSCRIPTION: _subscription,
    EndpointKind.SERVICE: _service,
    EndpointKind.CLIENT: _client,
    EndpointKind.TIMER: _timer,
}


def _type(work: Work, site: Site) -> str:
    given = site.arguments.get(site.shape.type) if site.shape.type is not None else None
    callee = given.child_by_field_name("function") if given is not None else None
    if given is not None and callee is not None:
        listed = given.child_by_field_name("arguments")
        if "rospy.numpy_msg.numpy_msg" in work.qualified(callee) and listed is not None:
            work.done.add(given.id)
            work.mark(given, "numpy_msg", "rclpy gives an array of numbers as a numpy array itself")
            return work.text(listed)[1:-1]
    return work.text(given) if given is not None else ""


def _called(text: str) -> str:
    """Write an expression so that it can be called."""
    return text if text.replace(".", "").isidentifier() else f"({text})"


def _depth(work: Work, site: Site, position: int) -> str:
    """Write the depth of the queue; rospy's `None` is no end, which ROS 2 does not have."""
    given = site.arguments.get(Argument(position, "queue_size"))
    text = work.text(given) if given is not None else "10"
    return "10" if text in ("None", "0") else text


def _mark_options(work: Work, site: Site, options: dict[str, str]) -> None:
    for name, remedy in options.items():
        if name in site.arguments.keywords:
            work.mark(site.call, name, remedy)


def _seconds(work: Work, period: Node) -> str:
    """Write a period in seconds: what is in `rospy.Duration(…)`."""
    callee = period.child_by_field_name("function") if period.type == "call" else None
    arguments = period.child_by_field_name("arguments")
    if callee is not None and arguments is not None and arguments.named_child_count == 1:
        names = work.qualified(callee)
        if set(names) & {"rospy.Duration", "rospy.Duration.from_sec"}:
            [given] = arguments.named_children
            is_named = given.type == "keyword_argument"
            value = given.child_by_field_name("value") if is_named else given
            work.done.add(period.id)
            return work.text(value or given)
    work.mark(period, "a period in seconds", "a timer of ROS 2 takes a number of seconds")
    return work.text(period)


def _append_parameter(work: Work, function: Scope, parameter: str) -> None:
    """Let a function take one argument more."""
    listed = function.node.child_by_field_name("parameters")
    if listed is None or listed.id in work.done:
        return
    work.done.add(listed.id)
    children = [each for each in listed.named_children if each.type != "comment"]
    if any("splat" in each.type or each.type == "keyword_separator" for each in children):
        return
    if children:
        work.insert(children[-1].end_byte, f", {parameter}")
    else:
        work.insert(listed.start_byte + 1, parameter)


def _give_default(work: Work, function: Scope) -> None:
    """Let a timer's callback be called without its event."""
    listed = function.node.child_by_field_name("parameters")
    if listed is None or listed.id in work.done:
        return
    work.done.add(listed.id)
    children = [each for each in listed.named_children if each.type != "comment"]
    own = children[1:] if function.self_name else children
    if own and own[0].type == "identifier":
        work.insert(own[0].end_byte, "=None")
        _mark_event(work, function, work.slice(own[0]))


def _mark_event(work: Work, function: Scope, event: str) -> None:
    """Mark what a timer's callback asks of its event."""
    for node in walk(function.node):
        holder = node.child_by_field_name("object") if node.type == "attribute" else None
        if holder is not None and work.slice(holder) == event:
            work.mark(node, work.slice(node), "a timer of ROS 2 hands over no event")


def _mark_returns(work: Work, function: Scope) -> None:
    """Mark what a handler returns, where it is no response for sure."""
    pending = list(function.node.named_children)
    made = {
        name
        for name, bindings in function.bindings.items()
        if bindings and all(_is_response(work, each.value) for each in bindings)
    }
    while pending:
        node = pending.pop()
        if node.type in ("function_definition", "lambda", "class_definition"):
            continue
        if node.type == "return_statement":
            value = node.named_children[0] if node.named_child_count else None
            is_named = value is not None and work.slice(value) in made
            if not is_named and not _is_response(work, value):
                work.mark(node, "return a response", "a handler of rclpy returns a response")
        pending.extend(node.named_children)


def _is_response(work: Work, value: Node | None) -> bool:
    callee = value.child_by_field_name("function") if value is not None else None
    if callee is None:
        return False
    return any(
        ".srv." in f".{name}" and name.endswith("Response") for name in work.qualified(callee)
    )


def _port_running(work: Work, node: str) -> bool:
    """Rewrite what runs the node, outside of callbacks; tell whether a thread has to spin."""
    calls: dict[str, list[Node]] = {"rospy.spin": [], "rospy.is_shutdown": [], "rospy.Rate": []}
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is not None and not work.is_in_callback(call):
            for name in work.qualified(callee):
                found = name.replace("rospy.client.", "rospy.").replace("rospy.core.", "rospy.")
                found = found.replace("rospy.timer.", "rospy.")
                if found in calls:
                    calls[found].append(call)
            if "roslib.load_manifest" in work.qualified(callee):
                work.delete(statement_of(call))
    listens = {EndpointKind.SUBSCRIPTION, EndpointKind.SERVICE, EndpointKind.TIMER}
    is_listening = any(site.endpoint.kind in listens for site in work.analysis.sites)
    in_thread = bool(calls["rospy.Rate"]) or (is_listening and not calls["rospy.spin"])
    spin, wait = work.free_name("spin"), work.free_name("wait")
    for call in calls["rospy.Rate"]:
        arguments = call.child_by_field_name("arguments")
        inner = work.text(arguments)[1:-1] if arguments is not None else ""
        work.replace(call, f"{node}.create_rate({inner})")
    for call in calls["rospy.is_shutdown"]:
        _port_is_shutdown(work, call)
    for call in calls["rospy.spin"]:
        work.replace(call, f"{wait}()" if in_thread else f"{spin}()")
    if in_thread or calls["rospy.spin"]:
        work.helpers.append(_SPIN.format(spin=spin, node=node))
        work.imports.add("from rclpy.executors import ExternalShutdownException")
    if in_thread and calls["rospy.spin"]:
        work.helpers.append(_WAIT.format(wait=wait))
        work.imports.add("import time")
    _port_interrupts(work)
    return in_thread


def _port_is_shutdown(work: Work, call: Node) -> None:
    parent = call.parent
    if parent is not None and parent.type == "not_operator":
        work.done.add(call.id)
        work.replace(parent, "rclpy.ok()")
    else:
        is_condition = parent is not None and parent.type in ("if_statement", "while_statement")
        work.replace(call, "not rclpy.ok()" if is_condition else "(not rclpy.ok())")


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
            work.replace(node, _INTERRUPTS if is_item else f"({_INTERRUPTS})")
            work.imports.add("from rclpy.executors import ExternalShutdownException")
            work.imports.add("from rclpy.exceptions import ROSInterruptException")


def _make_node(work: Work, node: str, in_thread: bool) -> None:
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
        spin = work.free_name("spin")
        lines.append(f"threading.Thread(target={spin}, daemon=True).start()")
        work.imports.add("import threading")
    if b"anonymous" in (init.call.text or b""):
        remedy = "ROS 2 makes no name unique: start the node under a name of its own"
        work.marks.append(Mark(init.call, "anonymous", remedy, has_comment=True))
        lines.insert(1, f"{COMMENT}anonymous")
    work.done.add(init.call.id)
    function = init.scope.enclosing("function")
    anchor = _anchor(work, init) if can_move and init.name is not None else statement
    if function is not None and anchor.start_byte >= function.start:
        body = function.node.child_by_field_name("body")
        assert body is not None
        _put_before(work, _first_statement(body), [f"global {node}"])
    if anchor.id == statement.id and not _begins_line(work, statement):
        work.replace(statement, "; ".join(line for line in lines if line[0] != "#"))
        return
    _put_before(work, anchor, lines)
    if statement.type == "expression_statement":
        work.delete(statement)


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
        return _first_statement(body)
    top = top_level(init.call)
    body = top.child_by_field_name("consequence") or top.child_by_field_name("body")
    if body is not None and body.named_child_count:
        return _first_statement(body)
    return first_call(work, top)


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


def _first_statement(body: Node) -> Node:
    """Return the first statement of a block, behind its docstring."""
    statements = [each for each in body.named_children if each.type != "comment"]
    first = statements[0]
    is_docstring = first.type == "expression_statement" and bool(
        first.named_children and first.named_children[0].type == "string"
    )
    return statements[1] if is_docstring and len(statements) > 1 else first


def _begins_line(work: Work, statement: Node) -> bool:
    text = work.analysis.syntax.text
    return not text[line_start(text, statement.start_byte) : statement.start_byte].strip()


def _put_before(work: Work, statement: Node, lines: list[str]) -> None:
    text = work.analysis.syntax.text
    if not _begins_line(work, statement):
        code = [line for line in lines if not line.startswith("#")]
        work.insert(statement.start_byte, "".join(f"{line}; " for line in code))
        return
    start = line_start(text, statement.start_byte)
    indent = text[start : statement.start_byte].decode("ascii", "replace")
    work.insert(start, "".join(f"{indent}{line}\n" for line in lines))
