"""What creates an endpoint in the client libraries for Python, as data.

The parameters are those of rospy (Noetic: `rospy.topics`, `rospy.impl.tcpros_service`,
`rospy.timer`, `rospy.client`, `actionlib`, `message_filters`) and of rclpy (Jazzy:
`rclpy.node.Node`, `rclpy.action`, `rclpy.lifecycle`, `rclpy.wait_for_message`, `message_filters`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.catalog import usual_distribution
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.qos import DEFAULT, Qos

ACTIONS = (EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT)


class Argument(NamedTuple):
    """Where a call takes an argument: its position (-1: by keyword only) and its keyword."""

    position: int
    keyword: str


class QosArguments(NamedTuple):
    """Where a call takes the quality of service of a topic.

    Attributes:
        profile: the argument that is a profile, or a depth alone.
        queue_size: the argument that is the depth.
        latch: the argument that tells whether the last message is kept for who comes later.
        default: what it is without a `profile`, None where there has to be one.
    """

    profile: Argument | None = None
    queue_size: Argument | None = None
    latch: Argument | None = None
    default: Qos | None = None


@dataclass(frozen=True, slots=True)
class CallShape:
    """A call that creates an endpoint.

    Attributes:
        kind: what it creates.
        callees: qualified names of functions and classes; a name without a dot is a method of
            a node.
        name: the argument that names the endpoint (a timer's: its period).
        type: the argument that is its interface type.
        callback: the argument that is called for each message, request or tick.
        node: the argument that is the node, where the callee is no method of it.
        fixed: the name and the type, where no argument says them.
        gives_message: whether it waits for one message and gives that, not the endpoint.
        qos: the arguments that are its quality of service, None where it has none.
    """

    kind: EndpointKind
    callees: tuple[str, ...]
    name: Argument
    type: Argument | None = None
    callback: Argument | None = None
    node: Argument | None = None
    fixed: tuple[str, InterfaceName] | None = None
    gives_message: bool = False
    qos: QosArguments | None = None


@dataclass(frozen=True, slots=True)
class ClientLibrary:
    """A client library: its module, what creates endpoints, and what creates nodes.

    Attributes:
        module: the package whose import says that a file uses the library.
        ros_version: the generation of ROS that it is for, 1 or 2.
        distribution: the distribution of the catalog that tells which package a message that
            comes from one of several star imports is of.
        shapes: the calls that create endpoints.
        node_calls: functions that create a node, and the argument that names it.
        node_classes: classes whose instances are nodes.
    """

    module: str
    ros_version: int
    distribution: str
    shapes: tuple[CallShape, ...]
    node_calls: dict[str, Argument]
    node_classes: frozenset[str] = frozenset()

    def functions(self) -> dict[str, CallShape]:
        """Return the shapes of functions and classes by qualified name."""
        return {name: shape for shape in self.shapes for name in shape.callees if "." in name}

    def methods(self) -> dict[str, CallShape]:
        """Return the shapes of a node's methods by name."""
        return {name: shape for shape in self.shapes for name in shape.callees if "." not in name}


ROSPY = ClientLibrary(
    module="rospy",
    ros_version=1,
    distribution=usual_distribution(1),
    shapes=(
        CallShape(
            EndpointKind.PUBLISHER,
            ("rospy.Publisher", "rospy.topics.Publisher"),
            name=Argument(0, "name"),
            type=Argument(1, "data_class"),
            qos=QosArguments(
                queue_size=Argument(6, "queue_size"),
                latch=Argument(4, "latch"),
            ),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("rospy.Subscriber", "rospy.topics.Subscriber"),
            name=Argument(0, "name"),
            type=Argument(1, "data_class"),
            callback=Argument(2, "callback"),
            qos=QosArguments(queue_size=Argument(4, "queue_size")),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("message_filters.Subscriber",),
            name=Argument(0, "topic"),
            type=Argument(1, "topic_type"),
            qos=QosArguments(queue_size=Argument(-1, "queue_size")),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("rospy.wait_for_message", "rospy.client.wait_for_message"),
            name=Argument(0, "topic"),
            type=Argument(1, "topic_type"),
            gives_message=True,
        ),
        CallShape(
            EndpointKind.SERVICE,
            ("rospy.Service", "rospy.impl.tcpros_service.Service"),
            name=Argument(0, "name"),
            type=Argument(1, "service_class"),
            callback=Argument(2, "handler"),
        ),
        CallShape(
            EndpointKind.CLIENT,
            ("rospy.ServiceProxy", "rospy.impl.tcpros_service.ServiceProxy"),
            name=Argument(0, "name"),
            type=Argument(1, "service_class"),
        ),
        CallShape(
            EndpointKind.ACTION_SERVER,
            ("actionlib.SimpleActionServer", "actionlib.simple_action_server.SimpleActionServer"),
            name=Argument(0, "name"),
            type=Argument(1, "ActionSpec"),
            callback=Argument(2, "execute_cb"),
        ),
        CallShape(
            EndpointKind.ACTION_SERVER,
            ("actionlib.ActionServer", "actionlib.action_server.ActionServer"),
            name=Argument(0, "ns"),
            type=Argument(1, "ActionSpec"),
            callback=Argument(2, "goal_cb"),
        ),
        CallShape(
            EndpointKind.ACTION_CLIENT,
            (
                "actionlib.SimpleActionClient",
                "actionlib.simple_action_client.SimpleActionClient",
                "actionlib.ActionClient",
                "actionlib.action_client.ActionClient",
            ),
            name=Argument(0, "ns"),
            type=Argument(1, "ActionSpec"),
        ),
        CallShape(
            EndpointKind.TIMER,
            ("rospy.Timer", "rospy.timer.Timer"),
            name=Argument(0, "period"),
            callback=Argument(1, "callback"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            (
                "rospy.get_param",
                "rospy.client.get_param",
                "rospy.get_param_cached",
                "rospy.client.get_param_cached",
            ),
            name=Argument(0, "param_name"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("rospy.set_param", "rospy.client.set_param"),
            name=Argument(0, "param_name"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("rospy.has_param", "rospy.client.has_param"),
            name=Argument(0, "param_name"),
        ),
    ),
    node_calls={
        "rospy.init_node": Argument(0, "name"),
        "rospy.client.init_node": Argument(0, "name"),
    },
)

RCLPY = ClientLibrary(
    module="rclpy",
    ros_version=2,
    distribution=usual_distribution(2),
    shapes=(
        CallShape(
            EndpointKind.PUBLISHER,
            ("create_publisher", "create_lifecycle_publisher"),
            name=Argument(1, "topic"),
            type=Argument(0, "msg_type"),
            qos=QosArguments(Argument(2, "qos_profile")),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("create_subscription",),
            name=Argument(1, "topic"),
            type=Argument(0, "msg_type"),
            callback=Argument(2, "callback"),
            qos=QosArguments(Argument(3, "qos_profile")),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("message_filters.Subscriber",),
            name=Argument(2, "topic"),
            type=Argument(1, "msg_type"),
            node=Argument(0, "node"),
            qos=QosArguments(Argument(3, "qos_profile"), default=DEFAULT._replace(depth=10)),
        ),
        CallShape(
            EndpointKind.SUBSCRIPTION,
            ("rclpy.wait_for_message.wait_for_message",),
            name=Argument(2, "topic"),
            type=Argument(0, "msg_type"),
            node=Argument(1, "node"),
            gives_message=True,
            qos=QosArguments(Argument(-1, "qos_profile"), default=DEFAULT._replace(depth=1)),
        ),
        CallShape(
            EndpointKind.SERVICE,
            ("create_service",),
            name=Argument(1, "srv_name"),
            type=Argument(0, "srv_type"),
            callback=Argument(2, "callback"),
        ),
        CallShape(
            EndpointKind.CLIENT,
            ("create_client",),
            name=Argument(1, "srv_name"),
            type=Argument(0, "srv_type"),
        ),
        CallShape(
            EndpointKind.ACTION_SERVER,
            ("rclpy.action.ActionServer", "rclpy.action.server.ActionServer"),
            name=Argument(2, "action_name"),
            type=Argument(1, "action_type"),
            callback=Argument(3, "execute_callback"),
            node=Argument(0, "node"),
        ),
        CallShape(
            EndpointKind.ACTION_CLIENT,
            ("rclpy.action.ActionClient", "rclpy.action.client.ActionClient"),
            name=Argument(2, "action_name"),
            type=Argument(1, "action_type"),
            node=Argument(0, "node"),
        ),
        CallShape(
            EndpointKind.TIMER,
            ("create_timer",),
            name=Argument(0, "timer_period_sec"),
            callback=Argument(1, "callback"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("declare_parameter",),
            name=Argument(0, "name"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("declare_parameters",),
            name=Argument(1, "parameters"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("get_parameter",),
            name=Argument(0, "name"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("get_parameter_or",),
            name=Argument(0, "name"),
        ),
        CallShape(
            EndpointKind.PARAMETER,
            ("has_parameter",),
            name=Argument(0, "name"),
        ),
    ),
    node_calls={"rclpy.create_node": Argument(0, "node_name")},
    node_classes=frozenset(
        {
            "rclpy.Node",
            "rclpy.node.Node",
            "rclpy.lifecycle.Node",
            "rclpy.lifecycle.LifecycleNode",
            "rclpy.lifecycle.node.Node",
            "rclpy.lifecycle.node.LifecycleNode",
            "nav2_simple_commander.robot_navigator.BasicNavigator",
        }
    ),
)

LIBRARIES = {library.module: library for library in (ROSPY, RCLPY)}
