"""From rospy to rclpy: the endpoints, the node behind them, and what runs it."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.references import is_member
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

from .action_uses import mark_action_uses
from .actions import mark_actions
from .arrays import port_arrays
from .endpoints import destroys_endpoints, mark_endpoint_attributes, port_endpoint_methods
from .insertion_point import add_header
from .leftovers import mark_leftovers, port_ending
from .main_line import mark_waiting_loops
from .other_modules import mark_other_modules
from .plain import port_plain
from .port_state import Work, walk
from .python_2 import port_python_2, port_statements
from .rclpy_node import make_node
from .rclpy_parameters import port_parameters
from .rclpy_running import port_running
from .rclpy_times import PARTS, port_times
from .rclpy_waits import Waits, find_waits, port_waits
from .rclpy_words import port_words
from .renamed_fields import port_fields
from .repetition import mark_repeated_endpoints
from .rewriting import (
    Writer,
    append_parameter,
    bound_early,
    callable_text,
    given_type,
    mark_options,
    parameters_of,
    port_sites,
)
from .times import rename_parts
from .types import keep_used_imports, leave_manifests, port_imports

_GONE = frozenset({"rospy", "roslib"})
_LEFT = _GONE | {"actionlib", "rosgraph", "rosnode", "rosservice", "rostopic", "rosparam", "genpy"}
_LEFT |= {"tf", "tf2_ros", "dynamic_reconfigure", "roslaunch", "rosbag"}

_ENDING = {"shutdown": "`cancel` of a timer, `destroy` of the others"}

# ROS 2 is of Python 3 only, which a plain `python` may not be.
_OLD_PYTHON = re.compile(rb"#![^\r\n]*\bpython(?=[ \t]*[\r\n])()")

_ATTRIBUTES = {
    "secs": "a time of ROS 2 has `sec`",
    "nsecs": "a time of ROS 2 has `nanosec`",
    "to_sec": "a time of ROS 2 has `sec` and `nanosec`",
    "to_nsec": "a time of ROS 2 has `sec` and `nanosec`",
    "seq": "a header of ROS 2 has no `seq`",
    "resolved_name": "`srv_name` of the client, `topic_name` of the others",
    "wait_for_service": "it takes `timeout_sec`, and tells whether the service is there",
    "get_num_connections": "`get_subscription_count` of a publisher",
    "unregister": "`destroy` of the endpoint",
    "_connection_header": "a message of ROS 2 does not say who sent it",
    "_md5sum": "a type of ROS 2 has a hash, and no such sum",
    "_full_text": "a class of ROS 2 does not hold its definition",
    "_type": "a class of ROS 2 does not hold its name",
    "_slot_types": "`get_fields_and_field_types()`",
    "_request_class": "`Request` of the service",
    "_response_class": "`Response` of the service",
}


def port_to_rclpy(work: Work) -> None:
    """Rewrite what makes a rospy node and its endpoints, and mark the rest of rospy."""
    node = work.free_name("node")
    port_imports(work, _GONE)
    leave_manifests(work)
    if old := _OLD_PYTHON.match(work.analysis.syntax.text):
        work.insert(old.end(1), "3")
    port_python_2(work)
    waits = find_waits(work)
    running = port_running(
        work,
        node,
        waits=waits.needs_thread,
        in_callbacks=waits.in_callbacks,
        destroys=bool(waits.messages) or destroys_endpoints(work),
    )
    port_parameters(work, node)
    rename_parts(work, PARTS)
    port_fields(work)
    port_words(work, node)
    port_times(work, node)
    port_plain(work)
    port_arrays(work)
    port_waits(work, waits, node)
    port_endpoint_methods(work, node)
    port_sites(work, _writers(node, waits), _private_name)
    make_node(work, node, running.starts, own_signals=running.own_signals)
    port_ending(work, {"shutdown": "cancel"}, _ENDING)
    mark_repeated_endpoints(work)
    mark_endpoint_attributes(work, {*_ATTRIBUTES, *_ENDING})
    mark_waiting_loops(work)
    mark_actions(work)
    mark_action_uses(work)
    mark_other_modules(work)
    mark_leftovers(work, _LEFT, _ATTRIBUTES, _remedies(node))
    keep_used_imports(work, _GONE)
    work.imports.add("import rclpy")
    add_header(work)
    port_statements(work)


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
        "rospy.Time.now": f"`{node}.get_clock().now()`, with `to_msg()` for a message",
        "rospy.get_rostime": f"`{node}.get_clock().now()`, with `to_msg()` for a message",
        "rospy.has_param": "a parameter with a default is always there",
        "rospy.set_param": "a parameter of ROS 2 is of one node",
        "rospy.get_time": f"`{node}.get_clock().now().nanoseconds / 1e9`",
        "rospy.get_param": f"`{node}.declare_parameter(name, default).value`, for one of the node",
        "rospy.sleep": "`time.sleep(...)`, with a number of seconds",
        "rospy.is_shutdown": "`not rclpy.ok()`",
        "rospy.wait_for_service": "`wait_for_service` of the client",
        "rospy.on_shutdown": "`rclpy.get_default_context().on_shutdown(...)`",
        "rospy.get_name": f"`{node}.get_name()`",
        "rospy.Duration": "`rclpy.duration.Duration(seconds=...)`",
        "rospy.signal_shutdown": "`rclpy.shutdown()`",
        "rospy.Rate": f"`{node}.create_rate(...)`",
        "actionlib.SimpleActionClient": "`rclpy.action.ActionClient(node, type, name)`",
        "actionlib.SimpleActionServer": "`rclpy.action.ActionServer(node, type, name, callback)`",
        "actionlib": "`rclpy.action`",
        "rospy.Time": "`rclpy.time.Time(seconds=...)`, with the clock's `clock_type`",
        "rospy.resolve_name": f"`{node}.resolve_topic_name(name)`",
        "rospy.get_published_topics": f"`{node}.get_topic_names_and_types()`",
        "rospy.AnyMsg": "a subscription of one type, with `raw=True`",
        "dynamic_reconfigure": f"`{node}.add_on_set_parameters_callback(...)`",
        "tf.transformations": "`tf_transformations`",
        "tf": "`tf2_ros`",
        "tf2_ros": "its listener and broadcasters take the node",
        "rosbag": "`rosbag2_py`",
    }


_WITH_SLASH = "ROS 2 writes `~/name`, with a slash"


def _private_name(work: Work, site: Site, name: Node) -> str:
    """Write a private name, which has a slash behind its `~` in ROS 2; in ROS 1 it is global."""
    written = work.text(name)
    is_global = str(site.endpoint.name).startswith("/")
    if name.type == "string" and "~" in written:
        return written.replace("~/", "/", 1) if is_global else written.replace("~", "~/", 1)
    remedy = f"ROS 1 reads it as `{site.endpoint.name}`" if is_global else _WITH_SLASH
    work.mark(site.call, "a private name", remedy)
    return written


def _writers(node: str, waits: Waits) -> dict[EndpointKind, Writer]:
    """Return what writes the calls, all of which are methods of the node."""
    writers: dict[EndpointKind, Callable[..., str | None]] = {
        EndpointKind.PUBLISHER: _publisher,
        EndpointKind.SUBSCRIPTION: partial(_subscription, waits),
        EndpointKind.SERVICE: _service,
        EndpointKind.CLIENT: partial(_client, waits.group),
        EndpointKind.TIMER: _timer,
    }
    return {kind: partial(writer, node) for kind, writer in writers.items()}


def _publisher(node: str, work: Work, site: Site, name: str) -> str | None:
    latch = site.arguments.get(Argument(4, "latch"))
    depth = _depth(work, site, 6)
    if latch is not None and work.slice(latch) == "True":
        # What is latched is the last message alone, however many may wait to be sent.
        depth = _kept(work)
    elif latch is not None and work.slice(latch) != "False":
        work.mark(site.call, "latch", "`DurabilityPolicy.TRANSIENT_LOCAL` in a `QoSProfile`")
    mark_options(work, site, _OPTIONS, ("latch", "queue_size", *_OF_TCP))
    return f"{node}.create_publisher({_type(work, site)}, {name}, {depth})"


def _subscription(waits: Waits, node: str, work: Work, site: Site, name: str) -> str | None:
    type_ = _type(work, site)
    if waits.is_message(site):
        timeout = site.arguments.get(Argument(2, "timeout"))
        limit = f", {work.text(timeout)}" if timeout is not None else ""
        depth = _latched(work, site) or 1
        taken = f"{type_}, {name}, lambda message: None, {depth}{waits.group}"
        made = f"{node}.create_subscription({taken})"
        return f"{waits.names['message']}({made}{limit})"
    if site.shape.gives_message:
        timeout = site.arguments.get(Argument(2, "timeout"))
        work.imports.add("from rclpy.wait_for_message import wait_for_message")
        limit = f", time_to_wait={work.text(timeout)}" if timeout is not None else ""
        if timeout is not None:
            work.mark(site.call, "timeout", "rclpy returns None where the time is up")
        return f"wait_for_message({type_}, {node}, {name}{limit})[1]"
    if site.shape.callees[0] == "message_filters.Subscriber":
        function = site.call.child_by_field_name("function")
        assert function is not None
        return f"{work.slice(function)}({node}, {type_}, {name})"
    callback = site.arguments.get(Argument(2, "callback"))
    extra = site.arguments.get(Argument(3, "callback_args"))
    mark_options(work, site, _OPTIONS, ("callback", "callback_args", "queue_size", *_OF_TCP))
    depth = _latched(work, site) or _depth(work, site, 4)
    called = work.text(callback) if callback is not None else "lambda message: None"
    if extra is not None and callback is not None:
        first, handler = bound_early(work, callback, "callback")
        second, given = bound_early(work, extra, "args")
        called = f"lambda message{first}{second}: {callable_text(handler)}(message, {given})"
    return f"{node}.create_subscription({type_}, {name}, {called}, {depth})"


# What ROS 1 latches by custom, and ROS 2 keeps for those that subscribe later.
_LATCHED = frozenset(
    {
        ("map", "nav_msgs/OccupancyGrid"),
        ("robot_description", "std_msgs/String"),
        ("tf_static", "tf2_msgs/TFMessage"),
    }
)


def _latched(work: Work, site: Site) -> str | None:
    """Return how to subscribe to what was published before, None for any other topic."""
    name = (site.endpoint.name or "").rpartition("/")[2]
    is_own = any(
        each.endpoint.kind is EndpointKind.PUBLISHER and each.endpoint.name == site.endpoint.name
        for each in work.analysis.sites
    )
    is_latched = (name, str(site.endpoint.type)) in _LATCHED and not is_own
    return _kept(work) if is_latched else None


def _kept(work: Work) -> str:
    work.imports.add("from rclpy.qos import DurabilityPolicy, QoSProfile")
    return "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)"


def _service(node: str, work: Work, site: Site, name: str) -> str | None:
    handler = site.arguments.get(Argument(2, "handler"))
    if handler is None:
        return None
    mark_options(work, site, _OPTIONS, ("handler",), 3)
    called = work.text(handler)
    function = work.callback_of(site)
    if function is None:
        bound, called = bound_early(work, handler, "handler")
        called = f"lambda request, response{bound}: {callable_text(called)}(request)"
    else:
        _take_response(work, function)
    return f"{node}.create_service({_type(work, site)}, {name}, {called})"


def _client(group: str, node: str, work: Work, site: Site, name: str) -> str | None:
    mark_options(work, site, _OPTIONS, (), 2)
    return f"{node}.create_client({_type(work, site)}, {name}{group})"


def _timer(node: str, work: Work, site: Site, name: str) -> str | None:
    period = site.arguments.get(site.shape.name)
    callback = site.arguments.get(Argument(1, "callback"))
    if period is None or callback is None:
        return None
    oneshot = site.arguments.get(Argument(2, "oneshot"))
    if oneshot is not None and work.slice(oneshot) != "False":
        work.mark(site.call, "oneshot", _OPTIONS["oneshot"])
    mark_options(work, site, _OPTIONS, ("callback", "oneshot"), 3)
    called = work.text(callback)
    function = work.callback_of(site)
    if function is None:
        _mark_handed_event(work, site, callback)
        bound, called = bound_early(work, callback, "callback")
        called = f"lambda{bound.removeprefix(',')}: {callable_text(called)}(None)"
    else:
        _give_default(work, function)
    return f"{node}.create_timer({_seconds(work, period)}, {called})"


def _type(work: Work, site: Site) -> str:
    given = site.arguments.get(site.shape.type) if site.shape.type is not None else None
    callee = given.child_by_field_name("function") if given is not None else None
    if given is not None and callee is not None:
        listed = given.child_by_field_name("arguments")
        if "rospy.numpy_msg.numpy_msg" in work.qualified(callee) and listed is not None:
            work.done.add(given.id)
            work.mark(given, "numpy_msg", "rclpy gives an array of numbers as a numpy array itself")
            return work.text(listed)[1:-1]
    return given_type(work, site)


def _depth(work: Work, site: Site, position: int) -> str:
    """Write the depth of the queue; rospy's `None` is no end, which ROS 2 does not have."""
    given = site.arguments.get(Argument(position, "queue_size"))
    folded = work.analysis.resolver.fold(given, site.scope) if given is not None else Known(None)
    is_endless = isinstance(folded, Known) and folded.value in (None, 0)
    return "10" if given is None or is_endless else work.text(given)


_OPTIONS = {
    "oneshot": "cancel the timer when it is called",
    "persistent": "a client of ROS 2 keeps its connection",
}


_OF_TCP = ("tcp_nodelay", "buff_size")
"""Options of the connections of ROS 1, which the middleware of ROS 2 decides on its own."""


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


def _take_response(work: Work, function: Scope) -> None:
    """Let a handler take the response that rclpy hands over."""
    listed, parameters = parameters_of(function)
    if listed is None or listed.id in work.done:
        return
    work.done.add(listed.id)
    if any("splat" in each.type or each.type == "keyword_separator" for each in parameters):
        return
    append_parameter(work, listed, parameters, "response=None")


def _give_default(work: Work, function: Scope) -> None:
    """Let a timer's callback be called without its event."""
    listed, parameters = parameters_of(function)
    if listed is None or listed.id in work.done:
        return
    work.done.add(listed.id)
    own = parameters[1:] if function.self_name else parameters
    if own and own[0].type == "identifier":
        work.insert(own[0].end_byte, "=None")
        _mark_event(work, function.node, work.slice(own[0]))


def _mark_handed_event(work: Work, site: Site, callback: Node) -> None:
    """Mark a callback of a timer that may ask something of its event: all but a lambda's."""
    if callback.type == "lambda":
        parameters = parts_of(callback.child_by_field_name("parameters"))
        for each in parameters[:1]:
            _mark_event(work, callback, work.slice(each))
    else:
        work.mark(site.call, "the event of the timer", _NO_EVENT)


def _mark_event(work: Work, function: Node, event: str) -> None:
    """Mark what a timer's callback does with its event."""
    body = function.child_by_field_name("body")
    for node in walk(body) if body is not None else ():
        if node.type == "identifier" and work.slice(node) == event and not is_member(node):
            parent = node.parent
            is_asked = parent is not None and parent.type == "attribute"
            what = work.slice(parent) if is_asked and parent is not None else f"the event {event}"
            work.mark(node, what, _NO_EVENT)


_NO_EVENT = "a timer of ROS 2 hands over no event"
