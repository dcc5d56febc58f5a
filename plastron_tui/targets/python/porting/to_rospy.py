"""From rclpy to rospy: the endpoints, the node behind them, and what runs it."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.qos import DEFAULT, Qos
from plastron_tui.sources.python.analysis import NodeSite, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.python.splices import delete_item
from plastron_tui.sources.python.syntax import parts_of

from .action_uses import mark_action_uses
from .actions import mark_actions
from .annotations import leave_annotations
from .contexts import port_executors
from .early_callbacks import move_early_callbacks
from .endpoints import mark_endpoint_attributes
from .insertion_point import add_header
from .left_out import depth_alone, free_names, leave_options
from .leftovers import mark_leftovers, port_ending
from .node_uses import mark_helpers, mark_waits, port_node_uses
from .other_modules import mark_other_modules
from .port_state import Work, walk
from .renamed_fields import port_fields
from .rewriting import (
    Writer,
    append_parameter,
    callable_text,
    first_statement,
    given_type,
    mark_options,
    parameters_of,
    port_sites,
    put_before,
)
from .rospy_parameters import port_rospy_parameters
from .rospy_running import port_rospy_running
from .rospy_times import port_rospy_times
from .rospy_values import port_rospy_values
from .rospy_words import port_rospy_words
from .types import keep_used_imports, port_imports, target_type

_GONE = frozenset({"rclpy"})
_LEFT = _GONE | {"ament_index_python", "launch", "launch_ros", "tf2_ros", "nav2_simple_commander"}
_LEFT |= {"rcl_interfaces", "lifecycle_msgs", "rosbag2_py"}

_ATTRIBUTES = {
    "create_client": "`rospy.ServiceProxy(name, type)`",
    "create_publisher": "`rospy.Publisher(name, type, queue_size=...)`",
    "create_rate": "`rospy.Rate(...)`",
    "create_service": "`rospy.Service(name, type, handler)`",
    "create_subscription": "`rospy.Subscriber(name, type, callback)`",
    "create_timer": "`rospy.Timer(rospy.Duration(...), callback)`",
    "get_logger": "`rospy.loginfo(...)`, `rospy.logwarn(...)`",
    "get_clock": "`rospy.Time.now()`",
    "declare_parameter": "`rospy.get_param('~name', default)`",
    "declare_parameters": "`rospy.get_param('~name', default)`",
    "get_parameter": "`rospy.get_param('~name')`",
    "get_parameter_or": "`rospy.get_param('~name', default)`",
    "get_parameters": "`rospy.get_param('~name')`",
    "get_parameters_by_prefix": "`rospy.get_param('~prefix')` gives a dictionary",
    "has_parameter": "`rospy.has_param('~name')`",
    "undeclare_parameter": "`rospy.delete_param('~name')`",
    "set_parameters": "`rospy.set_param('~name', value)`",
    "get_fully_qualified_name": "`rospy.get_name()`",
    "get_topic_names_and_types": "`rospy.get_published_topics()`",
    "count_publishers": "`get_num_connections` of the subscriber",
    "count_subscribers": "`get_num_connections` of the publisher",
    "destroy_client": "`close` of the client",
    "destroy_service": "`shutdown` of the service",
    "destroy_rate": None,
    "add_on_set_parameters_callback": "`dynamic_reconfigure`",
    "get_name": "`rospy.get_name()`",
    "get_namespace": "`rospy.get_namespace()`",
    "goals_canceling": "`cancel_goal()` of the client gives no answer",
    "call_async": "call the client itself; it waits for the answer",
    "service_is_ready": "`wait_for_service` of the client",
    "srv_name": "`resolved_name` of the client",
    "remove_pending_request": None,
    "get_subscription_count": "`get_num_connections` of the publisher",
    "destroy_subscription": "`unregister` of the subscriber",
    "destroy_publisher": "`unregister` of the publisher",
    "destroy_timer": "`shutdown` of the timer",
    "create_guard_condition": None,
    "sec": "a time of ROS 1 has `secs`",
    "nanosec": "a time of ROS 1 has `nsecs`",
    "nanoseconds": "a time of ROS 1 has `to_nsec()`",
    "to_msg": "a message takes a time of rospy as it is",
    "seconds_nanoseconds": "a time of ROS 1 has `secs` and `nsecs`",
    "Request": "rospy has it beside the service's class: `AddTwoIntsRequest`",
    "Response": "rospy has it beside the service's class: `AddTwoIntsResponse`",
}

_ENDING = {
    "cancel": "`shutdown` of the timer",
    "reset": "a timer of rospy starts anew as a new `rospy.Timer(...)`",
    "is_canceled": "`is_alive` of the timer",
    "time_until_next_call": "a timer of rospy does not tell",
    "destroy": "`shutdown` of a timer or service, `unregister` of the others",
}

_OPTIONS = {"callback_group": "rospy calls callbacks in threads of their own"}

_REMEDIES = {
    "rclpy.time": "`rospy.Time`",
    "rclpy.duration": "`rospy.Duration`",
    "rclpy.action.ActionClient": "`actionlib.SimpleActionClient(name, type)`",
    "rclpy.action.ActionServer": "`actionlib.SimpleActionServer(name, type, callback, False)`",
    "rclpy.action": "`actionlib`",
    "rclpy.qos": "ROS 1 has `latch` and `queue_size` only",
    "rclpy.spin_once": "`rospy.sleep(...)`: rospy handles what comes in threads of its own",
    "rclpy.spin_until_future_complete": "a client of rospy waits by itself",
    "rclpy.executors": "rospy handles what comes in threads of its own",
    "rclpy.logging": "`rospy.loginfo(...)`",
    "rclpy.callback_groups": _OPTIONS["callback_group"],
    "rclpy.clock": "`rospy.Time.now()`",
    "rclpy.lifecycle": "a node of ROS 1 has no life cycle",
    "rclpy.node.Node": "rospy has no object for the node",
    "rclpy.parameter": "`rospy.get_param('~name', default)`",
    "rclpy.Parameter": "`rospy.get_param('~name', default)`",
    "rclpy.task": "rospy has no futures: a client gives the answer itself",
    "ament_index_python": "`rospkg.RosPack().get_path(package)`",
    "launch": "`roslaunch`",
}


def port_to_rospy(work: Work) -> None:
    """Rewrite what makes rclpy nodes and their endpoints, and mark the rest of rclpy."""
    port_imports(work, _GONE)
    leave_annotations(work)
    port_executors(work)
    port_rospy_parameters(work)
    port_rospy_running(work)
    mark_waits(work)
    _mark_coroutines(work)
    port_rospy_words(work)
    port_rospy_times(work)
    port_rospy_values(work)
    port_fields(work)
    port_sites(work, _WRITERS, _private_name)
    _port_nodes(work)
    port_ending(work, {"cancel": "shutdown"}, _ENDING)
    leave_options(work)
    mark_endpoint_attributes(work, {*_ATTRIBUTES, *_ENDING})
    mark_actions(work)
    mark_action_uses(work)
    mark_other_modules(work)
    mark_leftovers(work, _LEFT, {k: v or "" for k, v in _ATTRIBUTES.items()}, _REMEDIES)
    mark_helpers(work)
    port_node_uses(work)
    move_early_callbacks(work)
    keep_used_imports(work, _GONE)
    free_names(work)
    work.freed.add("rospy")
    work.imports.add("import rospy")
    add_header(work)


def _mark_coroutines(work: Work) -> None:
    for function in work.callbacks.values():
        if function.node.children[0].type == "async":
            work.mark(function.node, "async", "rospy does not wait for coroutines")


def _private_name(work: Work, site: Site, name: Node) -> str:
    """Write a private name, which has no slash behind its `~` in ROS 1."""
    written = work.text(name)
    if name.type == "string" and "~/" in written:
        return written.replace("~/", "~", 1)
    work.mark(site.call, "a private name", "ROS 1 writes `~name`, without a slash")
    return written


def _publisher(work: Work, site: Site, name: str) -> str | None:
    mark_options(work, site, _OPTIONS, ("qos_profile",))
    depth = _depth(work, site, Argument(2, "qos_profile")) or "10"
    return f"rospy.Publisher({name}, {given_type(work, site)}, queue_size={depth})"


def _subscription(work: Work, site: Site, name: str) -> str | None:
    type_ = given_type(work, site)
    if site.shape.gives_message:
        limit = site.arguments.get(Argument(-1, "time_to_wait"))
        timeout = f", timeout={work.text(limit)}" if limit is not None else ""
        return f"(True, rospy.wait_for_message({name}, {type_}{timeout}))"
    callee = site.call.child_by_field_name("function")
    if site.shape.node is not None and callee is not None:
        depth = _depth(work, site, Argument(-1, "qos_profile"))
        queue = f", queue_size={depth}" if depth is not None else ""
        return f"{work.text(callee)}({name}, {type_}{queue})"
    mark_options(work, site, _OPTIONS, ("callback", "qos_profile"))
    callback = site.arguments.get(Argument(2, "callback"))
    depth = _depth(work, site, Argument(3, "qos_profile"))
    called = f", {work.text(callback)}" if callback is not None else ""
    queue = f", queue_size={depth}" if depth is not None else ""
    return f"rospy.Subscriber({name}, {type_}{called}{queue})"


def _service(work: Work, site: Site, name: str) -> str | None:
    callback = site.arguments.get(Argument(2, "callback"))
    if callback is None:
        return None
    mark_options(work, site, _OPTIONS, ("callback", "qos_profile"))
    called = work.text(callback)
    function = work.callback_of(site)
    made = _response(work, site)
    if function is None or not _make_response(work, function, made):
        called = f"lambda request: {callable_text(called)}(request, {made})"
    return f"rospy.Service({name}, {given_type(work, site)}, {called})"


def _client(work: Work, site: Site, name: str) -> str | None:
    mark_options(work, site, _OPTIONS, ("qos_profile",))
    return f"rospy.ServiceProxy({name}, {given_type(work, site)})"


def _timer(work: Work, site: Site, name: str) -> str | None:
    callback = site.arguments.get(Argument(1, "callback"))
    if callback is None:
        return None
    mark_options(work, site, _OPTIONS, ("callback",))
    called = work.text(callback)
    function = work.callback_of(site)
    body = callback.child_by_field_name("body")
    if callback.type == "lambda" and body and not callback.child_by_field_name("parameters"):
        called = f"lambda event: {work.text(body)}"
    elif function is None or not _take_event(work, function):
        called = f"lambda event: {callable_text(called)}()"
    return f"rospy.Timer(rospy.Duration({name}), {called})"


_WRITERS: dict[EndpointKind, Writer] = {
    EndpointKind.PUBLISHER: _publisher,
    EndpointKind.SUBSCRIPTION: _subscription,
    EndpointKind.SERVICE: _service,
    EndpointKind.CLIENT: _client,
    EndpointKind.TIMER: _timer,
}


def _depth(work: Work, site: Site, argument: Argument) -> str | None:
    """Write the depth of a queue; any other quality of service is marked."""
    given = site.arguments.get(argument)
    if given is None:
        return None
    folded = work.analysis.resolver.fold(given, site.scope)
    if isinstance(folded, Known) and isinstance(folded.value, int):
        return work.text(given)
    depth = depth_alone(work, given)
    # The line has no quality of service any more, so that at most one mark says it.
    work.done.update(each.id for each in walk(given) if each != depth)
    work.freed.update(work.slice(each) for each in walk(given) if each.type == "identifier")
    if depth is not None:
        return work.text(depth)
    if site.endpoint.kind is EndpointKind.PUBLISHER and _is_latched(site.endpoint.qos):
        assert site.endpoint.qos is not None
        return f"{site.endpoint.qos.depth}, latch=True"
    work.mark(site.call, "quality of service", _REMEDIES["rclpy.qos"])
    return None


def _is_latched(qos: Qos | None) -> bool:
    """Tell whether a quality of service is that of `latch`: the last messages are kept."""
    if qos is None or qos.depth is None:
        return False
    return qos.over(DEFAULT) == DEFAULT._replace(durability="transient_local", depth=qos.depth)


def _response(work: Work, site: Site) -> str:
    """Write an expression that makes an empty response."""
    type_ = site.endpoint.type
    if type_ is None:
        return f"{given_type(work, site)}._response_class()"
    found = target_type(work, type_, InterfaceKind.SERVICE)[0] or type_
    work.imports.add(f"from {found.package}.srv import {found.name}Response")
    return f"{found.name}Response()"


def _make_response(work: Work, function: Scope, made: str) -> bool:
    """Let a handler make the response that rclpy hands over; tell whether it can be."""
    listed, parameters = parameters_of(function)
    body = function.node.child_by_field_name("body")
    if listed is None or body is None:
        return False
    if listed.id in work.done:
        return True
    own = parameters[1:] if function.self_name else parameters
    if len(own) != 2 or own[1].type not in ("identifier", "typed_parameter"):
        return False
    work.done.add(listed.id)
    name = own[1] if own[1].type == "identifier" else own[1].named_children[0]
    work.replace(own[1], "")
    work.cut(delete_item(work.analysis.syntax.text, parameters, own[1]))
    work.done.update(node.id for node in walk(own[1]))
    put_before(work, first_statement(body), [f"{work.slice(name)} = {made}"])
    return True


def _take_event(work: Work, function: Scope) -> bool:
    """Let a timer's callback take its event; tell whether it can."""
    listed, parameters = parameters_of(function)
    if listed is None:
        return False
    if listed.id in work.done:
        return True
    if len(parameters) != (1 if function.self_name else 0):
        return False
    work.done.add(listed.id)
    append_parameter(work, listed, parameters, "event=None")
    return True


def _port_nodes(work: Work) -> None:
    """Make the one node that a process of ROS 1 has; classes of nodes become plain ones."""
    classes = work.analysis.library.node_classes
    for owner in work.analysis.scopes.classes():
        for base in owner.bases:
            if set(work.qualified(base)) & classes:
                _leave_base(work, owner, base)
    makers = [each for each in work.analysis.nodes if _is_maker(work, each)]
    for index, maker in enumerate(makers):
        _init(work, maker)
        if index and maker.call is not None:
            remedy = "ROS 1 has one node a process: make two programs of them"
            work.mark(maker.call, "a second node", remedy)
    for each in work.analysis.nodes:
        if each.call is None and each.owner is not None and not _has_file_base(work, each.owner):
            work.mark(each.scope.node, "the node's name", "`rospy.init_node(name)` makes the node")


def _is_maker(work: Work, site: NodeSite) -> bool:
    """Tell whether a place calls the library itself, and no class of the file."""
    if site.call is None:
        return False
    return site.owner is None or not _has_file_base(work, site.owner)


def _has_file_base(work: Work, owner: Scope) -> bool:
    """Tell whether a class derives from a node class of the file."""
    bases = [each for each in work.analysis.resolver.classes.bases(owner) if each is not owner]
    classes = work.analysis.library.node_classes
    return any(work.analysis.resolver.derives_from(base, classes) for base in bases)


def _leave_base(work: Work, owner: Scope, base: Node) -> None:
    listed = owner.node.child_by_field_name("superclasses")
    if listed is None:
        return
    work.done.update(node.id for node in walk(base))
    items = parts_of(listed)
    if len(items) == 1:
        work.replace(listed, "")
    else:
        work.cut(delete_item(work.analysis.syntax.text, items, base))


def _init(work: Work, maker: NodeSite) -> None:
    assert maker.call is not None
    given = Arguments.of(maker.call, work.analysis.syntax).get(Argument(0, "node_name"))
    is_handed = given is not None and any(
        each.kind is BindingKind.PARAMETER for each in work.bindings(given)
    )
    written = maker.expression if maker.name is None else work.string(maker.name)
    if given is not None and is_handed:
        written = work.text(given)
    if not written:
        written = work.string("node")
        work.mark(maker.call, "the node's name")
    arguments = maker.call.child_by_field_name("arguments")
    if arguments is not None and arguments.named_child_count > 1:
        work.mark(maker.call, "options of the node", "`rospy.init_node` has others")
    work.replace(maker.call, f"rospy.init_node({written})")
