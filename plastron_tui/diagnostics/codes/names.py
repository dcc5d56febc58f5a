"""What a statement names."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

from .programs import LISTENER, TALKER, TALKING

INVALID_VARIABLE = Code(
    "invalid-variable",
    "A variable starts with a letter, and goes on with letters, digits and underscores.",
    bad="create_node 'talker' as _talker\n",
    good="create_node 'talker' as talker\n",
)

VARIABLE_EXISTS = Code(
    "variable-exists",
    "A variable is in use already. Nodes, messages, packages and launch files share one "
    "namespace, so a message cannot have the variable of a node either.",
    bad=f'{TALKER}create_message talker of message_type String and input "bye"\n',
    good=f'{TALKER}create_message farewell of message_type String and input "bye"\n',
)

NODE_EXISTS = Code(
    "node-exists",
    "Two nodes of a program have one name in ROS, where the second would stop the first.",
    bad="create_node 'talker' as first\ncreate_node 'talker' as second\n",
    good="create_node 'talker_1' as first\ncreate_node 'talker_2' as second\n",
)

UNKNOWN_NODE = Code(
    "unknown-node",
    "No node has this variable: it is misspelt, or the node is created further down.",
    bad=f"{LISTENER}generate_node listner\n",
    good=f"{LISTENER}generate_node listener\n",
)

UNKNOWN_MESSAGE = Code(
    "unknown-message",
    "No message has this variable: it is misspelt, or the message is created further down.",
    bad=f"{TALKER}talker publish greetings to 'chatter' of message_type String\n",
    good=TALKING,
)

UNKNOWN_LIBRARY = Code(
    "unknown-library",
    "A node is to use a client library that Plastron does not know.",
    bad="create_node 'talker' as talker using rospi\n",
    good="create_node 'talker' as talker using rospy\n",
)

INVALID_NAME = Code(
    "invalid-name",
    "A node, a topic or a service has a name that ROS does not take. Names are made of "
    "letters, digits, `_` and `/`, and start with a letter, `/` or `~`; the name of a node "
    "has no `/`.",
    bad="create_node 'my talker' as talker\n",
    good="create_node 'my_talker' as talker\n",
)

PRIVATE_NAME = Code(
    "private-name",
    "A private name has no slash behind its `~`, which ROS 2 does not take. `'~/image'` is private "
    "for every node: Plastron writes it as its client library wants it, `~image` for rospy, where "
    "`~/image` would mean `/image`.",
    severity=Severity.WARNING,
    bad="create_node 'camera' as camera using rospy\n"
    "subscribe camera to '~trigger' of message_type std_msgs/Empty\n",
    good="create_node 'camera' as camera using rospy\n"
    "subscribe camera to '~/trigger' of message_type std_msgs/Empty\n",
)

UNKNOWN_TYPE = Code(
    "unknown-type",
    "No message (or service) of this type is known in the ROS distribution that the node is "
    "for. `plastron types` lists those that are. A type of your own is found when its "
    "workspace is sourced, or its folder is named under `types` in `plastron.yaml`. Each "
    "place that names it is reported.",
    bad="create_message origin of message_type Pont and input 1, 2, 3\n",
    good="create_message origin of message_type Point and input 1, 2, 3\n",
)

AMBIGUOUS_TYPE = Code(
    "ambiguous-type",
    "Several packages have a type of this name. Write the package before it.",
    bad="create_node 'watcher' as watcher using rclpy\n"
    "subscribe watcher to 'status' of message_type GoalStatus\n",
    good="create_node 'watcher' as watcher using rclpy\n"
    "subscribe watcher to 'status' of message_type action_msgs/GoalStatus\n",
)

INVALID_FUNCTION = Code(
    "invalid-function",
    "A callback or handler has a name that a function cannot have: a keyword of Python, or a "
    "method that every node has. Or it names what a hand-written file has, and ROS cannot call: "
    "an import, an attribute, or a function with other parameters.",
    bad=f"{LISTENER}subscribe listener to 'orders' of message_type String calling class\n",
    good=f"{LISTENER}subscribe listener to 'orders' of message_type String calling obey\n",
)

FUNCTION_CONFLICT = Code(
    "function-conflict",
    "One function of a node is to take both messages and requests, or requests of two types; or "
    "the messages of two topics, though something is sent `for_each` message of one of them.",
    bad="create_node 'robot' as robot\n"
    "subscribe robot to 'orders' of message_type String calling obey\n"
    "robot provides_service 'stop' of service_type Trigger calling obey\n",
    good="create_node 'robot' as robot\n"
    "subscribe robot to 'orders' of message_type String calling obey\n"
    "robot provides_service 'stop' of service_type Trigger calling stop\n",
)
