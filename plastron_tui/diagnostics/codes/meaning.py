"""What a statement does."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

from .programs import (
    ADDER,
    ASKER,
    BLINKER,
    CALLER,
    COUNTER,
    LISTENER,
    SPEED,
    TALKER,
    TALKING,
)

_LISTENING = (
    "create_node 'listener' as listener using rclpy\n"
    "subscribe listener to 'chatter' of message_type String "
)

_GUARD = (
    "create_node 'guard' as guard\n"
    "subscribe guard to 'scan' of message_type sensor_msgs/LaserScan\n"
    "create_message ahead of message_type Twist and input linear.x=0.2\n"
    "create_message halt of message_type Twist and input linear.x=0\n"
)
_HALTING = (
    "guard publish halt to 'cmd_vel' of message_type Twist for_each 'scan' "
    "when any received.ranges < 0.5\n"
)

ALREADY_SUBSCRIBED = Code(
    "already-subscribed",
    "A node subscribes to a topic twice. Each subscription has a callback of its own, and one "
    "is enough.",
    bad=f"{LISTENER}subscribe listener to 'chatter' of message_type String\n",
    good=LISTENER,
)

ALREADY_PUBLISHING = Code(
    "already-publishing",
    "A node publishes the same message to the same topic twice for the same reason: at a rate, "
    "once, or for each message of a topic under one condition. To send it more often, give the "
    "rate: `at 20 hz`.",
    bad=f"{TALKING}talker publish greeting to 'chatter' of message_type String\n",
    good=f"{TALKER}talker publish greeting to 'chatter' of message_type String at 20 hz\n",
)

ALSO_SENT = Code(
    "also-sent",
    "A node that was loaded publishes a topic, and the program lets it send other messages there "
    "too. They come between those of the file, and a robot obeys both. To send them in place of "
    "the file's, write `stop_publishing` before. What is sent `once`, or `when` something holds, "
    "is taken as meant.",
    severity=Severity.WARNING,
    bad=f"{TALKING}generate_node talker\nload talker_pub as again\n"
    "again publish greeting to 'chatter' of message_type String at 20 hz\n",
    good=f"{TALKING}generate_node talker\nload talker_pub as again\nagain stop_publishing to "
    "'chatter'\nagain publish greeting to 'chatter' of message_type String at 20 hz\n",
)

ALREADY_PROVIDING = Code(
    "already-providing",
    "A node provides a service twice.",
    bad=f"{ADDER}adder provides_service 'add' of service_type AddTwoInts\n",
    good=ADDER,
)

ALREADY_SERVING = Code(
    "already-serving",
    "A node provides an action twice.",
    bad=f"{COUNTER}counter provides_action 'count' of action_type Fibonacci\n",
    good=COUNTER,
)

ALREADY_REPEATING = Code(
    "already-repeating",
    "A node repeats a function twice. To call it more often, give a higher rate. A function that "
    "a loaded file repeats may be given another rate.",
    bad=f"{BLINKER}blinker repeats blink at 4 hz\n",
    good=BLINKER,
)

ALREADY_HAVING = Code(
    "already-having",
    "A node has a parameter twice.",
    bad=f"{SPEED}driver has_parameter 'speed' of parameter_type int with default 1\n",
    good=SPEED,
)

NOT_SUBSCRIBED = Code(
    "not-subscribed",
    "A node is to give up a topic that it does not subscribe to.",
    bad=f"{LISTENER}unsubscribe listener from 'chater'\n",
    good=f"{LISTENER}unsubscribe listener from 'chatter'\n",
)

NOT_PUBLISHING = Code(
    "not-publishing",
    "A node is to give up a topic that it does not publish.",
    bad=f"{TALKING}talker stop_publishing to 'chater'\n",
    good=f"{TALKING}talker stop_publishing to 'chatter'\n",
)

NOT_PROVIDING = Code(
    "not-providing",
    "A node is to give up a service that it does not provide.",
    bad=f"{ADDER}adder stop_service 'ad'\n",
    good=f"{ADDER}adder stop_service 'add'\n",
)

NOT_SERVING = Code(
    "not-serving",
    "A node is to give up an action that it does not provide.",
    bad=f"{COUNTER}counter stop_action 'cont'\n",
    good=f"{COUNTER}counter stop_action 'count'\n",
)

NOT_SENDING = Code(
    "not-sending",
    "A node is to give up an action that it sends no goals to.",
    bad=f"{ASKER}asker stop_goal to 'cont'\n",
    good=f"{ASKER}asker stop_goal to 'count'\n",
)

NOT_REPEATING = Code(
    "not-repeating",
    "A node is to give up a function that it does not repeat.",
    bad=f"{BLINKER}blinker stop_repeating blnk\n",
    good=f"{BLINKER}blinker stop_repeating blink\n",
)

NOT_HAVING = Code(
    "not-having",
    "A node is to give up a parameter that it does not have.",
    bad=f"{SPEED}driver no_longer_has_parameter 'sped'\n",
    good=f"{SPEED}driver no_longer_has_parameter 'speed'\n",
)

STILL_NEEDED = Code(
    "still-needed",
    "A node is to give up something that another statement needs: a topic for each of whose "
    "messages it sends something, or a parameter whose value it sends.",
    bad=f"{SPEED}create_message go of message_type Float64 and input parameter 'speed'\n"
    "driver publish go to 'speed' of message_type Float64\n"
    "driver no_longer_has_parameter 'speed'\n",
    good=f"{SPEED}create_message go of message_type Float64 and input parameter 'speed'\n"
    "driver publish go to 'speed' of message_type Float64\n"
    "driver stop_publishing to 'speed'\n"
    "driver no_longer_has_parameter 'speed'\n",
)

NOTHING_TO_RENAME = Code(
    "nothing-to-rename",
    "A node is to call something by another name that it does not have, or whose name its file "
    "does not say.",
    bad=f"{LISTENER}listener renames topic 'chater' to 'gossip'\n",
    good=f"{LISTENER}listener renames topic 'chatter' to 'gossip'\n",
)

NAME_TAKEN = Code(
    "name-taken",
    "Something of a node is to get a name that another one of its kind has.",
    bad=f"{LISTENER}subscribe listener to 'gossip' of message_type String\n"
    "listener renames topic 'chatter' to 'gossip'\n",
    good=f"{LISTENER}listener renames topic 'chatter' to 'gossip'\n",
)

UNKNOWN_NAME_KIND = Code(
    "unknown-name-kind",
    "What `renames` gives a name to is a topic, a service, an action or a parameter.",
    bad=f"{LISTENER}listener renames topik 'chatter' to 'gossip'\n",
    good=f"{LISTENER}listener renames topic 'chatter' to 'gossip'\n",
)

NOT_REQUESTING = Code(
    "not-requesting",
    "A node is to give up a service that it does not request.",
    bad=f"{CALLER}caller stop_request 'ad'\n",
    good=f"{CALLER}caller stop_request 'add'\n",
)

IDLE_NODE = Code(
    "idle-node",
    "A node is generated that does nothing: it neither publishes nor subscribes, and neither "
    "provides a service nor requests one. What a loaded file does besides is its own affair.",
    bad="create_node 'listener' as listener\ngenerate_node listener\n",
    good=f"{LISTENER}generate_node listener\n",
)

CHANGED_AFTER_GENERATING = Code(
    "changed-after-generating",
    "A statement changes a node after `generate_node` has written it, so that the change is in "
    "no file. `generate_node` writes a node as it is at that point: put it last. Packages and "
    "launch files likewise.",
    severity=Severity.WARNING,
    bad=f"{LISTENER}generate_node listener\nsubscribe listener to 'alarm' of message_type String\n",
    good=f"{LISTENER}subscribe listener to 'alarm' of message_type String\n"
    "generate_node listener\n",
)

MESSAGE_TYPE_MISMATCH = Code(
    "message-type-mismatch",
    "A message is published with another type than it was created with.",
    bad=f"{TALKER}talker publish greeting to 'chatter' of message_type Int32\n",
    good=TALKING,
)

TOPIC_TYPE_CONFLICT = Code(
    "topic-type-conflict",
    "One topic has two types in a program. Nodes then do not hear each other. Where files that "
    "are loaded do not agree, it is a warning.",
    bad=f"{TALKING}create_node 'counter' as counter\n"
    "subscribe counter to '/chatter' of message_type Int32\n",
    good=f"{TALKING}create_node 'counter' as counter\n"
    "subscribe counter to '/chatter' of message_type String\n",
)

SERVICE_TYPE_CONFLICT = Code(
    "service-type-conflict",
    "One service has two types in a program. A call of it then fails. Where files that are loaded "
    "do not agree, it is a warning.",
    bad=f"{ADDER}create_node 'caller' as caller\n"
    "caller client_requests 'add' of service_type Trigger with input none\n",
    good=ADDER + CALLER,
)

ACTION_TYPE_CONFLICT = Code(
    "action-type-conflict",
    "One action has two types in a program. Goals then never arrive. Where files that are loaded "
    "do not agree, it is a warning.",
    bad="create_node 'finder' as finder using rospy\n"
    "finder provides_action 'find' of action_type LookupTransform\n"
    "create_node 'asker' as asker using rospy\n"
    "asker sends_goal to 'find' of action_type GetMap with input none\n",
    good=COUNTER + ASKER,
)

QOS_INCOMPATIBLE = Code(
    "qos-incompatible",
    "A publisher and a subscription of one topic in ROS 2 never match, so that no message goes "
    "from one to the other: the subscription asks for a reliability, a durability, a deadline, a "
    "liveliness or a lease that the publisher does not offer. A publisher offers at least what is "
    "asked for: `reliable` and `transient_local` rather than `best_effort` and `volatile`, "
    "`manual_by_topic` rather than `automatic`, a deadline and a lease that are no longer. What a "
    "file does not say for sure, or leaves to the middleware, is no mistake.",
    bad="create_node 'talker' as talker using rclpy\n"
    'create_message greeting of message_type String and input "hello"\n'
    "talker publish greeting to 'chatter' of message_type String with qos best_effort\n"
    f"{_LISTENING}with qos reliable\n",
    good=f"{TALKING}{_LISTENING}with qos best_effort\n",
)

ENDLESS_MESSAGES = Code(
    "endless-messages",
    "What is sent for each message of a topic comes back to that topic, of the node itself or by "
    "way of others, so that one message is sent again and again as fast as the nodes can.",
    severity=Severity.WARNING,
    bad=f'{LISTENER}create_message note of message_type String and input "heard"\n'
    "listener publish note to 'chatter' of message_type String for_each 'chatter'\n",
    good=f'{LISTENER}create_message note of message_type String and input "heard"\n'
    "listener publish note to 'echo' of message_type String for_each 'chatter'\n",
)

INVALID_QOS = Code(
    "invalid-qos",
    "A quality of service has a word that there is not, one that lacks its number, or two that "
    "contradict each other; or a publisher is given two.",
    bad=f"{_LISTENING}with qos reliable, best_effort\n",
    good=f"{_LISTENING}with qos best_effort\n",
)

NOT_IN_ROS_1 = Code(
    "not-in-ros-1",
    "ROS 1 has no managed nodes, and of the words of quality of service only some: the others are "
    "left out there, with a warning.",
    bad="create_node 'talker' as talker managed using rospy\n",
    good="create_node 'talker' as talker managed using rclpy\n",
)

MISSPELT_NAME = Code(
    "misspelt-name",
    "A warning: one side alone uses a topic or a service, and the other side alone uses a name "
    "that is one slip of the finger from it, of the same type. Names that differ in a digit, or by "
    "words of one or two letters, are taken as they are.",
    severity=Severity.WARNING,
    bad=f"{TALKING}create_node 'listener' as listener\n"
    "subscribe listener to 'chater' of message_type String\n",
    good=f"{TALKING}create_node 'listener' as listener\n"
    "subscribe listener to 'chatter' of message_type String\n",
)

UNCONDITIONAL_MOTION = Code(
    "unconditional-motion",
    "A warning: a robot is told to move at a rate, and on the same topic to move or to stop as a "
    "sensor says. No topic gives one message precedence over another: the robot does what it was "
    "told last, and drives on. Send each such message under a condition, as the recipe *Emergency "
    "stop* does. A message that stops the robot may be sent at a rate. What a loaded file sends is "
    "not known.",
    severity=Severity.WARNING,
    bad=f"{_GUARD}guard publish ahead to 'cmd_vel' of message_type Twist at 10 hz\n{_HALTING}",
    good=f"{_GUARD}guard publish ahead to 'cmd_vel' of message_type Twist for_each 'scan' "
    f"when all received.ranges > 0.5\n{_HALTING}",
)

SERVICE_PROVIDED_TWICE = Code(
    "service-provided-twice",
    "A warning: two nodes of a program provide one service. ROS gives a call to one of them "
    "only, in ROS 1 to the one that came last.",
    severity=Severity.WARNING,
    bad=f"{ADDER}create_node 'adder_2' as spare\n"
    "spare provides_service 'add' of service_type AddTwoInts\n",
    good=f"{ADDER}create_node 'adder_2' as spare\n"
    "spare provides_service 'add_2' of service_type AddTwoInts\n",
)

NODE_NOT_FOUND = Code(
    "node-not-found",
    "The file that `load` names holds no node of the name that stands after `node`.",
    bad=f"{LISTENER}generate_node listener\nload listener_sub1 node 'talker' as again\n",
    good=f"{LISTENER}generate_node listener\nload listener_sub1 node 'listener' as again\n",
)

FILE_NOT_FOUND = Code(
    "file-not-found",
    "A node is to be loaded from a file that is not there. `load NAME` looks for `NAME.py`, "
    "then `NAME.cpp`, in the output folder, the program's folder and the working folder; "
    "`load 'path'` is relative to the program's folder.",
    bad="load listener_sub1 as listener\n",
    good=f"{LISTENER}generate_node listener\nload listener_sub1 as again\n",
)
