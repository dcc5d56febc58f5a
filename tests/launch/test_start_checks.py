"""What launch files of a program name, and its nodes and packages do not have."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Severity
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

HEAD = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
talker has_parameter 'speed' of parameter_type float with default 0.5
create_launch 'bringup' as bringup
create_launch 'sensors' as sensors
"""
PACKAGE = """\
create_package 'rover' as rover described_as "x" maintained_by "A <a@b.example>" \
licensed_under "MIT"
rover contains talker
rover contains bringup
rover contains sensors
generate_package rover
"""
NODE = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Ear(Node):
    def __init__(self):
        super().__init__("ear")
        self.declare_parameter("gain", 1.0)
        self.create_subscription(String, "chatter", print, 10)


def main():
    rclpy.init()
    rclpy.spin(Ear())
"""
WARNING, ERROR = Severity.WARNING, Severity.ERROR


def told(folder: Path, text: str, target: str = "rclpy") -> list[tuple[str, str, str, Severity]]:
    """Return each code with the word that it is about, its help, and how bad it is."""
    source = text.encode()
    session = Session(source, folder / "p.plastron", Options(target), environ={})
    found = []
    for each in session.diagnostics:
        assert each.span is not None
        word = source[each.span.start : each.span.end].decode()
        found.append((str(each.code), word, each.help or "", each.severity))
    return found


@pytest.mark.parametrize("target", ["rclpy", "rospy"])
@pytest.mark.parametrize(
    "statement, code, remedy, severity",
    [
        ("starts talker remapping ['chater'] to 'x'", "unmet-remap", "`chatter`", WARNING),
        ("starts talker in 'a' remapping ['/chatter'] to 'x'", "unmet-remap", "", WARNING),
        ("starts talker setting ['sped'] = 1.0", "undeclared-parameter", "`speed`", WARNING),
        ("starts ['rover/takler']", "not-in-package", "`rover/talker`", ERROR),
        ("starts ['rover/zzzz']", "not-in-package", "contains NODE", ERROR),
        ("includes ['rover/sensor.launch']", "not-in-package", "rover/sensors", ERROR),
        ("includes ['rover/launch/x.launch']", "not-in-package", "", ERROR),
    ],
)
def test_what_is_not_there_is_told(
    tmp_path: Path,
    target: str,
    statement: str,
    code: str,
    remedy: str,
    severity: Severity,
) -> None:
    word = statement.partition("[")[2].partition("]")[0]
    statement = statement.replace("[", "").replace("]", "")
    (found,) = told(tmp_path, f"{HEAD}bringup {statement}\n{PACKAGE}", target)
    assert (found[0], found[1], found[3]) == (code, word, severity)
    assert remedy in found[2]


@pytest.mark.parametrize("target, ending", [("rclpy", ".launch.xml"), ("rospy", ".launch")])
@pytest.mark.parametrize(
    "statement",
    [
        "starts talker remapping 'chatter' to 'x' setting 'speed' = 1.0",
        "starts talker in 'a' remapping '/a/chatter' to 'x'",
        "starts talker in 'a' remapping 'chatter' to '$(var name)'",
        "starts talker remapping '/tf' to 'tf', '/rosout' to 'logs'",
        "starts 'rover/talker'",
        "starts 'other/anything' remapping 'a' to 'b' setting 'c' = 1",
        "includes 'rover/sensorsENDING'",
        "includes 'rover/launch/sensorsENDING'",
        "includes 'other/anything.launch'",
    ],
)
def test_what_is_there_or_not_known_is_not_told(
    tmp_path: Path, target: str, ending: str, statement: str
) -> None:
    text = f"{HEAD}bringup has_argument 'name'\nbringup {statement}\n{PACKAGE}"
    assert told(tmp_path, text.replace("ENDING", ending), target) == []


@pytest.mark.parametrize(
    "old, new, codes",
    [
        ("", "", ["unmet-remap", "undeclared-parameter"]),
        ('"chatter", print', "topic, print", ["undeclared-parameter"]),
        ('"gain", 1.0', "name, 1.0", ["unmet-remap"]),
        ('"ear")', '"ear", allow_undeclared_parameters=True)', ["unmet-remap"]),
    ],
)
def test_a_loaded_node_counts_as_far_as_it_is_read_for_sure(
    tmp_path: Path, old: str, new: str, codes: list[str]
) -> None:
    (tmp_path / "ear.py").write_text(NODE.replace(old, new) if old else NODE)
    text = (
        "load 'ear.py' as ear\ngenerate_node ear\ncreate_launch 'bringup' as bringup\n"
        "bringup starts ear remapping 'chater' to 'x' setting 'gian' = 2.0\n"
    )
    assert [each[0] for each in told(tmp_path, text)] == codes


def test_names_that_were_written_by_hand_count(tmp_path: Path) -> None:
    text = f"{HEAD}bringup starts talker remapping 'hands' to 'x'\n{PACKAGE}"
    path = tmp_path / "p.plastron"
    assert [each[0] for each in told(tmp_path, text)] == ["unmet-remap"]
    session = Session(text.encode(), path, Options("rclpy", tmp_path), environ={})
    plan, _ = session.plan()
    node = next(each for each in plan.files if each.name.endswith("talker.py"))
    write(plan)
    added = node.text.replace(
        b"super().__init__('talker')",
        b"super().__init__('talker')\n        self.create_subscription(String, 'hands', print, 10)",
    )
    assert added != node.text
    node.path.write_bytes(added)
    again = Session(text.encode(), path, Options("rclpy", tmp_path), environ={})
    assert again.diagnostics == ()


@pytest.mark.parametrize(
    "file, codes",
    [
        ("nope.launch.xml", [("not-in-package", WARNING)]),
        ("there.launch.xml", []),
        ("config/odd.launch.xml", []),
    ],
)
def test_a_loaded_package_has_the_launch_files_of_its_folder(
    tmp_path: Path, file: str, codes: list[tuple[str, Severity]]
) -> None:
    folder = tmp_path / "rover"
    for name in ("launch/there.launch.xml", "config/odd.launch.xml"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("<launch/>\n")
    (folder / "package.xml").write_text(
        '<package format="3"><name>rover</name><version>0.0.1</version><description>x'
        '</description><maintainer email="a@b.example">A</maintainer><license>MIT</license>'
        "<export><build_type>ament_python</build_type></export></package>\n"
    )
    (folder / "setup.py").write_text("from setuptools import setup\n\nsetup(name='rover')\n")
    text = (
        "load_package 'rover' as rover\ncreate_launch 'bringup' as bringup\n"
        f"bringup starts 'rover/anything'\nbringup includes 'rover/{file}'\n"
        "generate_launch bringup\n"
    )
    assert [(each[0], each[3]) for each in told(tmp_path, text)] == codes
