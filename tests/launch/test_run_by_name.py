"""`plastron run PROGRAM LAUNCH`: a program is written, and its launch file started."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from machine import find_ros

from plastron_tui.cli.group import cli
from plastron_tui.runtime import launch

PROGRAM = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
create_launch 'bringup' as up
up has_argument 'side' with default "left"
up starts talker in '$(var side)'
create_package 'demo' as demo described_as "x" maintained_by "A <a@b.example>" licensed_under "MIT"
demo contains talker
demo contains up
generate_package demo
"""


class Started(list[launch.NodeFile]):
    """What would have been started."""


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> Started:
    found = Started()

    def run_nodes(nodes: list[launch.NodeFile], *_: object, **__: object) -> launch.RunResult:
        found.extend(nodes)
        return launch.RunResult(0, ())

    monkeypatch.setattr(launch, "run_nodes", run_nodes)
    return found


def _run(folder: Path, *words: str, program: str = PROGRAM) -> Result:
    find_ros(2)
    (folder / "p.plastron").write_text(program)
    return CliRunner().invoke(cli, ["run", str(folder / "p.plastron"), "--target", "rclpy", *words])


@pytest.mark.parametrize(
    "words, namespace",
    [
        pytest.param(["bringup"], "/left", marks=pytest.mark.long),
        pytest.param(["up"], "/left", marks=pytest.mark.long),
        (["bringup", "side:=right"], "/right"),
    ],
)
def test_a_launch_file_is_written_and_started(
    tmp_path: Path, started: Started, words: list[str], namespace: str
) -> None:
    done = _run(tmp_path, *words)
    assert done.exit_code == 0, done.output
    assert (tmp_path / "output/demo/launch/bringup.launch.xml").is_file()
    assert [(each.name, each.namespace) for each in started] == [("talker", namespace)]
    assert "running bringup.launch.xml on" in done.stderr


@pytest.mark.parametrize(
    "words, program, status, said",
    [
        (["bringup", "talker"], PROGRAM, 2, "is a launch file, and is started without `talker`"),
        pytest.param(
            ["bringup", "--namespace", "a"],
            PROGRAM,
            2,
            "--namespace is for programs",
            marks=pytest.mark.long,
        ),
        (["bringpu"], PROGRAM, 1, "did you mean `bringup`?"),
        (["bringup"], PROGRAM.replace("demo contains up\n", ""), 1, "does not write `bringup`"),
        (["bringup"], PROGRAM.replace("starts talker", "starts tlker"), 1, "no node `tlker`"),
    ],
)
def test_what_cannot_be_started_is_told(
    tmp_path: Path, started: Started, words: list[str], program: str, status: int, said: str
) -> None:
    done = _run(tmp_path, *words, program=program)
    assert (done.exit_code, [*started]) == (status, [])
    assert said in " ".join(done.stderr.split())


def test_what_was_changed_by_hand_is_started_and_told(tmp_path: Path, started: Started) -> None:
    assert _run(tmp_path, "bringup").exit_code == 0
    file = tmp_path / "output/demo/launch/bringup.launch.xml"
    file.write_text(file.read_text().replace('name="talker"', 'name="mine"'))
    started.clear()
    done = _run(tmp_path, "bringup")
    assert [each.name for each in started] == ["mine"]
    assert "warning[launch-differs]" in done.stderr


@pytest.mark.parametrize(
    "old, new, is_stale",
    [
        pytest.param("", "", False, marks=pytest.mark.long),
        ('"hi"', '"ho"', False),
        ("starts talker", "starts talker as 'other'", True),
        pytest.param("starts talker", "starts tlker", False, marks=pytest.mark.long),
    ],
)
def test_a_program_that_says_otherwise_by_now_is_told(
    tmp_path: Path, started: Started, old: str, new: str, is_stale: bool
) -> None:
    assert _run(tmp_path, "bringup").exit_code == 0
    program = tmp_path / "p.plastron"
    program.write_text(PROGRAM.replace(old, new))
    file = tmp_path / "output/demo/launch/bringup.launch.xml"
    os.utime(program, ns=(file.stat().st_mtime_ns + 10**9,) * 2)
    done = CliRunner().invoke(cli, ["run", str(file)])
    assert done.exit_code == 0, done.output
    assert ("`p.plastron` says otherwise by now" in done.stderr) is is_stale
    assert ("plastron generate p.plastron" in done.stderr) is is_stale


@pytest.mark.parametrize("has_launch", [True, False])
def test_nodes_alone_are_run_with_a_hint(
    tmp_path: Path, started: Started, has_launch: bool
) -> None:
    kept = [line for line in PROGRAM.splitlines() if has_launch or "up" not in line.split()]
    program = "\n".join(line for line in kept if has_launch or "create_launch" not in line)
    done = _run(tmp_path, program=f"{program}\n")
    assert done.exit_code == 0, done.output
    assert [each.name for each in started] == ["talker"]
    hint = "`plastron run p.plastron bringup` starts the launch file"
    assert (hint in done.stderr) is has_launch
