"""Interface types of the program's own."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

_SPEED = "create_message_type WheelSpeed with float64 left, float64 right\n"
_USED = (
    f"{_SPEED}create_message fast of message_type WheelSpeed and input left=1, right=1\n"
    "create_node 'driver' as driver\n"
    "driver publish fast to 'speed' of message_type WheelSpeed\n"
)

BAD_TYPE_NAME = Code(
    "bad-type-name",
    "A type has a name that ROS does not take for one: it has letters and digits, in ROS 2 a "
    "capital letter first, and is no type that definitions know.",
    bad="create_message_type uint8 with float64 left\n",
    good="create_message_type WheelSpeed with float64 left\n",
)

TYPE_EXISTS = Code(
    "type-exists",
    "A type is made that there is already, in the program or in a package of ROS.",
    bad=f"{_SPEED}create_message_type WheelSpeed with float64 both\n",
    good=_SPEED,
)

TYPE_NOT_WRITTEN = Code(
    "type-not-written",
    "A type belongs to a package that exists, and its definition cannot be put there: nothing "
    "writes the package, or it builds no types. A second package of its name would hide it.",
)

TYPE_HIDDEN = Code(
    "type-hidden",
    "A type of the program has the bare name of one of ROS, which that name means no longer from "
    "here on. Choose another name, or write the other one with its package: `std_msgs/String`.",
    severity=Severity.WARNING,
    bad="create_message_type String with string data\n",
    good="create_message_type Label with string data\n",
)

BAD_FIELD = Code(
    "bad-field",
    "A field or a constant is not as definitions have it: its name, its type, its bound or its "
    "value.",
    bad="create_message_type WheelSpeed with float64 class\n",
    good="create_message_type WheelSpeed with float64 kind\n",
)

UNKNOWN_OWN_TYPE = Code(
    "unknown-own-type",
    "The program makes and loads no type of this name: it is misspelt, or made further down. Types "
    "of other packages are not changed.",
    bad=f'{_SPEED}WheelSped has_field "float64 slip"\n',
    good=f'{_SPEED}WheelSpeed has_field "float64 slip"\n',
)

FIELD_EXISTS = Code(
    "field-exists",
    "A type has a field already as a statement has it.",
    bad=f'{_SPEED}WheelSpeed has_field "float64 left"\n',
    good=f'{_SPEED}WheelSpeed has_field "float64 middle"\n',
)

NO_SUCH_FIELD = Code(
    "no-such-field",
    "A type does not have the field that a statement takes away, or not that part.",
    bad=f"{_SPEED}WheelSpeed no_longer_has_field 'lft'\n",
    good=f"{_SPEED}WheelSpeed no_longer_has_field 'left'\n",
)

CIRCULAR_TYPE = Code(
    "circular-type",
    "A type contains itself, or types contain each other: such a message has no end.",
    bad="create_message_type Part with int32 size\n"
    "create_message_type Whole with Part part\n"
    'Part has_field "Whole whole"\n',
    good="create_message_type Part with int32 size\ncreate_message_type Whole with Part part\n",
)

TYPE_IN_USE = Code(
    "type-in-use",
    "A type is taken away, or changed, that something of the program uses as it was.",
    bad=f"{_USED}WheelSpeed no_longer_has_field 'left'\n",
    good=f'{_USED}WheelSpeed has_field "float64 slip"\n',
)
