"""What creates an endpoint in the client libraries for C++, as data.

Sources: `ros/node_handle.h`, `ros/param.h`, `ros/service.h`, `ros/topic.h`, `actionlib`,
`message_filters`, `image_transport`, `realtime_tools/realtime_publisher.h` of Noetic;
`rclcpp/node.hpp`, `rclcpp/create_*.hpp`, `rclcpp/wait_for_message.hpp`, `rclcpp_action`,
`message_filters`, `image_transport` of Jazzy.
"""

from __future__ import annotations

from dataclasses import dataclass

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

K = EndpointKind

IMAGE = InterfaceName("sensor_msgs", "Image")
CAMERA_INFO = InterfaceName("sensor_msgs", "CameraInfo")
TRANSFORMS = InterfaceName("tf2_msgs", "TFMessage")


@dataclass(frozen=True, slots=True)
class Shape:
    """A call that creates an endpoint.

    Attributes:
        kind: what it creates.
        name: the argument that names the endpoint (a timer's: its period), counted from the
            first that is no node.
        on: what it is called on: a `handle` of ROS 1, a `node` of ROS 2, an image `transport`,
            a message `filter`, an object that is `empty` before; `function` for a function that
            takes a node before the rest, `filter` for one that takes an image transport; `object`
            for an object that names it itself.
        node: the argument that is the node of a `function`.
        type: `template` for the template argument, `callback` where only a callback says it
            where that is missing, `argument` for the type of an argument, `message` for that of
            the first one where there is no template argument, `text` for a string behind the
            name, `pkg/msg/Name`.
        fixed: the type where it is always the same.
        callback: the argument that is called, None for none.
        queue: the argument that is the depth or the quality of service.
        latch: the argument that tells whether the last message is kept.
        beside: the last part of the name of a second endpoint beside it, with its type.
    """

    kind: EndpointKind
    name: int = 0
    on: str = "node"
    node: int = 0
    type: str = "template"
    fixed: InterfaceName | None = None
    callback: int | None = None
    queue: int | None = None
    latch: int | None = None
    beside: tuple[str, InterfaceName] | None = None


def _parameter(on: str) -> Shape:
    return Shape(K.PARAMETER, on=on, type="")


METHODS: dict[str, tuple[Shape, ...]] = {
    # ros::NodeHandle
    "advertise": (
        Shape(K.PUBLISHER, on="handle", queue=1, latch=2),
        Shape(K.PUBLISHER, on="transport", type="", fixed=IMAGE, queue=1),
        Shape(K.PUBLISHER, on="lazy", queue=1, latch=2),
    ),
    "advertiseImage": (Shape(K.PUBLISHER, on="lazy", type="", fixed=IMAGE, queue=1, latch=2),),
    "subscribe": (
        Shape(K.SUBSCRIPTION, on="handle", type="callback", callback=2, queue=1),
        Shape(K.SUBSCRIPTION, on="transport", type="", fixed=IMAGE, callback=2, queue=1),
        Shape(K.SUBSCRIPTION, on="empty", name=1),
    ),
    "init": (Shape(K.PUBLISHER, on="empty", name=1),),
    "advertiseService": (Shape(K.SERVICE, on="handle", type="callback", callback=1),),
    "serviceClient": (Shape(K.CLIENT, on="handle"),),
    "createTimer": (Shape(K.TIMER, on="handle", type="", callback=1),),
    "createWallTimer": (Shape(K.TIMER, on="handle", type="", callback=1),),
    "createSteadyTimer": (Shape(K.TIMER, on="handle", type="", callback=1),),
    "param": (_parameter("handle"),),
    "getParam": (_parameter("handle"),),
    "getParamCached": (_parameter("handle"),),
    "setParam": (_parameter("handle"),),
    "hasParam": (_parameter("handle"),),
    # image_transport::ImageTransport
    "advertiseCamera": (
        Shape(
            K.PUBLISHER,
            on="transport",
            type="",
            fixed=IMAGE,
            queue=1,
            beside=("camera_info", CAMERA_INFO),
        ),
    ),
    "subscribeCamera": (
        Shape(
            K.SUBSCRIPTION,
            on="transport",
            type="",
            fixed=IMAGE,
            callback=2,
            queue=1,
            beside=("camera_info", CAMERA_INFO),
        ),
    ),
    # rclcpp::Node
    "create_publisher": (Shape(K.PUBLISHER, queue=1),),
    "create_subscription": (Shape(K.SUBSCRIPTION, callback=2, queue=1),),
    "create_generic_publisher": (Shape(K.PUBLISHER, type="text", queue=2),),
    "create_generic_subscription": (Shape(K.SUBSCRIPTION, type="text", callback=3, queue=2),),
    "create_service": (Shape(K.SERVICE, callback=1),),
    "create_client": (Shape(K.CLIENT),),
    "create_wall_timer": (Shape(K.TIMER, type="", callback=1),),
    "create_timer": (Shape(K.TIMER, type="", callback=1),),
    "declare_parameter": (_parameter("node"),),
    "declare_parameters": (_parameter("node"),),
    "get_parameter": (_parameter("node"),),
    "get_parameter_or": (_parameter("node"),),
    "has_parameter": (_parameter("node"),),
}
"""The methods that create endpoints, by name."""

_CAMERA = ("camera_info", CAMERA_INFO)

FUNCTIONS: dict[str, Shape] = {
    "ros::param::param": _parameter(""),
    "ros::param::get": _parameter(""),
    "ros::param::getCached": _parameter(""),
    "ros::param::set": _parameter(""),
    "ros::param::has": _parameter(""),
    "ros::service::call": Shape(K.CLIENT, on="", type="argument"),
    "ros::service::createClient": Shape(K.CLIENT, on=""),
    "ros::topic::waitForMessage": Shape(K.SUBSCRIPTION, on=""),
    "rclcpp::create_publisher": Shape(K.PUBLISHER, on="function", queue=1),
    "rclcpp::create_subscription": Shape(K.SUBSCRIPTION, on="function", callback=2, queue=1),
    "rclcpp::create_generic_publisher": Shape(K.PUBLISHER, on="function", type="text", queue=2),
    "rclcpp::create_generic_subscription": Shape(
        K.SUBSCRIPTION, on="function", type="text", callback=3, queue=2
    ),
    "rclcpp::create_service": Shape(K.SERVICE, on="function", callback=1),
    "rclcpp::create_client": Shape(K.CLIENT, on="function"),
    "rclcpp::create_timer": Shape(K.TIMER, on="function", type="", name=1, callback=2),
    "rclcpp::create_wall_timer": Shape(K.TIMER, on="", type="", callback=1),
    "rclcpp::wait_for_message": Shape(K.SUBSCRIPTION, on="function", node=1, type="message"),
    "rclcpp_action::create_server": Shape(K.ACTION_SERVER, on="function"),
    "rclcpp_action::create_client": Shape(K.ACTION_CLIENT, on="function"),
    "image_transport::create_publisher": Shape(
        K.PUBLISHER, on="function", type="", fixed=IMAGE, queue=1
    ),
    "image_transport::create_subscription": Shape(
        K.SUBSCRIPTION, on="function", type="", fixed=IMAGE, callback=1, queue=3
    ),
    "image_transport::create_camera_publisher": Shape(
        K.PUBLISHER, on="function", type="", fixed=IMAGE, queue=1, beside=_CAMERA
    ),
    "image_transport::create_camera_subscription": Shape(
        K.SUBSCRIPTION, on="function", type="", fixed=IMAGE, callback=1, queue=3, beside=_CAMERA
    ),
}
"""The functions that create endpoints, by full name."""

OBJECTS: dict[str, Shape] = {
    "actionlib::SimpleActionServer": Shape(K.ACTION_SERVER, on="maybe", callback=1),
    "actionlib::ActionServer": Shape(K.ACTION_SERVER, on="maybe", callback=1),
    "actionlib::SimpleActionClient": Shape(K.ACTION_CLIENT, on="maybe"),
    "actionlib::ActionClient": Shape(K.ACTION_CLIENT, on="maybe"),
    "message_filters::Subscriber": Shape(K.SUBSCRIPTION, on="function", queue=1),
    "image_transport::CameraSubscriber": Shape(
        K.SUBSCRIPTION, on="function", type="", fixed=IMAGE, callback=1, queue=3, beside=_CAMERA
    ),
    "image_transport::CameraPublisher": Shape(
        K.PUBLISHER, on="function", type="", fixed=IMAGE, queue=1, beside=_CAMERA
    ),
    "image_transport::Publisher": Shape(K.PUBLISHER, on="function", type="", fixed=IMAGE, queue=1),
    "image_transport::Subscriber": Shape(
        K.SUBSCRIPTION, on="function", type="", fixed=IMAGE, callback=1, queue=3
    ),
    "image_transport::SubscriberFilter": Shape(
        K.SUBSCRIPTION, on="filter", type="", fixed=IMAGE, queue=1
    ),
    # Of ROS 1; that of ROS 2 gets a publisher and no name.
    "realtime_tools::RealtimePublisher": Shape(K.PUBLISHER, on="function", queue=1, latch=2),
}
"""The classes whose objects are endpoints, by full name; a node comes before the rest."""

FILLED: dict[str, tuple[str, ...]] = {
    "subscribe": ("message_filters::Subscriber", "image_transport::SubscriberFilter"),
    "init": ("realtime_tools::RealtimePublisher",),
}
"""The methods that give an empty object what its constructor may get, with the classes."""

HEARD, SENT, SENT_ONCE = ("/tf", "/tf_static"), ("/tf",), ("/tf_static",)

TRANSFORM_OBJECTS: dict[str, tuple[EndpointKind, tuple[str, ...]]] = {
    "tf::TransformListener": (K.SUBSCRIPTION, HEARD),
    "tf2_ros::TransformListener": (K.SUBSCRIPTION, HEARD),
    "tf::TransformBroadcaster": (K.PUBLISHER, SENT),
    "tf2_ros::TransformBroadcaster": (K.PUBLISHER, SENT),
    "tf2_ros::StaticTransformBroadcaster": (K.PUBLISHER, SENT_ONCE),
}
"""The classes whose objects hear of transforms or tell them, by full name."""
