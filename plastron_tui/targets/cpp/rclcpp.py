"""The target `rclcpp`: C++ nodes for ROS 2."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

# What `rclcpp::Node` has (Humble to Kilted): a callback of the same name would hide it.
_NODE_METHODS = """
    SharedPtr WeakPtr UniquePtr make_shared make_unique shared_from_this weak_from_this
    add_on_set_parameters_callback add_post_set_parameters_callback
    add_pre_set_parameters_callback count_clients count_publishers count_services
    count_subscribers create_callback_group create_client create_generic_client
    create_generic_publisher create_generic_service create_generic_subscription create_publisher
    create_service create_sub_node create_subscription create_timer create_wall_timer
    declare_parameter declare_parameters describe_parameter describe_parameters
    for_each_callback_group get_clients_info_by_service get_clock get_effective_namespace
    get_fully_qualified_name get_graph_event get_logger get_name get_namespace
    get_node_base_interface get_node_clock_interface get_node_graph_interface
    get_node_logging_interface get_node_names get_node_options get_node_parameters_interface
    get_node_services_interface get_node_time_source_interface get_node_timers_interface
    get_node_topics_interface get_node_type_descriptions_interface get_node_waitables_interface
    get_parameter get_parameter_or get_parameter_types get_parameters
    get_publishers_info_by_topic get_servers_info_by_service get_service_names_and_types
    get_service_names_and_types_by_node get_sub_namespace get_subscriptions_info_by_topic
    get_topic_names_and_types has_parameter list_parameters now
    remove_on_set_parameters_callback remove_post_set_parameters_callback
    remove_pre_set_parameters_callback set_parameter set_parameters set_parameters_atomically
    undeclare_parameter wait_for_graph_change
"""

# What `rclcpp_lifecycle::LifecycleNode` has besides (Humble to Kilted), and the template's own
# methods of a managed node.
_MANAGED = """
    CallbackReturn accept_goal activate add_managed_entity add_timer_handle cleanup configure
    deactivate destroy_endpoints destroy_timers end_tasks get_available_states
    get_available_transitions get_current_state get_transition_graph is_active on_activate
    on_cleanup on_configure on_deactivate on_error on_shutdown register_on_activate
    register_on_cleanup register_on_configure register_on_deactivate register_on_error
    register_on_shutdown shutdown trigger_transition
"""

_TASK_NAMES = """
    call end_goals exit_status fail goal_mutex goes_on has_failed is_answered is_current is_done
    is_ending is_served send_goal start wait_until_served work work_task
"""

DIALECT = Dialect(
    library="rclcpp",
    ros_version=2,
    method_names=frozenset(_NODE_METHODS.split()),
    # `to_yaml` is found by the type of what it is given, unless the class has one of its own.
    attribute_names=frozenset({"check_parameters", "parameters_callback", "to_yaml"}),
    task_names=frozenset(_TASK_NAMES.split()),
    managed_names=frozenset(_MANAGED.split()),
    base="rclcpp::Node",
    managed_base="rclcpp_lifecycle::LifecycleNode",
    header="rclcpp/rclcpp.hpp",
    managed_header="rclcpp_lifecycle/lifecycle_node.hpp",
    action_header="rclcpp_action/rclcpp_action.hpp",
)


class RclcppTarget(CppTarget):
    """Writes, reads and edits rclcpp nodes."""

    name: ClassVar[str] = "rclcpp"
    ros_version: ClassVar[int] = 2
    writes_managed: ClassVar[bool] = True
    dialect: ClassVar[Dialect] = DIALECT
