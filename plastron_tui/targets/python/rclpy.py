"""The target `rclpy`: Python nodes for ROS 2."""

from __future__ import annotations

import keyword
from collections.abc import Callable
from typing import ClassVar

from plastron_tui.model.kinds import Parameter
from plastron_tui.model.source import FileSet
from plastron_tui.model.values import Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import FieldType, Interface, InterfaceKind
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.python import literals
from plastron_tui.sources.python.dialect import Dialect, plain_scalar
from plastron_tui.sources.python.import_block import Imports

from .target import PythonTarget

# What `rclpy.node.Node` has, private parts apart (Humble to Kilted): a callback of the same name
# would take its place.
_NODE_METHODS = """
    PARAM_REL_TOL add_on_set_parameters_callback add_post_set_parameters_callback
    add_pre_set_parameters_callback add_waitable clients context count_clients count_publishers
    count_services count_subscribers create_client create_guard_condition create_publisher
    create_rate create_service create_subscription create_timer declare_parameter
    declare_parameters default_callback_group describe_parameter describe_parameters
    destroy_client destroy_guard_condition destroy_node destroy_publisher destroy_rate
    destroy_service destroy_subscription destroy_timer executor get_client_names_and_types_by_node
    get_clients_info_by_service get_clock get_fully_qualified_name
    get_fully_qualified_node_names get_logger get_name
    get_namespace get_node_names get_node_names_and_namespaces
    get_node_names_and_namespaces_with_enclaves get_parameter get_parameter_or
    get_parameter_type get_parameter_types get_parameters get_parameters_by_prefix
    get_publisher_names_and_types_by_node get_publishers_info_by_topic
    get_servers_info_by_service get_service_names_and_types
    get_service_names_and_types_by_node get_subscriber_names_and_types_by_node
    get_subscriptions_info_by_topic get_topic_names_and_types get_type_description_service guards
    handle has_parameter list_parameters publishers remove_on_set_parameters_callback
    remove_post_set_parameters_callback remove_pre_set_parameters_callback remove_waitable
    resolve_service_name resolve_topic_name services set_descriptor set_parameters
    set_parameters_atomically subscriptions timers undeclare_parameter wait_for_node waitables
"""

# The private parts of `rclpy.node.Node` (its source, Humble to Kilted; `__x` is mangled, and its
# own): methods, and attributes that `__init__` sets, which would shadow the callback.
_NODE_PRIVATE = """
    _allow_undeclared_parameters _apply_descriptor _apply_descriptor_and_set _apply_descriptors
    _apply_floating_point_range _apply_integer_range _call_post_set_parameters_callback
    _call_pre_set_parameters_callback _check_undeclared_parameters _clients _clock _context
    _count_clients_or_servers _count_publishers_or_subscribers _declare_parameter_common
    _default_callback_group _descriptors _get_info_by_topic _guards _handle _logger
    _logger_service _on_set_parameters_callbacks _parameter_event_publisher _parameter_overrides
    _parameter_service _parameters _parameters_callback _post_set_parameters_callbacks
    _pre_set_parameters_callbacks _publishers _rate_group _services _set_parameters
    _set_parameters_atomically _set_parameters_atomically_common _subscriptions _time_source
    _timers _type_description_service _validate_qos_or_depth_parameter
    _validate_topic_or_service_name _waitables _wake_executor
"""

# What `rclpy.lifecycle.LifecycleNode` has besides (Humble to Kilted), private parts too, and the
# template's own methods of a managed node.
_MANAGED = """
    _callbacks _managed_entities _service_change_state _service_get_available_states
    _service_get_available_transitions _service_get_state _service_get_transition_graph
    _state_machine accept_goal add_managed_entity cancel_goal create_lifecycle_publisher
    destroy_endpoints destroy_lifecycle_publisher destroy_timers end_tasks is_active on_activate
    on_cleanup on_configure on_deactivate on_error on_shutdown sent_goals trigger_activate
    trigger_cleanup trigger_configure trigger_deactivate trigger_shutdown waits
"""

_TASK_NAMES = """
    accept_cancel answer call exit_status fail is_served send_goal sleep wait_until_served work
"""


class _Rclpy(Dialect):
    __slots__ = ()

    def scalar(self, type_: FieldType, value: Value, imports: Imports) -> str:
        """Write one value of exactly the type that rclpy's messages assert.

        A `byte` is a `bytes` of length one (the `octet` of rosidl_generator_py); a `char` is an
        integer, and a floating point field takes nothing but a `float`.
        """
        if type_.name == "byte" and isinstance(value, int):
            return literals.octet(value)
        if type_.name in {"float32", "float64"} and isinstance(value, int):
            return plain_scalar(float(value))
        return plain_scalar(value)

    def unusable(self, interface: Interface, catalog: Catalog) -> str | None:
        """Return which keyword of Python an interface, or a part of it, has as its name or a field.

        rosidl_generator_py warns of it, and writes a class that is no Python.
        """
        if (reason := super().unusable(interface, catalog)) is not None:
            return reason
        seen, left = {interface.name}, [interface]
        while left:
            each = left.pop()
            for field in (field for section in each.sections for field in section.fields):
                if keyword.iskeyword(field.name):
                    return f"`{each.name}` has a field `{field.name}`, which is a keyword of Python"
                if field.type.message is not None and field.type.message not in seen:
                    seen.add(field.type.message)
                    part = catalog.find(field.type.message, InterfaceKind.MESSAGE)
                    left += [part] if part is not None else []
        return None

    def parameter(self, parameter: Parameter, getter: Callable[[str], str]) -> str:
        """Write what reads a parameter; rclpy keeps it of its type, and in its range."""
        del getter
        return f"self.get_parameter({literals.string(parameter.name.removeprefix('~/'))}).value"


DIALECT = _Rclpy(
    library="rclpy",
    ros_version=2,
    standard=(),
    calling=("sys", "time"),
    timing=(),
    modules=("rclpy",),
    symbols=(("rclpy.executors", "ExternalShutdownException"), ("rclpy.node", "Node")),
    server_symbols=(("rclpy.action", "ActionServer"), ("rclpy.action", "CancelResponse")),
    client_symbols=(("rclpy.action", "ActionClient"),),
    goal_symbols=(("action_msgs.msg", "GoalStatus"),),
    task_symbols=(("rclpy.task", "Future"),),
    module_names=frozenset(
        {"SERVICE_TIMEOUT", "WARNING_PERIOD", "all_in_range", "as_float32", "ctypes", "in_range"}
        | {"divisor", "main", "node"}
    ),
    method_names=frozenset((_NODE_METHODS + _NODE_PRIVATE).split()),
    attribute_names=frozenset({"follow_rates"}),
    task_names=frozenset(_TASK_NAMES.split()),
    serving="goal",
    managed_symbols=(
        ("rclpy.executors", "ExternalShutdownException"),
        ("rclpy.lifecycle", "LifecycleNode"),
    ),
    managed_server_symbols=(("rclpy.action", "GoalResponse"),),
    managed_names=frozenset(_MANAGED.split()),
)


class RclpyTarget(PythonTarget):
    """Writes, reads and edits rclpy nodes."""

    name: ClassVar[str] = "rclpy"
    ros_version: ClassVar[int] = 2
    package_folder: ClassVar[str] = "{}"
    writes_managed: ClassVar[bool] = True
    dialect: ClassVar[Dialect] = DIALECT

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node, one in a package as the package's own tests want it."""
        rendered = super().render(node, catalog)
        if node.home is None or rendered.files is None:
            return rendered
        from plastron_tui.sources.python.ament_style import ament_style  # loads tree-sitter-python

        return rendered._replace(files=FileSet.single(".py", ament_style(rendered.files.main)))
