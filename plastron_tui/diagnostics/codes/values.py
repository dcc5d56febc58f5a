"""What messages and requests hold."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

from .programs import DRIVER, RELAY, SPEED

_POINT = "create_message origin of message_type Point and input"
_TWIST = "create_message go of message_type Twist and input"
_POSE = "create_message pose of message_type geometry_msgs/PoseWithCovariance and input"

WRONG_NUMBER_OF_VALUES = Code(
    "wrong-number-of-values",
    "A message or a request gets more or fewer values than it has fields. The help line names "
    "the fields in their order. To set only some of them, name them: `x=1`.",
    bad=f"{_POINT} 1, 2\n",
    good=f"{_POINT} 1, 2, 3\n",
)

UNKNOWN_FIELD = Code(
    "unknown-field",
    "A value is for a field that the type does not have.",
    bad=f"{_TWIST} linear.w=0.5\n",
    good=f"{_TWIST} linear.x=0.5\n",
)

DUPLICATE_FIELD = Code(
    "duplicate-field",
    "A field gets two values.",
    bad=f"{_POINT} x=1, x=2\n",
    good=f"{_POINT} x=1, y=2\n",
)

VALUE_AFTER_NAMED = Code(
    "value-after-named",
    "A value without a name follows one with a name, so that nobody can tell which field it "
    "is for.",
    bad=f"{_POINT} x=1, 2, 3\n",
    good=f"{_POINT} 1, 2, z=3\n",
)

WRONG_KIND_OF_VALUE = Code(
    "wrong-kind-of-value",
    "A value is of another kind than its field: a text where a number belongs, a number for "
    "a boolean, a fraction for a whole number, one value where a list or a message belongs.",
    bad=f'{_POINT} 1, 2, "3"\n',
    good=f"{_POINT} 1, 2, 3\n",
)

VALUE_OUT_OF_RANGE = Code(
    "value-out-of-range",
    "A number is larger or smaller than its field can hold.",
    bad="create_message level of message_type std_msgs/UInt8 and input 256\n",
    good="create_message level of message_type std_msgs/UInt8 and input 255\n",
)

WRONG_ARRAY_LENGTH = Code(
    "wrong-array-length",
    "A list has more or fewer elements than its array takes.",
    bad=f"{_POSE} covariance=[1.0, 2.0]\n",
    good=f"{_POSE} covariance=[{', '.join(['0'] * 36)}]\n",
)

INVALID_TEXT = Code(
    "invalid-text",
    "A text holds what its field cannot: more characters than it takes, half of a surrogate "
    "pair, or, in ROS 2, a NUL character.",
    bad='create_message name of message_type String and input "\\ud83d"\n',
    good='create_message name of message_type String and input "\\ud83d\\ude00"\n',
)

INVALID_RATE = Code(
    "invalid-rate",
    "A message is to be sent at a rate that no clock of ROS can keep: less than 1e-9 hertz, or "
    "more than a million.",
    bad="create_node 'talker' as talker\n"
    "create_message greeting of message_type String and input none\n"
    "talker publish greeting to 'chatter' of message_type String at 0 hz\n",
    good="create_node 'talker' as talker\n"
    "create_message greeting of message_type String and input none\n"
    "talker publish greeting to 'chatter' of message_type String at 0.5 hz\n",
)

UNKNOWN_PARAMETER = Code(
    "unknown-parameter",
    "A value or a rate is that of a parameter that the node does not have, or whose file does not "
    "say its default.",
    bad=f"{DRIVER}create_message go of message_type Float64 and input parameter 'speed'\n"
    "driver publish go to 'speed' of message_type Float64\n",
    good=f"{SPEED}create_message go of message_type Float64 and input parameter 'speed'\n"
    "driver publish go to 'speed' of message_type Float64\n",
)

UNKNOWN_PARAMETER_TYPE = Code(
    "unknown-parameter-type",
    "Parameters are of type `bool`, `int`, `float` or `string`, or lists of these: `int_list`.",
    bad=f"{DRIVER}driver has_parameter 'speed' of parameter_type double with default 0.5\n",
    good=SPEED,
)

PARAMETER_TYPE_MISMATCH = Code(
    "parameter-type-mismatch",
    "The default of a parameter is of another type than the parameter, or a rate is that of a "
    "parameter that is no number.",
    bad=f"{DRIVER}driver has_parameter 'speed' of parameter_type float with default \"fast\"\n",
    good=SPEED,
)

INVALID_RANGE = Code(
    "invalid-range",
    "The range of a parameter is none, or its default is not in it; only a single number has one.",
    bad=f"{DRIVER}driver has_parameter 'speed' of parameter_type float with default 3 "
    "between 0 and 2\n",
    good=f"{DRIVER}driver has_parameter 'speed' of parameter_type float with default 1 "
    "between 0 and 2\n",
)

NOTHING_RECEIVED = Code(
    "nothing-received",
    "A message has values of what is received, and is sent at another time: such a message is sent "
    "`for_each` message of a topic.",
    bad=f"{RELAY}relay publish copy to 'out' of message_type String at 1 hz\n",
    good=f"{RELAY}relay publish copy to 'out' of message_type String for_each 'in'\n",
)

COMPUTED_TYPE_MISMATCH = Code(
    "computed-type-mismatch",
    "A parameter, or a field of what is received, is of another type than the field that it is "
    "for, or is compared with a value of another type.",
    bad="create_node 'relay' as relay\n"
    "subscribe relay to 'in' of message_type Int32\n"
    "create_message copy of message_type String and input data=received.data\n"
    "relay publish copy to 'out' of message_type String for_each 'in'\n",
    good=f"{RELAY}relay publish copy to 'out' of message_type String for_each 'in'\n",
)
