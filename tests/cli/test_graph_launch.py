"""`plastron graph` of launch files: the names that nodes get there."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from plastron_tui.cli.group import cli as main

PROGRAM = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
create_package 'demo' as demo
demo contains talker
generate_node talker using rclpy
generate_package demo
"""
LAUNCH = """\
<launch>
  <arg name="side" default="left"/>
  <node pkg="demo" exec="talker" namespace="$(var side)"><remap from="chatter" to="hello"/></node>
  <node pkg="demo" exec="talker" name="other" namespace="right"/>
  <node pkg="gone" exec="x"/>
</launch>
"""


def _run(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, arguments)
    return result.exit_code, result.stdout, result.stderr


def test_two_copies_of_a_node_have_the_names_that_they_get(tmp_path: Path) -> None:
    program = tmp_path / "a.plastron"
    program.write_text(PROGRAM)
    assert _run("generate", str(program))[0] == 0
    launch = tmp_path / "b.launch.xml"
    launch.write_text(LAUNCH)
    status, out, err = _run("graph", "-f", "json", str(launch), "side:=front")
    assert status == 0
    assert "`gone/x` is not found" in err
    shown = json.loads(out)
    assert [each["name"] for each in shown["nodes"]] == ["/front/talker", "/right/other", "x"]
    assert {(hub["name"], end["node"]) for hub in shown["topics"] for end in hub["publishers"]} >= {
        ("/front/hello", "/front/talker"),
        ("/right/chatter", "/right/other"),
    }


def test_packages_around_a_launch_file_are_known_without_a_repository(tmp_path: Path) -> None:
    program = tmp_path / "a.plastron"
    program.write_text(PROGRAM)
    assert _run("generate", str(program))[0] == 0
    launch = tmp_path / "output/demo/launch/b.launch.xml"
    launch.parent.mkdir()
    launch.write_text('<launch><node pkg="demo" exec="talker"/></launch>\n')
    status, out, err = _run("graph", "-f", "json", str(launch))
    assert (status, err) == (0, "")
    (hub,) = (each for each in json.loads(out)["topics"] if each["name"] == "/chatter")
    assert hub["publishers"][0]["node"] == "talker"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--remap", "a:=b"], "--remap is for programs"),
        (["--namespace", "/a"], "--namespace is for programs"),
        (["a.plastron"], "launch files are shown without programs, such as `a.plastron`"),
    ],
)
def test_what_is_not_for_launch_files_is_refused(
    tmp_path: Path, words: list[str], said: str
) -> None:
    launch = tmp_path / "b.launch.xml"
    launch.write_text(LAUNCH)
    status, out, err = _run("graph", str(launch), *words)
    assert (status, out) == (2, "")
    assert said in err


def test_an_argument_that_a_launch_file_does_not_have_is_told(tmp_path: Path) -> None:
    launch = tmp_path / "b.launch.xml"
    launch.write_text(LAUNCH)
    status, _, err = _run("graph", str(launch), "sid:=front")
    assert status == 0
    assert "the launch file has no argument `sid`" in err
    assert "did you mean `side`?" in err


def test_a_broken_launch_file_is_told(tmp_path: Path) -> None:
    for name, text in (("b.launch.xml", "<launch>"), ("b.launch.py", "def (")):
        launch = tmp_path / name
        launch.write_text(text)
        status, out, err = _run("graph", str(launch))
        assert (status, out) == (1, "")
        assert "error" in err
