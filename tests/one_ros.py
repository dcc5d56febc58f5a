"""What may say which ROS a program is for, and which one it is then: for everybody the same."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from plastron_tui.ros import installations
from plastron_tui.ros.installations import Installation, Origin

DEBIAN = Installation(Origin.DEBIAN, 1, "noetic")
EXTRA = Installation(Origin.EXTRA, 2, "kilted")
OLD_EXTRA = Installation(Origin.EXTRA, 2, "jazzy")
UNSOURCED = Installation(Origin.UNSOURCED, 2, "humble")
UNSOURCED_ROS1 = Installation(Origin.UNSOURCED, 1, "melodic")


@dataclass(frozen=True)
class Case:
    """A situation; `ros` is the client library and the distribution that follow from it."""

    ros: tuple[str, str]
    target: str | None = None
    project: str = ""
    environ: Mapping[str, str] = field(default_factory=dict)
    installed: Sequence[Installation] = ()

    @property
    def ros_version(self) -> int:
        return 1 if self.ros[0] == "rospy" else 2

    def set_up(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Make it so in a folder, for this process and the copies of it."""
        (folder / "plastron.yaml").write_text(self.project)
        monkeypatch.setattr(installations, "installed", lambda: tuple(self.installed))
        for name, value in self.environ.items():
            monkeypatch.setenv(name, value)


ROS1, ROS2 = ("rospy", "noetic"), ("rclpy", "kilted")
HUMBLE = {"ROS_VERSION": "2", "ROS_DISTRO": "humble"}
NOETIC = {"ROS_VERSION": "1", "ROS_DISTRO": "noetic"}

CASES = {
    "nothing tells": Case(ROS2),
    "Debian's": Case(ROS1, installed=[DEBIAN]),
    "the extra": Case(ROS2, installed=[EXTRA, DEBIAN]),
    "an older extra": Case(("rclpy", "jazzy"), installed=[OLD_EXTRA, UNSOURCED]),
    "not sourced": Case(("rclpy", "humble"), installed=[UNSOURCED]),
    "ROS 1, not sourced": Case(ROS1, installed=[UNSOURCED_ROS1]),
    "sourced": Case(("rclpy", "humble"), environ=HUMBLE, installed=[EXTRA, DEBIAN]),
    "sourced ROS 1": Case(ROS1, environ=NOETIC, installed=[EXTRA]),
    "sourced rolling": Case(
        ("rclpy", "lyrical"), environ={"ROS_DISTRO": "rolling"}, installed=[UNSOURCED]
    ),
    "sourced melodic": Case(ROS1, environ={"ROS_DISTRO": "melodic"}),
    "a workspace": Case(
        ("rclpy", "jazzy"), environ={"AMENT_PREFIX_PATH": "/ws"}, installed=[DEBIAN, OLD_EXTRA]
    ),
    "a workspace of ROS 1": Case(ROS1, environ={"ROS_PACKAGE_PATH": "/ws"}, installed=[EXTRA]),
    "no version": Case(ROS2, environ={"ROS_VERSION": "nonsense"}),
    "the project's library": Case(ROS1, project="target: rospy\n", environ=HUMBLE),
    "the project's distribution": Case(
        ("rclpy", "humble"), project="distribution: humble\n", environ=NOETIC, installed=[EXTRA]
    ),
    "the project's library, sourced": Case(
        ("rclpy", "humble"), project="target: rclpy\n", environ=HUMBLE, installed=[EXTRA]
    ),
    "an option": Case(
        ("rclpy", "jazzy"),
        target="rclpy",
        project="target: rospy\ndistribution: noetic\n",
        environ=NOETIC,
        installed=[OLD_EXTRA],
    ),
    "an option and the project's distribution": Case(
        ("rclpy", "humble"), target="rclpy", project="distribution: humble\n", installed=[DEBIAN]
    ),
}

GOOD = """\
create_node 'arm' as arm
subscribe arm to 'move' of message_type String
generate_node arm
"""

UNKNOWN_TYPE = GOOD.replace("String", "Zzz")
"""A program whose mistake names the distribution."""


def unknown_type(case: Case) -> str:
    """Return what is wrong with it."""
    return f"no message type `Zzz` is known in ROS {case.ros_version} {case.ros[1]}"
