"""From the statements of a package to what its files follow from."""

from __future__ import annotations

from pathlib import Path

import pytest
from program_packages import spec_of

from plastron_tui.targets.packages import render_package

PROGRAM = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
create_package 'demo' as demo described_as "Says hello" maintained_by "Ada <ada@example.com>" {}
demo contains talker as 'speaker'
generate_package demo
"""


@pytest.mark.parametrize(
    ("library", "path"),
    [("rospy", "scripts/speaker.py"), ("rclpy", "demo/speaker.py")],
)
def test_package_of_a_program_is_rendered(library: str, path: str, tmp_path: Path) -> None:
    spec = spec_of(PROGRAM.format('licensed_under "mit"'), library, tmp_path)
    found = render_package(spec)
    assert found.diagnostics == ()
    assert found.files is not None
    assert found.files[path].is_executable
    assert b"Ada" in found.files["LICENSE"].text
    assert spec.license == "MIT"
    if library == "rclpy":
        assert b"'speaker = demo.speaker:main'" in found.files["setup.py"].text
