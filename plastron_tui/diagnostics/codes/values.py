"""What messages and requests hold."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

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
