"""What the arguments of robots' files are given: by programs, by commands, and where they start."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner
from loaded_packages import run

from plastron_tui.cli.group import cli as main
from plastron_tui.diagnostics import Diagnostic
from plastron_tui.ros.launch_text import Kind, Substitution, Text
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.runtime import xacro
from plastron_tui.runtime.xacro import Expanded
from plastron_tui.session import Session
from plastron_tui.targets.robots.launch import DescribedRobot, with_description
from plastron_tui.trust import TrustStore

ARM = """\
<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="width" default="0.1"/>
  <link name="base"><visual><geometry><box size="$(arg width) 1 1"/></geometry></visual></link>
</robot>
"""
EXPANDED = b"<robot name='ur5'><link name='base'/></robot>"
PACKAGE = (
    'create_package \'arm_demo\' as demo maintained_by "Ada <a@b.cc>" licensed_under "MIT"\n'
    "demo contains arm\ngenerate_package demo\n"
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "project"
    folder.mkdir()
    (folder / "arm.urdf.xacro").write_text(ARM)
    (folder / "plain.urdf").write_bytes(EXPANDED)
    TrustStore().add(folder)
    return folder


def loading(folder: Path, said: str, file: str = "arm.urdf.xacro") -> tuple[Diagnostic, ...]:
    text = f"load_robot '{file}' as arm{said}\n".encode()
    return Session(text, folder / "p.plastron", environ={}).diagnostics


def expanding(monkeypatch: pytest.MonkeyPatch) -> list[Arguments]:
    """Let nothing be expanded; return what would be given from then on."""
    given: list[Arguments] = []

    def expand(_: Path, __: bytes, ___: object, ____: Path, arguments: Arguments) -> Expanded:
        given.append(arguments)
        unused = tuple(name for name, _ in arguments if name not in ("name", "width"))
        if "name" not in dict(arguments):
            reason = "the argument `name` has no value"
            return Expanded(None, reason, (), "name", ("name", "width"), unused)
        return Expanded(EXPANDED, asked=("width",), unused=unused)

    monkeypatch.setattr(xacro, "expand", expand)
    return given


def test_a_program_gives_arguments(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    given = expanding(monkeypatch)
    said = " setting 'name' = \"ur 5\", 'width' = 0.5, 'flag' = True, 'count' = -2"
    text = f"load_robot 'arm.urdf.xacro' as arm{said}\n".encode()
    session = Session(text, folder / "p.plastron", environ={})
    unused = [each.message for each in session.diagnostics]
    assert unused == [f"`arm.urdf.xacro` asks for no argument `{x}`" for x in ("flag", "count")]
    assert given == [
        (("name", "ur 5"), ("width", "0.5"), ("flag", "true"), ("count", "-2")),
    ]
    source = session.workspace.robots["arm"].source
    assert source is not None
    assert source.arguments == given[0]
    assert source.expanded is not None


def test_what_is_expanded_depends_on_the_arguments(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    given = expanding(monkeypatch)
    text = b"load_robot 'arm.urdf.xacro' as arm setting 'name' = \"a\"\n"
    session = Session(text, folder / "p.plastron", environ={})
    assert session.diagnostics == ()
    session.edit(len(text) - 3, len(text) - 2, b"b")
    assert session.diagnostics == ()
    session.edit(len(text) - 3, len(text) - 2, b"a")
    assert session.diagnostics == ()
    assert given == [(("name", "a"),), (("name", "b"),)]


@pytest.mark.parametrize(
    ("said", "where", "help_"),
    [
        ("", "'arm.urdf.xacro'", "say it behind the robot's name: `setting 'name' = \"…\"`"),
        (" setting 'nme' = 1", "'nme'", "did you mean `name`?"),
        (" setting 'name' = 1, 'x' = 1", "'x'", "it asks for `width`"),
        (" setting 'a b' = 1", "'a b'", "a name has letters"),
        (" setting 'name' = 1, 'name' = 2", "'name'", "say it once"),
        (" setting 'name' = [1, 2]", "[1, 2]", "a number, a boolean, or a text on one line"),
        (" setting 'name' = \"a\\nb\"", '"a\\nb"', "a text on one line"),
    ],
)
def test_a_mistake_is_told_on_its_word(
    folder: Path, monkeypatch: pytest.MonkeyPatch, said: str, where: str, help_: str
) -> None:
    expanding(monkeypatch)
    text = f"load_robot 'arm.urdf.xacro' as arm{said}\n"
    told = [each for each in loading(folder, said) if help_ in (each.help or "")]
    assert len(told) == 1
    assert told[0].span is not None
    assert text[told[0].span.start : told[0].span.end] == where


def test_what_is_not_expanded_to_its_end_may_ask_for_more(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expanding(monkeypatch)
    [told] = loading(folder, " setting 'other' = 1")
    assert told.code == "not-expanded"


def test_a_file_without_macros_takes_none(folder: Path) -> None:
    [told] = loading(folder, " setting 'name' = 1", "plain.urdf")
    assert told.code == "bad-robot-argument"
    assert told.help == "only the macros of a xacro file have arguments"


@pytest.mark.parametrize("command", ["inspect", "graph"])
def test_a_command_gives_arguments(
    folder: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    given = expanding(monkeypatch)
    file = str(folder / "arm.urdf.xacro")
    result = CliRunner().invoke(main, [command, file])
    assert "say it behind the file: `name:=…`" in result.stderr
    result = CliRunner().invoke(main, [command, file, "name:=package://a", "widht:="])
    assert given[1:] == [(("name", "package://a"), ("widht", ""))]
    assert "did you mean `width`?" in result.stderr
    assert "ur5" in result.stdout
    result = CliRunner().invoke(main, [command, file, "1:=a"])
    assert (result.exit_code, "'1' is no name of an argument" in result.stderr) == (2, True)


@pytest.mark.parametrize(
    ("library", "start"),
    [
        ("rospy", "xacro $(find arm_demo)/urdf/arm.urdf.xacro name:='ur 5' width:=0.5"),
        (
            "rclpy",
            "xacro $(find-pkg-share arm_demo)/urdf/arm.urdf.xacro name:=\\'ur 5\\' width:=0.5",
        ),
    ],
)
def test_what_is_started_gets_them(folder: Path, library: str, start: str) -> None:
    said = "setting 'name' = \"ur 5\", 'width' = 0.5"
    run(f"load_robot 'arm.urdf.xacro' as arm {said}\n{PACKAGE}", folder, library)
    [launch] = (folder / "output/arm_demo/launch").iterdir()
    assert start in launch.read_text()


@pytest.mark.parametrize("value", ["", "a b", "it's", 'say "a"', "$HOME", "a;b", "(1)", "\\"])
def test_a_value_is_one_word_of_the_command(value: str) -> None:
    from plastron_tui.ros.launch import LaunchFile, SetParameter

    robot = DescribedRobot("demo", "a.xacro", is_macros=True, arguments=(("name", value),))
    [item] = with_description(LaunchFile(()), robot, 1, "noetic").items
    assert isinstance(item, SetParameter)
    text = getattr(item.parameter, "value", None)
    assert isinstance(text, Text)
    [command] = text.parts
    assert isinstance(command, Substitution)
    assert command.kind is Kind.COMMAND
    assert shlex.split(str(command.argument))[-1] == f"name:={value}"
