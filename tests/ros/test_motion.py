from __future__ import annotations

import pytest

from plastron_tui.ros.motion import is_command, is_distance, is_velocity


@pytest.mark.parametrize(
    ("type_", "is_like"),
    [("Twist", (True, True, False)),
     ("geometry_msgs/TwistStamped", (True, True, False)),
     ("geometry_msgs/msg/Twist", (True, True, False)),
     ("geometry_msgs/Wrench", (False, True, False)),
     ("Range", (False, False, True)),
     ("mine/Twist", (False, False, False)),
     ("geometry_msgs/Pose", (False, False, False)),
     ("", (False, False, False))],
)  # fmt: skip
def test_which_types_move_a_robot(type_: str, is_like: tuple[bool, bool, bool]) -> None:
    assert (is_velocity(type_), is_command(type_), is_distance(type_)) == is_like
