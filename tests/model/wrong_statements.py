"""Statements about what else a node does that are wrong, and what is said of each."""

from __future__ import annotations

BEFORE = """\
create_node 'driver' as n
n has_parameter 'speed' of parameter_type float with default 0.5
n has_parameter 'count' of parameter_type int with default 2
n has_parameter 'names' of parameter_type string_list with default ["a"]
n has_parameter 'idle' of parameter_type float with default 0
subscribe n to 'scan' of message_type sensor_msgs/LaserScan
subscribe n to 'text' of message_type String
subscribe n to 'news' of message_type String calling heard
subscribe n to 'left' of message_type String calling both
subscribe n to 'right' of message_type String calling both
n repeats tick at 1 hz
n provides_action 'acts' of action_type Fibonacci calling act
n sends_goal to 'done' of action_type Fibonacci with input none
create_message go of message_type Twist and input linear.x=parameter 'speed'
create_message near of message_type Float32 and input received.ranges[0] * 2
create_message m of message_type String and input "a"
n publish m to 'echo' of message_type String for_each 'news'
n publish m to 'kept' of message_type String with qos latched, depth 3
create_message other of message_type String and input "b"
n publish other to 'deep' of message_type String with qos depth 3
"""

NEAR = "n publish near to 'd' of message_type Float32"
PUBLISH = "n publish m to 'd' of message_type String"
ANSWER = "n provides_service 's' of service_type AddTwoInts answering"
GOAL = "n sends_goal to 'done' of action_type Fibonacci with input"
PARAMETER = "n has_parameter 'x' of parameter_type"
SERVE = "n provides_action 'b' of action_type"
REQUEST = "n client_requests 's' of service_type AddTwoInts with input"

ON_BYTES = (
    "subscribe n to 'byte' of message_type UInt8\n"
    "n publish m to 'd' of message_type String for_each 'byte' when"
)
ON_BOOL = ON_BYTES.replace("UInt8", "Bool")

# What follows, the code, the text that is marked, what the help says.
MISTAKES: list[tuple[str, str, str, str | None]] = [
    (
        "n has_parameter 'speed' of parameter_type float with default 1",
        "already-having",
        "'speed'",
        None,
    ),
    (f"{PARAMETER} flot with default 1", "unknown-parameter-type", "flot", "did you mean `float`?"),
    (
        f"{PARAMETER} double with default 1",
        "unknown-parameter-type",
        "double",
        "did you mean `float`?",
    ),
    (
        f"{PARAMETER} int with default 1.5",
        "parameter-type-mismatch",
        "1.5",
        "write a whole number, such as `1`",
    ),
    (
        f"{PARAMETER} int with default True",
        "parameter-type-mismatch",
        "True",
        "write a whole number, such as `1`",
    ),
    (
        f"{PARAMETER} bool with default 1",
        "parameter-type-mismatch",
        "1",
        "write `True` or `False`",
    ),
    (
        f"{PARAMETER} string with default 1",
        "parameter-type-mismatch",
        "1",
        'write a text, such as `"front"`',
    ),
    (
        f'{PARAMETER} float_list with default [1, "a"]',
        "parameter-type-mismatch",
        '[1, "a"]',
        "write a list, such as `[0.5, 1.0]`",
    ),
    (
        f"{PARAMETER} int with default 99999999999999999999",
        "parameter-type-mismatch",
        "99999999999999999999",
        "write a whole number, such as `1`",
    ),
    (
        f"{PARAMETER} float with default 1e999",
        "parameter-type-mismatch",
        "1e999",
        "write a number, such as `0.5`",
    ),
    (
        f"{PARAMETER} float with default parameter 'speed'",
        "parameter-type-mismatch",
        "parameter 'speed'",
        "write a number, such as `0.5`",
    ),
    (
        f"{PARAMETER} float with default received.a",
        "parameter-type-mismatch",
        "received.a",
        "write a number, such as `0.5`",
    ),
    (
        f"{PARAMETER} float with default (1)",
        "parameter-type-mismatch",
        "(1)",
        "write a number, such as `0.5`",
    ),
    (f"{PARAMETER} float with default 3 between 0 and 2", "invalid-range", "3", None),
    (
        f"{PARAMETER} float with default 1 between 2 and 0",
        "invalid-range",
        "2 and 0",
        "write `between 0 and 2`",
    ),
    (f"{PARAMETER} int with default 1 between 0.5 and 2", "invalid-range", "0.5 and 2", None),
    (f'{PARAMETER} string with default "a" between 0 and 2', "invalid-range", "0 and 2", None),
    (f"{PARAMETER} int_list with default [1] between 0 and 2", "invalid-range", "0 and 2", None),
    ("n no_longer_has_parameter 'sped'", "not-having", "'sped'", "did you mean `speed`?"),
    ("n no_longer_has_parameter 'nothing'", "not-having", "'nothing'", None),
    (
        "n publish go to 'v' of message_type Twist\nn no_longer_has_parameter 'speed'",
        "still-needed",
        "'speed'",
        "take away first what needs it",
    ),
    (
        "n repeats f at parameter 'count' hz\nn no_longer_has_parameter 'count'",
        "still-needed",
        "'count'",
        "take away first what needs it",
    ),
    (
        "n repeats f at parameter 'sped' hz",
        "unknown-parameter",
        "parameter 'sped'",
        "did you mean `speed`?",
    ),
    ("n repeats f at parameter 'names' hz", "parameter-type-mismatch", "parameter 'names'", None),
    ("n repeats f at parameter 'idle' hz", "invalid-rate", "parameter 'idle'", None),
    ("n repeats f at 0 hz", "invalid-rate", "0", "write how often, such as `at 1 hz`"),
    ("n repeats f at 1e-12 hz", "invalid-rate", "1e-12", None),
    ("n repeats f at -2 hz", "invalid-rate", "-2", "write `at 2 hz`"),
    ("n repeats tick at 2 hz", "already-repeating", "tick", None),
    ("n repeats act at 2 hz", "function-conflict", "act", "each kind of message and"),
    (
        "subscribe n to 'words' of message_type String calling heard",
        "function-conflict",
        "heard",
        "each kind of message and",
    ),
    (f"{PUBLISH} for_each 'left'", "function-conflict", "'left'", "let `n` call another function"),
    ("n repeats class at 2 hz", "invalid-function", "class", "write `class_`"),
    ("n stop_repeating tik", "not-repeating", "tik", "did you mean `tick`?"),
    ("n stop_repeating nothing", "not-repeating", "nothing", None),
    ("n provides_action 'acts' of action_type Fibonacci", "already-serving", "'acts'", None),
    (f"{SERVE} Fibonaci", "unknown-type", "Fibonaci", "did you mean `Fibonacci`?"),
    (f"{SERVE} Fibonacci calling tick", "function-conflict", "tick", "each kind of message and"),
    ("n provides_action 'b c' of action_type Fibonacci", "invalid-name", " ", "write 'b_c'"),
    ("n stop_action 'act'", "not-serving", "'act'", "did you mean `acts`?"),
    ("n stop_action 'done'", "not-serving", "'done'", None),
    (f'{GOAL} order="a"', "wrong-kind-of-value", '"a"', "`order` is of type `int32`"),
    (f"{GOAL} order=parameter 'speed'", "computed-type-mismatch", "parameter 'speed'", None),
    (
        f"{GOAL} order=parameter 'coun'",
        "unknown-parameter",
        "parameter 'coun'",
        "did you mean `count`?",
    ),
    (f"{GOAL} order=received.x", "nothing-received", "received.x", "send it"),
    ("n stop_goal to 'dine'", "not-sending", "'dine'", "did you mean `done`?"),
    (
        f"{REQUEST} a=parameter 'count' / 2",
        "computed-type-mismatch",
        "parameter 'count' / 2",
        None,
    ),
    (f"{REQUEST} none at 0 hz", "invalid-rate", "0", "such as `at 1 hz`"),
    (f"{ANSWER} sum=received.c", "unknown-field", "received.c", "its fields are: a, b"),
    (f"{ANSWER} sum=received.a / 2", "computed-type-mismatch", "received.a / 2", None),
    (
        f"{ANSWER} sum=received.a / received.b",
        "computed-type-mismatch",
        "received.a / received.b",
        "what is divided may have a fraction",
    ),
    (f"{ANSWER} sum=received.a + received.c", "unknown-field", "received.c", "fields are: a, b"),
    (
        f"{ANSWER} sum=received.a + parameter 'speed'",
        "computed-type-mismatch",
        "received.a + parameter 'speed'",
        None,
    ),
    (
        f"{ANSWER} sum=received.a + parameter 'names' * 2",
        "computed-type-mismatch",
        "parameter 'names'",
        None,
    ),
    (f"{ANSWER} sum=received.a / 0.0", "value-out-of-range", "received.a / 0.0", None),
    (
        f"{ANSWER} sum=received.a * parameter 'count'\nn no_longer_has_parameter 'count'",
        "still-needed",
        "'count'",
        "take away first what needs it",
    ),
    (
        f"{REQUEST} a=parameter 'count' * parameter 'count'",
        "nothing-received",
        "parameter 'count' * parameter 'count'",
        "one parameter and numbers",
    ),
    (
        "create_message k of message_type Float32 and input received.range_min + received.ranges\n"
        "n publish k to 'd' of message_type Float32 for_each 'scan'",
        "computed-type-mismatch",
        "received.ranges",
        "write `received.ranges[0]`",
    ),
    (f"{ANSWER} a=1", "unknown-field", "a", "its fields are: sum"),
    (f"{ANSWER} sum=parameter 'names'", "computed-type-mismatch", "parameter 'names'", None),
    (f"{NEAR}", "nothing-received", "near", "send it"),
    (f"{NEAR} for_each 'text'", "unknown-field", "received.ranges[0]", "its fields are: data"),
    (f"{NEAR} for_each 'scan'\n{NEAR} for_each 'scan'", "already-publishing", "'d'", None),
    (f"{PUBLISH}\n{PUBLISH} at 2 hz", "already-publishing", "'d'", None),
    (f"{PUBLISH} once\n{PUBLISH} once", "already-publishing", "'d'", None),
    (f"{NEAR} for_each 'scn'", "not-subscribed", "'scn'", "did you mean `scan`?"),
    (
        f"{NEAR} for_each 'scan' when received.ranges < 1",
        "computed-type-mismatch",
        "received.ranges < 1",
        None,
    ),
    (
        f"{NEAR} for_each 'scan' when any received.range_min < 1",
        "computed-type-mismatch",
        "any received.range_min < 1",
        "leave `any` out",
    ),
    (
        f"{NEAR} for_each 'scan' when received.range_min = \"a\"",
        "computed-type-mismatch",
        'received.range_min = "a"',
        None,
    ),
    (
        f"{NEAR} for_each 'scan' when received.rangs[0] < 1",
        "unknown-field",
        "received.rangs[0]",
        "did you mean `ranges`?",
    ),
    (
        f"{NEAR} for_each 'scan' when received.ranges[-1] < 1",
        "value-out-of-range",
        "received.ranges[-1]",
        None,
    ),
    (
        f"{NEAR} for_each 'scan' when received.ranges[0.5] < 1",
        "value-out-of-range",
        "received.ranges[0.5]",
        None,
    ),
    (
        f"{NEAR} for_each 'scan' when received.header.stamp < 1",
        "computed-type-mismatch",
        "received.header.stamp < 1",
        None,
    ),
    (
        f"{NEAR} for_each 'scan' when received.header.frame_id < \"a\"",
        "computed-type-mismatch",
        'received.header.frame_id < "a"',
        "a text is compared with `=`",
    ),
    (
        f"{NEAR} for_each 'scan' when received.header.frame_id.x < 1",
        "unknown-field",
        "received.header.frame_id.x",
        "that field has no parts",
    ),
    (
        f"{NEAR} for_each 'scan'\nunsubscribe n from 'scan'",
        "still-needed",
        "'scan'",
        "take away first what needs it",
    ),
    (f"{PUBLISH} with qos relyable", "invalid-qos", "relyable", "did you mean `reliable`?"),
    (
        "n publish m to 'deep' of message_type String once",
        "invalid-qos",
        "once",
        "write `latched` with the quality of service",
    ),
    (f"{PUBLISH} with qos depth", "invalid-qos", "depth", "write `depth 10`"),
    (f"{PUBLISH} with qos depth 0.5", "invalid-qos", "depth 0.5", "write `depth 10`"),
    (f"{PUBLISH} with qos depth -1", "invalid-qos", "depth -1", "write `depth 10`"),
    (f"{PUBLISH} with qos latched, volatile", "invalid-qos", "volatile", "leave one of them out"),
    (f"{PUBLISH} with qos reliable 5", "invalid-qos", "reliable 5", "write `reliable`"),
    (f"{PUBLISH} with qos depth 1, depth 2", "invalid-qos", "depth 2", None),
    (f"{PUBLISH} with qos deadline -1", "invalid-qos", "deadline -1", "write `deadline 0.5`"),
    (
        f"{PUBLISH} with qos latched\n"
        'create_message o of message_type String and input "b"\n'
        "n publish o to 'd' of message_type String with qos depth 3",
        "invalid-qos",
        "depth 3",
        "give it once, with the first",
    ),
    (
        "create_message k of message_type Float64 and input parameter 'names'\n"
        "n publish k to 'd' of message_type Float64",
        "computed-type-mismatch",
        "parameter 'names'",
        None,
    ),
    (
        "create_message k of message_type String and input parameter 'names' * 2\n"
        "n publish k to 'd' of message_type String",
        "computed-type-mismatch",
        "parameter 'names'",
        None,
    ),
    (
        "create_node 'k' as k managed using rospy",
        "not-in-ros-1",
        "managed",
        "use rclpy, rclcpp or component, or",
    ),
    (
        "n renames parameter 'sped' to 'pace'",
        "nothing-to-rename",
        "'sped'",
        "did you mean `speed`?",
    ),
    (
        "n renames parameter 'speed' to 'count'",
        "name-taken",
        "'count'",
        "one of the two has to get",
    ),
]
