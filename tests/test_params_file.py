"""The parameter file of a program is written with its nodes, and never over what a user wrote."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

PROGRAM = """\
create_node 'cruiser' as cruiser
cruiser has_parameter 'speed' of parameter_type float with default {}
cruiser has_parameter 'frame' of parameter_type string with default "map"
generate_node cruiser using {}
"""
TEXT = '/cruiser:\n  ros__parameters:\n    speed: {}\n    frame: "map"\n'

TALKER = b"""\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""


def generate(folder: Path, speed: str, library: str = "rclpy", output: Path | None = None) -> None:
    """Generate a program in a folder."""
    session = Session(
        PROGRAM.format(speed, library).encode(), folder / "p.plastron", Options(output=output)
    )
    plan, diagnostics = session.plan()
    assert not diagnostics
    assert not plan.conflicts
    assert not write(plan).diagnostics


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_it_follows_the_program(tmp_path: Path, library: str) -> None:
    file = tmp_path / "config" / "p.yaml"
    for speed in ("0.5", "2.0", "2.0"):
        generate(tmp_path, speed, library)
        assert file.read_text() == TEXT.format(speed)


def test_what_all_nodes_of_ros_1_share_is_no_nodes_own(tmp_path: Path) -> None:
    program = PROGRAM.format("1.0", "rospy").replace("'speed'", "'/speed'")
    session = Session(program.encode(), tmp_path / "p.plastron")
    plan, diagnostics = session.plan()
    assert not diagnostics
    assert not write(plan).diagnostics
    text = (tmp_path / "config" / "p.yaml").read_text()
    assert text == '/cruiser:\n  ros__parameters:\n    frame: "map"\n'
    assert session.params()[1] == ()


@pytest.mark.parametrize("text", ["", "# mine", TEXT.format("7.0")])
@pytest.mark.parametrize("is_first", [True, False])
def test_what_a_user_wrote_stays(tmp_path: Path, text: str, is_first: bool) -> None:
    file = tmp_path / "config" / "p.yaml"
    if not is_first:
        generate(tmp_path, "0.5")
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    generate(tmp_path, "2")
    assert file.read_text() == text


def test_it_is_not_written_outside_of_the_project(tmp_path: Path) -> None:
    project, elsewhere = tmp_path / "project", tmp_path / "elsewhere"
    project.mkdir()
    elsewhere.mkdir()
    (project / "config").symlink_to(elsewhere)
    generate(project, "1")
    generate(project, "1", output=tmp_path / "named" / "output")
    assert not list(elsewhere.iterdir())
    assert not (tmp_path / "named" / "config").exists()


def test_a_program_without_parameters_has_none(tmp_path: Path) -> None:
    session = Session(TALKER, tmp_path / "p.plastron")
    plan, _ = session.plan()
    assert [file.name for file in plan.files] == ["talker_pub.py"]
