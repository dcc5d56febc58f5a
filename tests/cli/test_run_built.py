"""What `plastron run` says of nodes that have to be built, before it builds any."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.cli.run_built import built_files
from plastron_tui.diagnostics import has_errors
from plastron_tui.project.run_setup import RunSetup
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime import build_needs, builds
from plastron_tui.runtime.environment import Environment
from plastron_tui.session import Options, Session

PROGRAM = """\
create_node 'eyes' as eyes using roscpp
subscribe eyes to 'chatter' of message_type String
generate_node eyes
create_node 'ears' as ears using {}
subscribe ears to 'speech' of message_type String
generate_node ears
"""
VERSIONS = {"roscpp": 1, "nodelet": 1, "rclcpp": 2, "component": 2}


@pytest.mark.parametrize(
    ("library", "told"),
    [
        ("nodelet", "`nodelet` is not installed in ROS 1 noetic (sourced), and it loads"),
        ("rclcpp", "`rclcpp` and `std_msgs` are not installed in ROS 2 kilted (sourced), and"),
        ("component", "`rclcpp_components` is not installed in ROS 2 kilted (sourced), and it"),
    ],
)
def test_what_no_build_would_find_is_told_before_anything_is_built(
    library: str, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # ROS 1 has all for a program of its own; of all else there is nothing.
    for name in ("roscpp", "std_msgs"):
        (tmp_path / "ros1" / "share" / name / "cmake").mkdir(parents=True)
    found = {1: [tmp_path / "ros1"], 2: []}
    monkeypatch.setattr(
        build_needs, "prefixes_of", lambda environment, *_: found[environment.ros_version]
    )
    monkeypatch.setattr("plastron_tui.runtime.built_nodes.prefixes_of", lambda *_: [])
    monkeypatch.setattr(builds, "overlay", lambda *_: pytest.fail("it builds"))
    path = tmp_path / "robot.plastron"
    text = PROGRAM.format(library)
    session = Session(text.encode(), path, Options(is_writing=True), environ={})
    plan, problems = session.plan()
    assert not has_errors(problems)
    for file in plan.files:
        file.path.parent.mkdir(parents=True, exist_ok=True)
        file.path.write_bytes(file.text)
    environments = {
        name: Environment(
            Origin.SOURCED, version, {1: "noetic", 2: "kilted"}[version], Path("/usr/bin/python3")
        )
        for name, version in VERSIONS.items()
    }
    files, problems_of_build = built_files(session, session.generated(), environments, RunSetup())
    assert files == []
    (problem,) = problems_of_build
    assert problem.code == "missing-ros-package"
    assert problem.message.startswith(told)
    assert problem.span is not None
    assert text[problem.span.start :].startswith("generate_node ears")


def test_the_node_that_needs_what_is_missing_is_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "ros1" / "share" / "roscpp" / "cmake").mkdir(parents=True)
    monkeypatch.setattr(build_needs, "prefixes_of", lambda *_: [tmp_path / "ros1"])
    mute = "create_node 'mute' as mute using roscpp\ngenerate_node mute\n"
    text = mute + PROGRAM.partition("create_node 'ears'")[0]
    session = Session(
        text.encode(), tmp_path / "robot.plastron", Options(is_writing=True), environ={}
    )
    plan, _ = session.plan()
    for file in plan.files:
        file.path.parent.mkdir(parents=True, exist_ok=True)
        file.path.write_bytes(file.text)
    debian = Environment(Origin.DEBIAN, 1, "noetic", Path("/usr/bin/python3"))
    _, (problem,) = built_files(session, session.generated(), {"roscpp": debian}, RunSetup())
    assert problem.message.startswith("`std_msgs` is not installed")
    assert problem.span is not None
    assert text[problem.span.start :].startswith("generate_node eyes")
