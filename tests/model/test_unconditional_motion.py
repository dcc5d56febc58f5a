"""A robot that is to stop by a sensor is not told to drive whatever the sensor says."""

from __future__ import annotations

import pytest

from plastron_tui.diagnostics import codes
from plastron_tui.session import Session

START = """\
create_node 'driver' as driver using rclpy
subscribe driver to 'scan' of message_type sensor_msgs/LaserScan
create_message ahead of message_type Twist and input linear.x=0.2
create_message slowly of message_type Twist and input linear.x=0.1
create_message halt of message_type Twist and input linear.x=0
create_message still of message_type Twist and input none
"""
_FOR_SCAN = "to 'cmd_vel' of message_type Twist for_each 'scan' when"
STOP = f"driver publish halt {_FOR_SCAN} any received.ranges < 0.5\n"
GO = f"driver publish ahead {_FOR_SCAN} all received.ranges > 0.5\n"
OTHER = "create_node 'other' as other using rclpy\n"


def sent(message: str, how: str, node: str = "driver", topic: str = "cmd_vel") -> str:
    return f"{node} publish {message} to '{topic}' of message_type Twist {how}\n"


def found(text: str) -> list[str]:
    session = Session((START + text).encode(), environ={})
    others = [each for each in session.diagnostics if each.code != codes.UNCONDITIONAL_MOTION]
    assert others == []
    return [each.message for each in session.diagnostics]


@pytest.mark.parametrize(
    "text",
    [
        sent("ahead", "at 10 hz") + STOP,
        STOP + sent("ahead", "at 10 hz"),
        STOP + sent("ahead", ""),
        GO + STOP + sent("slowly", "at 10 hz"),
        OTHER + sent("ahead", "at 10 hz", "other") + STOP,
        OTHER + sent("ahead", "at 10 hz", "other", "/cmd_vel") + STOP,
    ],
)
def test_a_robot_that_drives_on_is_told_of(text: str) -> None:
    (message,) = found(text)
    assert message.endswith(" to `cmd_vel` at 10 hz, whatever `scan` says: the robot does not stop")


@pytest.mark.parametrize(
    "text",
    [
        GO + STOP,
        sent("ahead", "at 10 hz"),
        sent("ahead", "at 10 hz", topic="other_cmd_vel") + STOP,
        # Told to stand still whatever the sensor says, it stands still at worst.
        GO + sent("halt", "at 10 hz"),
        GO + sent("still", "at 10 hz"),
        # Whose frame it is moves nothing.
        "create_message wait of message_type TwistStamped and input header.frame_id=\"base\"\n"
        "driver publish wait to 'cmd_vel' of message_type TwistStamped at 10 hz\n"
        "create_message run of message_type TwistStamped and input twist.linear.x=0.2\n"
        "driver publish run to 'cmd_vel' of message_type TwistStamped for_each 'scan' "
        "when all received.ranges > 0.5\n",
        # What is sent once is over by the first reading.
        sent("ahead", "once") + STOP,
        # Of what is sent for each reading the sensor is the clock, not the condition.
        sent("ahead", "for_each 'scan'"),
        # Two sentences on one topic may both be meant.
        "create_message text of message_type String and input \"fine\"\n"
        "create_message alarm of message_type String and input \"near\"\n"
        "driver publish text to 'state' of message_type String at 1 hz\n"
        "driver publish alarm to 'state' of message_type String for_each 'scan' "
        "when any received.ranges < 0.5\n",
        sent("ahead", "at 10 hz") + "driver stop_publishing to 'cmd_vel'\n" + STOP,
    ],
)  # fmt: skip
def test_what_is_right_is_left_alone(text: str) -> None:
    assert found(text) == []
