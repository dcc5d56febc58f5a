"""The statements of the language, each declared once."""

from __future__ import annotations

from .declaration import SlotKind, Statement, slot, statement
from .inputs import Input

NAME_HELP = "what the node is called in the ROS graph"
TOPIC_HELP = "the topic, a name that nodes share"
SERVICE_HELP = "the service, a name that nodes share"
LIBRARY_HELP = "rospy for ROS 1, rclpy for ROS 2; without it, the one that is in use"
CALLBACK_HELP = "the function that is called; made if the file has none of that name"


@statement(
    "create_node_statement",
    "create_node {name} as {variable} [using {library}]",
    summary="Make a new node.",
    example="create_node 'talker' as talker",
    purpose="make a node",
    ros_term="node",
    about="A node is a program of its own that does one thing; a robot runs many.",
)
class CreateNode(Statement):
    """Make a new node."""

    name: str = slot(SlotKind.NODE_NAME, NAME_HELP)
    variable: str = slot(SlotKind.NEW_NODE, "what the program calls the node")
    library: str | None = slot(SlotKind.LIBRARY, LIBRARY_HELP)


@statement(
    "load_statement",
    "load {source} [node {name}] as {variable}",
    summary="Read a node from a source file, to change it.",
    example="load 'scripts/driver.py' as driver",
    purpose="change a node file that exists",
    ros_term="node file",
    about="Only what you ask for changes; the result goes to the output folder.",
)
class Load(Statement):
    """Read a node from a source file."""

    source: str = slot(
        SlotKind.FILE,
        "a file in the output folder by its name, or a path from the program's folder",
    )
    name: str | None = slot(
        SlotKind.NODE_OF_FILE,
        "which node, where the file holds several: the name that it has there",
    )
    variable: str = slot(SlotKind.NEW_NODE, "what the program calls the node")

    @property
    def is_path(self) -> bool:
        """Whether the file is given as a path in quotes, not as a bare name."""
        child = self.syntax.child_by_field_name("source")
        return child is not None and child.type == "path"


@statement(
    "create_message_statement",
    "create_message {variable} of message_type {type} and input {input}",
    summary="Make a message with its values.",
    example="create_message origin of message_type Point and input 0, 0, 0",
    purpose="make a message",
    ros_term="message",
    about="A message is what nodes send each other: a few named values.",
)
class CreateMessage(Statement):
    """Make a message with its values."""

    variable: str = slot(SlotKind.NEW_MESSAGE, "what the program calls the message")
    type: str = slot(SlotKind.MESSAGE_TYPE, "the type of the message")
    input: Input = slot(SlotKind.INPUT, "the values of its fields, in order or by name")


@statement(
    "subscribe_statement",
    "subscribe {node} to {topic} of message_type {type} [calling {function}]",
    summary="Let a node listen to a topic.",
    example="subscribe listener to 'chatter' of message_type String",
    purpose="react to what others send",
    ros_term="subscriber",
    about="A function of the node is called with each message that arrives on a topic.",
)
class Subscribe(Statement):
    """Let a node listen to a topic."""

    node: str = slot(SlotKind.NODE, "the node that listens")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)
    type: str = slot(SlotKind.MESSAGE_TYPE, "the type of the topic's messages")
    function: str | None = slot(SlotKind.FUNCTION, CALLBACK_HELP)


@statement(
    "unsubscribe_statement",
    "unsubscribe {node} from {topic}",
    summary="Let a node no longer listen to a topic.",
    example="unsubscribe listener from 'chatter'",
    purpose="no longer react to what others send",
    ros_term="subscriber",
    about="Takes a subscriber away again.",
    undoes=Subscribe,
)
class Unsubscribe(Statement):
    """Let a node no longer listen to a topic."""

    node: str = slot(SlotKind.NODE, "the node that listens")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)


@statement(
    "publish_statement",
    "{node} publish {message} to {topic} of message_type {type} [at {rate} hz]",
    summary="Let a node send a message to a topic, again and again.",
    example="talker publish greeting to 'chatter' of message_type String at 2 hz",
    purpose="send something, again and again",
    ros_term="publisher",
    about="A message goes out on a topic, so many times a second; whoever listens gets it.",
)
class Publish(Statement):
    """Let a node send a message to a topic, again and again."""

    node: str = slot(SlotKind.NODE, "the node that sends")
    message: str = slot(SlotKind.MESSAGE, "the message that it sends")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)
    type: str = slot(SlotKind.MESSAGE_TYPE, "the type of the topic's messages")
    rate: int | float | None = slot(
        SlotKind.RATE,
        "how often, in hertz; without it 10, or as often as the loop of a loaded file",
    )


@statement(
    "stop_publishing_statement",
    "{node} stop_publishing to {topic}",
    summary="Let a node no longer send to a topic.",
    example="talker stop_publishing to 'chatter'",
    purpose="no longer send something",
    ros_term="publisher",
    about="Takes a publisher away again.",
    undoes=Publish,
)
class StopPublishing(Statement):
    """Let a node no longer send to a topic."""

    node: str = slot(SlotKind.NODE, "the node that sends")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)


@statement(
    "client_requests_statement",
    "{node} client_requests {service} of service_type {type} with input {input}",
    summary="Let a node call a service.",
    example="caller client_requests 'add' of service_type AddTwoInts with input 5, 6",
    purpose="ask a question and wait for the answer",
    ros_term="service client",
    about="A request goes to the one node that provides the service, and its answer comes back.",
)
class ClientRequests(Statement):
    """Let a node call a service."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)
    type: str = slot(SlotKind.SERVICE_TYPE, "the type of the service")
    input: Input = slot(SlotKind.INPUT, "the values of the request, in order or by name")


@statement(
    "stop_request_statement",
    "{node} stop_request {service}",
    summary="Let a node no longer call a service.",
    example="caller stop_request 'add'",
    purpose="no longer ask a question",
    ros_term="service client",
    about="Takes a service client away again.",
    undoes=ClientRequests,
)
class StopRequest(Statement):
    """Let a node no longer call a service."""

    node: str = slot(SlotKind.NODE, "the node that asks")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)


@statement(
    "provides_service_statement",
    "{node} provides_service {service} of service_type {type} [calling {function}]",
    summary="Let a node answer the calls of a service.",
    example="adder provides_service 'add' of service_type AddTwoInts",
    purpose="answer questions",
    ros_term="service",
    about="Other nodes call, a function of this node works out the answer.",
)
class ProvidesService(Statement):
    """Let a node answer the calls of a service."""

    node: str = slot(SlotKind.NODE, "the node that answers")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)
    type: str = slot(SlotKind.SERVICE_TYPE, "the type of the service")
    function: str | None = slot(SlotKind.FUNCTION, CALLBACK_HELP)


@statement(
    "stop_service_statement",
    "{node} stop_service {service}",
    summary="Let a node no longer answer the calls of a service.",
    example="adder stop_service 'add'",
    purpose="no longer answer questions",
    ros_term="service",
    about="Takes a service away again.",
    undoes=ProvidesService,
)
class StopService(Statement):
    """Let a node no longer answer the calls of a service."""

    node: str = slot(SlotKind.NODE, "the node that answers")
    service: str = slot(SlotKind.SERVICE, SERVICE_HELP)


@statement(
    "rename_statement",
    "{node} renames {what} {old} to {new}",
    summary="Give something of a node another name.",
    example="driver renames topic 'scan' to 'front/scan'",
    purpose="give something another name",
    ros_term="name",
    about="Nodes meet by names; everything else about what is renamed stays as it is.",
)
class Rename(Statement):
    """Give something of a node another name."""

    node: str = slot(SlotKind.NODE, "the node whose name for it changes")
    what: str = slot(SlotKind.NAMED, "what has the name")
    old: str = slot(SlotKind.OLD_NAME, "the name that it has")
    new: str = slot(SlotKind.NEW_NAME, "the name that it gets")


@statement(
    "generate_node_statement",
    "generate_node {node} [using {library}]",
    summary="Write a node to its source file.",
    example="generate_node talker",
    purpose="write a node to its file",
    ros_term="source file",
    about="The file is Python that you can read, run and go on with by hand.",
    writes_file=True,
)
class GenerateNode(Statement):
    """Write a node to its source file."""

    node: str = slot(SlotKind.NODE, "the node that is written")
    library: str | None = slot(SlotKind.LIBRARY, LIBRARY_HELP)
