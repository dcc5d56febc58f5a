"""A launch file that was changed by hand, compared with what its program wrote."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner
from machine import find_ros

from plastron_tui.cli.group import cli
from plastron_tui.diagnostics import Severity
from plastron_tui.project.launch_comparison import differences
from plastron_tui.sources.launch.reader import read_launch

PROGRAM = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
create_launch 'bringup' as bringup
bringup has_argument 'side' with default "left"
bringup starts talker
create_package 'demo' as demo
demo contains talker
demo contains bringup
generate_node talker
generate_package demo
"""
NODE = {
    1: '<node pkg="demo" type="talker.py" name="talker" output="screen"/>',
    2: '<node pkg="demo" exec="talker" name="talker" output="screen"/>',
}


def _launch_file(folder: Path, library: str = "rclpy") -> Path:
    program = folder / "a.plastron"
    program.write_text(PROGRAM)
    done = CliRunner().invoke(cli, ["generate", str(program), "--target", library])
    assert done.exit_code == 0, done.output
    (file,) = (folder / "output/demo/launch").iterdir()
    return file


def _told(file: Path, ros_version: int = 2, **arguments: str) -> list[str]:
    source = file.read_bytes()
    read = read_launch(source, file)
    assert read.launch is not None
    found = differences(read.launch, source, file, ros_version, arguments)
    assert all(each.severity is Severity.WARNING and each.file == file for each in found)
    return [each.message for each in found]


@pytest.mark.parametrize(
    ("new", "said"),
    [
        (NODE[2], []),
        (f"<!-- mine -->{NODE[2]}".replace("screen", "log"), []),
        ("", ["`/talker` is not started, as `a.plastron` wrote it"]),
        (
            f'{NODE[2]}<node pkg="other" exec="eye"/>',
            ["`/eye` is started, which `a.plastron` did not write"],
        ),
        (
            '<node pkg="demo" exec="talker" name="talker" namespace="$(var side)"/>',
            ["the namespace of `/front/talker` is `/front`, and `/` as `a.plastron` wrote it"],
        ),
        (
            '<node pkg="demo" exec="loud" name="talker"/>',
            [
                "the executable of `/talker` is `demo/loud`, and `demo/talker` as `a.plastron` "
                "wrote it"
            ],
        ),
        (
            '<node pkg="demo" exec="talker" name="speaker"/>',
            ["the name of `/speaker` is `speaker`, and `talker` as `a.plastron` wrote it"],
        ),
        (
            '<node pkg="demo" exec="talker" name="talker"><remap from="chatter" to="/words"/>'
            '<param name="speed" value="1.5"/></node>',
            [
                "the remap of `chatter` of `/talker` is `/words`, and not set as `a.plastron` "
                "wrote it",
                "the parameter `speed` of `/talker` is `1.5`, and not set as `a.plastron` wrote it",
            ],
        ),
        (
            # Of two remaps of a name the first holds.
            '<node pkg="demo" exec="talker" name="talker"><remap from="chatter" to="/words"/>'
            '<remap from="chatter" to="/late"/></node>',
            [
                "the remap of `chatter` of `/talker` is `/words`, and not set as `a.plastron` "
                "wrote it"
            ],
        ),
        (
            f'{NODE[2]}<include file="$(find-pkg-share x)/a.launch.xml"/>',
            ["`/x/a.launch.xml` is included, which `a.plastron` did not write"],
        ),
    ],
)
def test_what_was_changed_by_hand_is_told(tmp_path: Path, new: str, said: list[str]) -> None:
    file = _launch_file(tmp_path)
    text = file.read_text()
    assert text.count(NODE[2]) == 1
    file.write_text(text.replace(NODE[2], new))
    assert _told(file, side="front") == said


def test_files_of_ros1_and_of_nobody(tmp_path: Path) -> None:
    file = _launch_file(tmp_path, "rospy")
    assert _told(file, 1) == []
    file.write_text(file.read_text().replace('name="talker"', 'name="talker" ns="a"'))
    assert len(_told(file, 1)) == 1
    own = tmp_path / "own.launch"
    own.write_text(file.read_text())
    assert _told(own, 1) == []
    (tmp_path / "output/.plastron.json").write_text("[")
    assert _told(file, 1) == []


def test_run_tells_it_at_its_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from plastron_tui.runtime import launch

    started: list[str] = []

    def run_nodes(nodes: tuple[launch.NodeFile, ...], *_: object, **__: object) -> launch.RunResult:
        started.extend(each.name for each in nodes)
        return launch.RunResult(0, ())

    monkeypatch.setattr(launch, "run_nodes", run_nodes)
    file = _launch_file(tmp_path)
    find_ros(2)
    file.write_text(file.read_text().replace('name="talker"', 'name="mine"'))
    done = CliRunner().invoke(cli, ["run", str(file)])
    assert done.exit_code == 0, done.stderr
    assert started == ["mine"]
    assert "warning[launch-differs]: the name of `/mine` is `mine`" in done.stderr
    assert "bringup.launch.xml:4:3" in done.stderr
