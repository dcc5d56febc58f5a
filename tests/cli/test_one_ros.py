"""Every command says the same of the ROS that a program is for."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Run
from machine import mostly_long
from one_ros import CASES, GOOD, UNKNOWN_TYPE, unknown_type

from plastron_tui.runtime import environment
from plastron_tui.runtime.environment import Found
from plastron_tui.session import Options, Session


@pytest.mark.parametrize("name", mostly_long(CASES, list(CASES)[::3]))
def test_all_commands_are_for_the_same_ros(
    name: str, run_patched: Run, here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = run_patched
    case = CASES[name]
    case.set_up(here, monkeypatch)
    monkeypatch.setattr(environment, "find_environments", lambda: Found(()))
    option = () if case.target is None else ("--target", case.target)
    wrong = here / "wrong.plastron"
    wrong.write_text(UNKNOWN_TYPE)
    (here / "good.plastron").write_text(GOOD)
    for command in ("check", "generate", "graph", "run"):
        assert unknown_type(case) in run(command, wrong, *option).stderr.decode(), command
    said = run("shell", *option, stdin=UNKNOWN_TYPE.encode()).stderr.decode()
    assert unknown_type(case) in said
    said = run("types", "Twist", *option).stderr.decode()
    assert said.startswith(f"types of ROS {case.ros_version} {case.ros[1]}: ")
    assert run("generate", "good.plastron", *option).returncode == 0
    (file,) = (here / "output").glob("*.py")
    assert json.loads(run("inspect", "-f", "json", file).stdout)["client_library"] == case.ros[0]
    # What it runs with is not there, and is asked for.
    said = run("run", "good.plastron", *option).stderr.decode()
    assert f"no ROS {case.ros_version} is on this machine" in said
    if not option:
        said = run("describe").stderr.decode()
        assert f"no ROS {case.ros_version} is on this machine" in said


@pytest.mark.parametrize("name", CASES)
def test_the_choice_and_the_types_agree(
    name: str, here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = CASES[name]
    case.set_up(here, monkeypatch)
    session = Session(GOOD.encode(), here / "a.plastron", Options(case.target))
    ros = session.ros
    assert (ros.library, ros.distribution, ros.ros_version) == (*case.ros, case.ros_version)
    catalog = session.catalog(ros.ros_version)
    assert (catalog.distribution, catalog.ros_version) == (ros.distribution, ros.ros_version)
    assert session.catalog(3 - ros.ros_version).ros_version == 3 - ros.ros_version
    assert session.workspace.generations[0].library == ros.library
