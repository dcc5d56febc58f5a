"""Statements whose values and conditions are wrong, and what is said of each."""

from __future__ import annotations

from wrong_statements import NEAR, ON_BOOL, ON_BYTES, PARAMETER

WRONG_VALUES: list[tuple[str, str, str, str | None]] = [
    (
        "create_message k of message_type Twist and input linear.x=received.ranges\n"
        "n publish k to 'd' of message_type Twist for_each 'scan'",
        "computed-type-mismatch",
        "received.ranges",
        "write `received.ranges[0]` for its first element",
    ),
    (
        "create_message k of message_type Twist and input linear.x=2, linear.y=received.rangs[1]\n"
        "n publish k to 'd' of message_type Twist for_each 'scan'",
        "unknown-field",
        "received.rangs[1]",
        "did you mean `ranges`?",
    ),
    (
        "create_message k of message_type Twist and input linear=(x=parameter 'sped' * 2)\n"
        "n publish k to 'd' of message_type Twist",
        "unknown-parameter",
        "parameter 'sped'",
        "did you mean `speed`?",
    ),
    (
        f"{ON_BYTES} received.data = True",
        "computed-type-mismatch",
        "received.data = True",
        "write `= 1`",
    ),
    (f"{ON_BOOL} received.data = 0", "computed-type-mismatch", "received.data = 0", "`= False`"),
    (
        f"{NEAR} for_each 'scan' when received.header = 1",
        "computed-type-mismatch",
        "received.header = 1",
        None,
    ),
    (f"{ON_BOOL} received.data = 2", "computed-type-mismatch", "received.data = 2", None),
    (f"{ON_BYTES} received.data < 300", "value-out-of-range", "received.data < 300", None),
    (f"{ON_BYTES} received.data < 0", "value-out-of-range", "received.data < 0", None),
    (f"{ON_BYTES} received.data > -1", "value-out-of-range", "received.data > -1", None),
    (f"{ON_BYTES} received.data > 255", "value-out-of-range", "received.data > 255", None),
    (f"{ON_BYTES} received.data = 256", "value-out-of-range", "received.data = 256", None),
    (f"{ON_BYTES} received.data = 0.5", "value-out-of-range", "received.data = 0.5", None),
    (
        f"{NEAR} for_each 'scan' when any received.ranges < 1e400",
        "value-out-of-range",
        "any received.ranges < 1e400",
        None,
    ),
    (
        "create_message k of message_type Float64 "
        "and input parameter 'count' * 18446744073709551616\n"
        "n publish k to 'd' of message_type Float64",
        "value-out-of-range",
        "parameter 'count' * 18446744073709551616",
        None,
    ),
    (
        f'{PARAMETER} string with default "\\ud800"',
        "parameter-type-mismatch",
        '"\\ud800"',
        None,
    ),
]
