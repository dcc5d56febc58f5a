"""The statements about messages, and the topics that they travel on."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..inputs import Condition, Input, QosWords, Rate
from .shared import CALLBACK_HELP, QOS_HELP

TOPIC_HELP = "the topic, a name that nodes share"


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
    "subscribe {node} to {topic} of message_type {type} [with qos {qos}] [calling {function}]",
    summary="Let a node listen to a topic.",
    example="subscribe listener to 'chatter' of message_type String",
    purpose="react to what others send",
    ros_term="subscriber",
    about="A function of the node is called with each message that arrives on a topic. "
    "What it sends for each of them comes next.",
)
class Subscribe(Statement):
    """Let a node listen to a topic."""

    node: str = slot(SlotKind.NODE, "the node that listens")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)
    type: str = slot(SlotKind.MESSAGE_TYPE, "the type of the topic's messages")
    qos: QosWords | None = slot(SlotKind.QOS, QOS_HELP)
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
    "{node} publish {message} to {topic} of message_type {type}"
    " [at {rate} hz | {once} | for_each {trigger} [when {condition}]] [with qos {qos}]",
    summary="Let a node send a message to a topic: at a rate, once, or for each that arrives.",
    example="talker publish greeting to 'chatter' of message_type String at 2 hz",
    purpose="send something, at a rate, once, or when something arrives",
    ros_term="publisher",
    about="A message goes to all who listen: again and again, or to stop when something is near.",
)
class Publish(Statement):
    """Let a node send a message to a topic: at a rate, once, or for each that arrives."""

    node: str = slot(SlotKind.NODE, "the node that sends")
    message: str = slot(SlotKind.MESSAGE, "the message that it sends")
    topic: str = slot(SlotKind.TOPIC, TOPIC_HELP)
    type: str = slot(SlotKind.MESSAGE_TYPE, "the type of the topic's messages")
    rate: Rate | None = slot(
        SlotKind.RATE,
        "how often, in hertz; without it 10, or in a loaded file's loop once each time round",
    )
    once: bool = slot(SlotKind.ONCE, "sent once, and to each who listens later")
    trigger: str | None = slot(
        SlotKind.TRIGGER, "instead of at a rate, for each message that arrives on this topic"
    )
    condition: Condition | None = slot(
        SlotKind.CONDITION, "what must hold of what arrives; without it, each is answered"
    )
    qos: QosWords | None = slot(SlotKind.QOS, QOS_HELP)


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
