"""The codes of what is wrong with the statements of a program."""

from __future__ import annotations

from . import escapes
from .code import Code

_TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
"""
_TALKING = f"{_TALKER}talker publish greeting to 'chatter' of message_type String\n"
_LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
"""
_ADDER = """\
create_node 'adder' as adder
adder provides_service 'add' of service_type AddTwoInts
"""
_CALLER = """\
create_node 'caller' as caller
caller client_requests 'add' of service_type AddTwoInts with input 5, 6
"""

SYNTAX_CODES = (
    Code(
        "unknown-statement",
        "A line starts with no word that starts a statement, and is no node doing something "
        "either. Often a word is misspelt; the help line then offers the nearest one.",
        bad="creat_node 'talker' as talker\n",
        good="create_node 'talker' as talker\n",
    ),
    Code(
        "syntax-error",
        "A statement is not the sentence that its first words promise: a word is missing, "
        "misspelt, or too many. The help line has the whole sentence, or what to write.",
        bad=f"{_LISTENER}unsubscribe listener form 'chatter'\n",
        good=f"{_LISTENER}unsubscribe listener from 'chatter'\n",
    ),
    Code(
        "unclosed-quote",
        "A name in single quotes, or a text in double quotes, is not closed on its line.",
        bad="create_node 'talker as talker\n",
        good="create_node 'talker' as talker\n",
    ),
    Code(
        "unclosed-comment",
        "A comment that starts with `/*` is not closed with `*/`. The lines after it still count "
        "as statements.",
        bad="/* a node that talks\ncreate_node 'talker' as talker\n",
        good="/* a node that talks */\ncreate_node 'talker' as talker\n",
    ),
    Code(
        "unknown-escape",
        "A backslash in a text is followed by something that no escape is made of. The escapes "
        f"are {escapes.listed('`')}.",
        bad='create_message path of message_type String and input "C:\\docs"\n',
        good='create_message path of message_type String and input "C:\\\\docs"\n',
    ),
    Code(
        "keyword-as-variable",
        "A word of the language stands where the variable of a node or of a message belongs.",
        bad="create_node 'talker' as publish\n",
        good="create_node 'talker' as publisher\n",
    ),
    Code(
        "too-deep",
        "Values are in more parentheses or brackets than any message is deep.",
        bad="create_message origin of message_type Point and input "
        + "(" * 60
        + "1"
        + ")" * 60
        + "\n",
        good="create_message origin of message_type Point and input 1, 0, 0\n",
    ),
)

NAME_CODES = (
    Code(
        "invalid-variable",
        "A variable starts with a letter, and goes on with letters, digits and underscores.",
        bad="create_node 'talker' as _talker\n",
        good="create_node 'talker' as talker\n",
    ),
    Code(
        "variable-exists",
        "A variable is in use already. Nodes and messages share one namespace, so a message "
        "cannot have the variable of a node either.",
        bad=f'{_TALKER}create_message talker of message_type String and input "bye"\n',
        good=f'{_TALKER}create_message farewell of message_type String and input "bye"\n',
    ),
    Code(
        "node-exists",
        "Two nodes of a program have one name in ROS, where the second would stop the first.",
        bad="create_node 'talker' as first\ncreate_node 'talker' as second\n",
        good="create_node 'talker_1' as first\ncreate_node 'talker_2' as second\n",
    ),
    Code(
        "unknown-node",
        "No node has this variable: it is misspelt, or the node is created further down.",
        bad=f"{_LISTENER}generate_node listner\n",
        good=f"{_LISTENER}generate_node listener\n",
    ),
    Code(
        "unknown-message",
        "No message has this variable: it is misspelt, or the message is created further down.",
        bad=f"{_TALKER}talker publish greetings to 'chatter' of message_type String\n",
        good=_TALKING,
    ),
    Code(
        "unknown-library",
        "A node is to use a client library that Plastron does not know.",
        bad="create_node 'talker' as talker using rospi\n",
        good="create_node 'talker' as talker using rospy\n",
    ),
    Code(
        "invalid-name",
        "A node, a topic or a service has a name that ROS does not take. Names are made of "
        "letters, digits, `_` and `/`, and start with a letter, `/` or `~`; the name of a node "
        "has no `/`.",
        bad="create_node 'my talker' as talker\n",
        good="create_node 'my_talker' as talker\n",
    ),
    Code(
        "unknown-type",
        "No message (or service) of this type is known in the ROS distribution that the node is "
        "for. `plastron types` lists those that are. A type of your own is found when its "
        "workspace is sourced, or its folder is named under `types` in `plastron.yaml`. Each "
        "place that names it is reported.",
        bad="create_message origin of message_type Pont and input 1, 2, 3\n",
        good="create_message origin of message_type Point and input 1, 2, 3\n",
    ),
    Code(
        "ambiguous-type",
        "Several packages have a type of this name. Write the package before it.",
        bad="create_node 'watcher' as watcher using rclpy\n"
        "subscribe watcher to 'status' of message_type GoalStatus\n",
        good="create_node 'watcher' as watcher using rclpy\n"
        "subscribe watcher to 'status' of message_type action_msgs/GoalStatus\n",
    ),
    Code(
        "invalid-function",
        "A callback or handler has a name that a function cannot have: a keyword of Python, or a "
        "method that every node has.",
        bad=f"{_LISTENER}subscribe listener to 'orders' of message_type String calling class\n",
        good=f"{_LISTENER}subscribe listener to 'orders' of message_type String calling obey\n",
    ),
    Code(
        "function-conflict",
        "One function of a node is to take both messages and requests, or requests of two types.",
        bad="create_node 'robot' as robot\n"
        "subscribe robot to 'orders' of message_type String calling obey\n"
        "robot provides_service 'stop' of service_type Trigger calling obey\n",
        good="create_node 'robot' as robot\n"
        "subscribe robot to 'orders' of message_type String calling obey\n"
        "robot provides_service 'stop' of service_type Trigger calling stop\n",
    ),
)

MEANING_CODES = (
    Code(
        "already-subscribed",
        "A node subscribes to a topic twice. Each subscription has a callback of its own, and one "
        "is enough.",
        bad=f"{_LISTENER}subscribe listener to 'chatter' of message_type String\n",
        good=_LISTENER,
    ),
    Code(
        "already-publishing",
        "A node publishes the same message to the same topic twice. To send it more often, give "
        "the rate: `at 20 hz`.",
        bad=f"{_TALKING}talker publish greeting to 'chatter' of message_type String\n",
        good=f"{_TALKER}talker publish greeting to 'chatter' of message_type String at 20 hz\n",
    ),
    Code(
        "already-providing",
        "A node provides a service twice.",
        bad=f"{_ADDER}adder provides_service 'add' of service_type AddTwoInts\n",
        good=_ADDER,
    ),
    Code(
        "not-subscribed",
        "A node is to give up a topic that it does not subscribe to.",
        bad=f"{_LISTENER}unsubscribe listener from 'chater'\n",
        good=f"{_LISTENER}unsubscribe listener from 'chatter'\n",
    ),
    Code(
        "not-publishing",
        "A node is to give up a topic that it does not publish.",
        bad=f"{_TALKING}talker stop_publishing to 'chater'\n",
        good=f"{_TALKING}talker stop_publishing to 'chatter'\n",
    ),
    Code(
        "not-providing",
        "A node is to give up a service that it does not provide.",
        bad=f"{_ADDER}adder stop_service 'ad'\n",
        good=f"{_ADDER}adder stop_service 'add'\n",
    ),
    Code(
        "not-requesting",
        "A node is to give up a service that it does not request.",
        bad=f"{_CALLER}caller stop_request 'ad'\n",
        good=f"{_CALLER}caller stop_request 'add'\n",
    ),
    Code(
        "idle-node",
        "A node is generated that does nothing: it neither publishes nor subscribes, and neither "
        "provides a service nor requests one.",
        bad="create_node 'listener' as listener\ngenerate_node listener\n",
        good=f"{_LISTENER}generate_node listener\n",
    ),
    Code(
        "changed-after-generating",
        "A statement changes a node after `generate_node` has written it, so that the change is in "
        "no file. `generate_node` writes a node as it is at that point: put it last.",
        bad=f"{_LISTENER}generate_node listener\n"
        "subscribe listener to 'alarm' of message_type String\n",
        good=f"{_LISTENER}subscribe listener to 'alarm' of message_type String\n"
        "generate_node listener\n",
    ),
    Code(
        "message-type-mismatch",
        "A message is published with another type than it was created with.",
        bad=f"{_TALKER}talker publish greeting to 'chatter' of message_type Int32\n",
        good=_TALKING,
    ),
    Code(
        "topic-type-conflict",
        "One topic has two types in a program. Nodes then do not hear each other.",
        bad=f"{_TALKING}create_node 'counter' as counter\n"
        "subscribe counter to '/chatter' of message_type Int32\n",
        good=f"{_TALKING}create_node 'counter' as counter\n"
        "subscribe counter to '/chatter' of message_type String\n",
    ),
    Code(
        "service-type-conflict",
        "One service has two types in a program. A call of it then fails.",
        bad=f"{_ADDER}create_node 'caller' as caller\n"
        "caller client_requests 'add' of service_type Trigger with input none\n",
        good=_ADDER + _CALLER,
    ),
    Code(
        "service-provided-twice",
        "A warning: two nodes of a program provide one service. ROS gives a call to one of them "
        "only, in ROS 1 to the one that came last.",
        bad=f"{_ADDER}create_node 'adder_2' as spare\n"
        "spare provides_service 'add' of service_type AddTwoInts\n",
        good=f"{_ADDER}create_node 'adder_2' as spare\n"
        "spare provides_service 'add_2' of service_type AddTwoInts\n",
    ),
    Code(
        "several-nodes",
        "A file holds several nodes, and `load` does not say which one is meant: write the name "
        "that it has in the file, as in `load arms node 'left_arm' as left`. Where the file does "
        "not say a node's name, the name of its class stands for it.",
    ),
    Code(
        "node-not-found",
        "The file that `load` names holds no node of the name that stands after `node`.",
        bad=f"{_LISTENER}generate_node listener\nload listener_sub1 node 'talker' as again\n",
        good=f"{_LISTENER}generate_node listener\nload listener_sub1 node 'listener' as again\n",
    ),
    Code(
        "file-not-found",
        "A node is to be loaded from a file that is not there. `load NAME` looks for `NAME.py`, "
        "then `NAME.cpp`, in the output folder, the program's folder and the working folder; "
        "`load 'path'` is relative to the program's folder.",
        bad="load listener_sub1 as listener\n",
        good=f"{_LISTENER}generate_node listener\nload listener_sub1 as again\n",
    ),
)

PROGRAM_CODES = (*SYNTAX_CODES, *NAME_CODES, *MEANING_CODES)
