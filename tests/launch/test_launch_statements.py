"""Programs that make launch files, and the files that they come to."""

from __future__ import annotations

import pytest

from plastron_tui.model.workspace import Node
from plastron_tui.session import Session
from plastron_tui.targets.launch.program import Executable, request_of
from plastron_tui.targets.launch.xml import write_xml

HEAD = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
generate_node talker using rclpy
create_launch 'bringup' as bringup
"""
PACKAGE = """\
create_package 'demo' as demo described_as "x" maintained_by "A <a@b.example>" licensed_under "MIT"
demo contains talker
"""
FULL = (
    HEAD
    + PACKAGE
    + """\
bringup has_argument 'robot' with default "rover"
bringup starts talker in 'front' remapping 'chatter' to 'hello' setting 'speed' = 0.5, 'id' = "1"
bringup starts 'demo/listener' as 'ear' with parameters 'config/ear.yaml'
bringup starts 'demo/Camera' as 'camera' inside 'eyes'
bringup includes 'rover/sensors.launch.xml'
generate_launch bringup
"""
)
WRITTEN = """\
<launch>
  <arg name="robot" default="rover"/>

  <include file="$(find-pkg-share rover)/launch/sensors.launch.xml"/>

  <node pkg="own" exec="talker" name="talker" namespace="front" output="screen">
    <param name="speed" value="0.5"/>
    <param name="id" value="1" type="str"/>
    <remap from="chatter" to="hello"/>
  </node>

  <node pkg="demo" exec="listener" name="ear" output="screen">
    <param from="$(find-pkg-share demo)/config/ear.yaml"/>
  </node>

  <node_container pkg="rclcpp_components" exec="component_container" name="eyes">
    <composable_node pkg="demo" plugin="Camera" name="camera"/>
  </node_container>
</launch>
"""


def _own(node: Node) -> Executable:
    return Executable("own", node.name)


def test_a_program_makes_a_launch_file() -> None:
    session = Session(FULL.encode())
    assert session.diagnostics == ()
    (made,) = session.workspace.written_launches
    assert write_xml(request_of(made.launch, 2, _own).added, 2) == WRITTEN


@pytest.mark.parametrize(
    "statements, code",
    [
        ("bringup starts talkr\n", "unknown-node"),
        ("bringup starts 'listener'\n", "bad-launch-name"),
        ("bringup starts talker\nbringup starts talker\n", "already-started"),
        ("bringup no_longer_starts 'talker'\n", "not-started"),
        ("bringup has_argument 'a b'\n", "bad-launch-name"),
        ("bringup includes 'sensors.launch'\n", "bad-launch-name"),
        ("bringup includes 'rover/../x.launch'\n", "bad-launch-name"),
        ("brngup starts talker\n", "unknown-launch"),
        ("create_launch 'bringup' as other\n", "launch-exists"),
        ("bringup starts talker remapping 'a b' to 'c'\n", "invalid-name"),
    ],
)
def test_mistakes_are_told(statements: str, code: str) -> None:
    assert [each.code for each in Session((HEAD + statements).encode()).diagnostics] == [code]


@pytest.mark.parametrize(
    "statements",
    [
        "bringup starts talker\nbringup no_longer_starts 'talker'\n",
        "bringup has_argument 'a'\nbringup no_longer_has_argument 'a'\n",
        "bringup includes 'rover/a.launch'\nbringup no_longer_includes 'rover/a.launch'\n",
    ],
)
def test_what_is_taken_back_leaves_nothing(statements: str) -> None:
    session = Session((HEAD + statements).encode())
    assert session.diagnostics == ()
    assert request_of(session.workspace.launches["bringup"], 2, _own).added.items == ()


@pytest.mark.parametrize(
    "statements, wrong",
    [
        ("bringup starts talker as 'x'\ngenerate_launch bringup\n", "talker"),
        (f"{PACKAGE}demo no_longer_contains talker\nbringup starts talker\n"
         "demo contains bringup\ngenerate_package demo\n", "talker"),
        ("bringup starts talker\n", None),
        (f"bringup starts talker\ngenerate_launch bringup\n{PACKAGE}", None),
    ],
)  # fmt: skip
def test_what_is_in_no_package_is_told_where_it_is_started(
    statements: str, wrong: str | None
) -> None:
    text = HEAD + statements
    found = [each for each in Session(text.encode()).diagnostics if each.severity.value == "error"]
    assert [each.code for each in found] == ([] if wrong is None else ["in-no-package"])
    for each in found:
        assert each.span is not None
        assert text[each.span.start : each.span.end] == wrong
        assert text[: each.span.start].endswith("bringup starts ")


@pytest.mark.parametrize(
    "statements, late",
    [
        ("generate_launch bringup\nbringup starts 'demo/b'\n", "bringup starts 'demo/b'"),
        ("generate_launch bringup\nbringup has_argument 'a'\ngenerate_launch bringup\n", None),
        (f"{PACKAGE}generate_package demo\ndemo contains bringup\n", "demo contains bringup"),
        (f"{PACKAGE}demo contains bringup\ngenerate_launch bringup\nbringup starts 'demo/b'\n"
         "generate_package demo\n", None),
    ],
)  # fmt: skip
def test_what_comes_after_writing_is_told(statements: str, late: str | None) -> None:
    text = HEAD + statements
    found = [
        each
        for each in Session(text.encode()).diagnostics
        if each.code == "changed-after-generating"
    ]
    assert len(found) == (late is not None)
    for each in found:
        assert each.span is not None
        assert text[each.span.start : each.span.end] == late
