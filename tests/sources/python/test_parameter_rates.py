"""Rates that are parameters, in loaded nodes."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES, changed
from test_reacting import made

GO = "create_message go of message_type Twist and input none\n"
AT = "driver publish go to 'out' of message_type Twist at parameter 'gain' hz"
UNDONE = {
    f"{GO}{AT}": "driver stop_publishing to 'out'",
    "driver repeats blink at parameter 'gain' hz": "driver stop_repeating blink",
}


@pytest.mark.parametrize("file", FILES)
@pytest.mark.parametrize("program", UNDONE)
def test_a_rate_is_read_once_and_taken_out_again(tmp_path: Path, program: str, file: str) -> None:
    after, told = made(tmp_path, FILES[file], program)
    assert [each.partition(" is what ")[2] for each in told] == ["`gain` is as the node starts"]
    assert made(tmp_path, after, UNDONE[program]) == (FILES[file], [])


FIRST = """\
        self.declare_parameter('gain', 1.0)
        self.declare_parameter('idle', 2)
        self.gain = self.get_parameter('gain').value
        self.cmd_pub = self.create_publisher(Twist, 'cmd_vel', 10)
"""


def test_a_rate_is_read_behind_the_line_that_declares_it(tmp_path: Path) -> None:
    lines = FIRST.splitlines(keepends=True)
    text = FILES["rclpy class"].replace(FIRST, "".join([lines[3], *lines[:3]]))
    after, _ = made(tmp_path, text, f"{GO}{AT}")
    assert after.index("declare_parameter('gain'") < after.index("1.0 / self.get_parameter('gain')")


def test_a_rate_that_may_not_be_declared_yet_is_refused(tmp_path: Path) -> None:
    *declaring, creating = FIRST.splitlines(keepends=True)
    text = FILES["rclpy class"].replace(FIRST, f"        self.set_up()\n{creating}")
    text = text.replace(
        "    def tick", f"    def set_up(self):\n{''.join(declaring)}\n    def tick"
    )
    codes, _ = changed(tmp_path, text, f"{GO}{AT}")
    assert "edit-refused" in codes
