"""Objects of libraries that create endpoints without saying so.

Source: `tf`, `tf2_ros` and `smach_ros` of Noetic, `tf2_ros` of Jazzy.
"""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.qos import DEFAULT

from .calls import Argument, CallShape, QosArguments

_TRANSFORMS = InterfaceName("tf2_msgs", "TFMessage")


def _transforms(
    kind: EndpointKind,
    topics: Mapping[str, QosArguments | None],
    callees: tuple[str, ...],
    node: Argument | None,
) -> tuple[CallShape, ...]:
    nowhere = Argument(-1, "")
    return tuple(
        CallShape(kind, callees, name=nowhere, node=node, fixed=(topic, _TRANSFORMS), qos=qos)
        for topic, qos in topics.items()
    )


_LISTENERS = ("tf2_ros.TransformListener", "tf2_ros.transform_listener.TransformListener")
_BROADCASTERS = (
    "tf2_ros.TransformBroadcaster",
    "tf2_ros.transform_broadcaster.TransformBroadcaster",
)
_STATIC = (
    "tf2_ros.StaticTransformBroadcaster",
    "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
)
_PUB, _SUB = EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION
_MOVING = DEFAULT._replace(depth=100)
_HEARD = {
    "/tf": QosArguments(Argument(-1, "qos"), default=_MOVING),
    "/tf_static": QosArguments(
        Argument(-1, "static_qos"),
        default=_MOVING._replace(durability="transient_local"),
    ),
}
_SENT = {"/tf": QosArguments(Argument(1, "qos"), default=_MOVING)}
_SENT_ONCE = {
    "/tf_static": QosArguments(
        Argument(1, "qos"),
        default=DEFAULT._replace(depth=1, durability="transient_local"),
    )
}

_SHAPES = {
    "rospy": (
        *_transforms(
            _SUB,
            dict.fromkeys(_HEARD),
            (*_LISTENERS, "tf.TransformListener", "tf.listener.TransformListener"),
            None,
        ),
        *_transforms(
            _PUB,
            dict.fromkeys(_SENT),
            (*_BROADCASTERS, "tf.TransformBroadcaster", "tf.broadcaster.TransformBroadcaster"),
            None,
        ),
        *_transforms(_PUB, dict.fromkeys(_SENT_ONCE), _STATIC, None),
        CallShape(
            EndpointKind.ACTION_CLIENT,
            ("smach_ros.SimpleActionState", "smach_ros.simple_action_state.SimpleActionState"),
            name=Argument(0, "action_name"),
            type=Argument(1, "action_spec"),
        ),
        CallShape(
            EndpointKind.CLIENT,
            ("smach_ros.ServiceState", "smach_ros.service_state.ServiceState"),
            name=Argument(0, "service_name"),
            type=Argument(1, "service_spec"),
        ),
        CallShape(
            _SUB,
            ("smach_ros.MonitorState", "smach_ros.monitor_state.MonitorState"),
            name=Argument(0, "topic"),
            type=Argument(1, "msg_type"),
            callback=Argument(2, "cond_cb"),
        ),
    ),
    "rclpy": (
        *_transforms(_SUB, _HEARD, _LISTENERS, Argument(1, "node")),
        *_transforms(_PUB, _SENT, _BROADCASTERS, Argument(0, "node")),
        *_transforms(_PUB, _SENT_ONCE, _STATIC, Argument(0, "node")),
    ),
}


def disguised(module: str) -> dict[str, list[CallShape]]:
    """Return what the objects of a client library's friends create, by qualified name."""
    found: dict[str, list[CallShape]] = {}
    for shape in _SHAPES[module]:
        for name in shape.callees:
            found.setdefault(name, []).append(shape)
    return found
