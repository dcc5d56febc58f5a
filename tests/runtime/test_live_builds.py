"""Types of a program's own, built by the tools of either ROS, and sent from node to node."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from machine import find_ros, graph_environ

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.runtime.builds import BuiltPackage, overlay
from plastron_tui.targets.packages import (
    PackagedDefinition,
    PackageSpec,
    render_interfaces,
    render_package,
)

pytestmark = pytest.mark.live

PROGRAM = """\
create_message_type Axle with float64 angle
create_message_type WheelSpeed with float64 left, Axle axle
create_node 'odometer' as odometer
create_message still of message_type WheelSpeed and input left=4.5
odometer publish still to 'wheels' of message_type WheelSpeed at 10 hz
generate_node odometer
create_node 'reader' as reader
subscribe reader to 'wheels' of message_type WheelSpeed
generate_node reader
"""


@pytest.mark.long(1)
@pytest.mark.parametrize(("version", "library"), [(1, "rospy"), (2, "rclpy")])
def test_type_of_its_own_is_built_once_and_sent(version: int, library: str, tmp_path: Path) -> None:
    find_ros(version)
    file = tmp_path / "rover.plastron"
    environ = {**graph_environ(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache")}

    def run(program: str) -> tuple[str, str]:
        file.write_text(program)
        command = [sys.executable, "-m", "plastron_tui", "run", str(file), "--for", "6"]
        ended = subprocess.run(
            [*command, "-o", str(tmp_path / "out"), "--target", library],
            env=environ,
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
        assert ended.returncode == 0, ended.stderr
        return ended.stdout, ended.stderr

    heard, told = run(PROGRAM)
    assert "wheels: " in heard
    assert "4.5" in heard
    assert "building `rover" in told
    heard, told = run(PROGRAM)
    assert "wheels: " in heard
    assert "building" not in told
    # A definition that needs another one than before.
    changed = PROGRAM.replace("float64 angle", "float64 angle, std_msgs/ColorRGBA middle")
    heard, told = run(changed)
    assert "middle" in heard
    assert "building `rover" in told


@pytest.mark.long(1)
@pytest.mark.parametrize(
    ("version", "text", "is_mended"),
    [
        (1, b"float64 value\nNowhere x\n", False),
        (1, b"float64 value\nint32 9x\n", False),
        (1, b"float64 value\nint8 A=300\n", True),
        (2, b"float64 value\nint32 9x\n", False),
        (2, b"float64 value\nnowhere/Foo f\n", True),
    ],
)
def test_what_a_build_refuses_is_told_at_the_statement(
    version: int, text: bytes, is_mended: bool, tmp_path: Path
) -> None:
    """What is mended then builds; that takes long, and is tried once for each ROS."""
    environment = find_ros(version)
    definition = PackagedDefinition(InterfaceKind.MESSAGE, "Level", b"float64 value\n")
    spec = PackageSpec("rover", version, definitions=(definition,))
    rendered = render_package(spec) if version == 1 else render_interfaces(spec)
    assert rendered.files is not None
    files = {path: file.text for path, file in rendered.files.items()}
    environ = {**graph_environ(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache")}
    spans = {"msg/Level.msg": {0: Span(0, 4)}}
    package = BuiltPackage("rover", {**files, "msg/Level.msg": text}, spans=spans)
    _, [found] = overlay(environment, [package], lambda _: None, environ)
    assert found.span == Span(0, 4)
    assert found.message.startswith("`rover/msg/Level.msg")
    if is_mended:
        mended, problems = overlay(environment, [replace(package, files=files)], str, environ)
        assert not problems
        assert mended.overlays
