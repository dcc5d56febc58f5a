"""The files of robots: written new, changed where they are, and brought together with handwork."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.generating import robot_files
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.sources.urdf.reader import read_urdf

CREATED = """\
create_robot 'rover' as rover
rover has_link 'base'
rover has_link 'mast' shaped box 0.1, 0.1, 0.5 weighing {mass} painted blue at 0, 0, 0.25
rover has_joint 'mast_joint' of joint_type fixed from 'base' to 'mast'{place}
{more}generate_robot rover
"""
LOADED = """\
<?xml version="1.0"?>
<!-- An arm. -->
<robot name='arm'>

  <link name="base"/>
  <link name="upper">   <!-- odd -->
    <visual>
      <geometry><box size="0.1 0.1 0.5"/></geometry>
    </visual>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <limit lower="-1" upper="1.0" effort="10" velocity="1"/>
  </joint>
  <gazebo reference="upper"><material>Gazebo/Red</material></gazebo>
</robot>
"""
LOAD, WRITE = "load_robot 'arm.urdf' as arm\n", "generate_robot arm\n"
WIDER = "arm limits_joint 'shoulder' between -2 and 2 rad\n"
HAND = (
    "arm has_link 'hand' shaped sphere 0.1 weighing 1\n"
    "arm has_joint 'wrist' of joint_type fixed from 'upper' to 'hand' at 0, 0, 0.5\n"
)


def run(
    program: str,
    folder: Path,
    *,
    name: str = "a.plastron",
    in_place: bool = False,
    force: bool = False,
) -> tuple[Diagnostic, ...]:
    """Write what a program asks for, unless something is refused; return what it is told."""
    options = Options(None, folder / "output", in_place, force)
    session = Session(program.encode(), folder / name, options, environ={})
    plan, found = session.plan()
    told = tuple(dict.fromkeys((*session.diagnostics, *found, *plan.conflicts)))
    if not has_errors(told) or force:
        told += write(plan, force=force).diagnostics
    return told


def codes(told: tuple[Diagnostic, ...]) -> list[str]:
    return [str(each.code) for each in told]


def created(mass: float = 2, place: str = "", more: str = "") -> str:
    return CREATED.format(mass=mass, place=place, more=more)


def test_a_created_robot_is_a_file_of_its_name(tmp_path: Path) -> None:
    assert run(created(), tmp_path) == ()
    file = tmp_path / "output/rover.urdf"
    robot = read_urdf(file.read_bytes()).description
    assert robot is not None
    assert list(robot.links) == ["base", "mast"]
    assert not file.stat().st_mode & 0o111
    before = file.read_bytes()
    assert run(created(), tmp_path) == ()
    assert file.read_bytes() == before


@pytest.mark.parametrize(
    ("old", "new", "lines"),
    [
        ('<mass value="2"/>', '<mass value="2"/> <!-- weighed -->', "<!-- weighed -->"),
        ('<box size="0.1 0.1 0.5"/>', '<box size="0.1 0.2 0.5"/>', '<box size="0.1 0.2 0.5"/>'),
        (
            '<parent link="base"/>',
            '<origin xyz="0 0 0" rpy="0 0 1"/>\n    <parent link="base"/>',
            'rpy="0 0 1"',
        ),
    ],
)
@pytest.mark.parametrize("place", ["", " at 0, 0, 0.1"])
def test_handwork_stays_in_a_created_robot(
    old: str, new: str, lines: str, place: str, tmp_path: Path
) -> None:
    file = tmp_path / "output/rover.urdf"
    run(created(), tmp_path)
    file.write_text(file.read_text().replace(old, new))
    assert codes(run(created(3, place), tmp_path)) == ["merged-by-hand"]
    merged = file.read_text()
    assert lines in merged
    robot = read_urdf(file.read_bytes()).description
    assert robot is not None
    inertial = robot.links["mast"].inertial
    assert inertial is not None
    assert inertial.mass == 3
    assert robot.joints["mast_joint"].pose.position == ((0, 0, 0.1) if place else (0, 0, 0))
    run(created(3, place), tmp_path)
    assert file.read_text() == merged


PACKAGE = """\
create_package 'demo' as demo maintained_by "Ada <a@b.cc>" licensed_under "MIT"
demo contains rover
generate_package demo
"""
BUILT = """\
create_node 'ear' as ear using rclcpp
subscribe ear to 'x' of message_type String
generate_node ear
"""


@pytest.mark.parametrize(
    ("rest", "path"), [(PACKAGE, "demo/urdf/rover.urdf"), (BUILT, "urdf/rover.urdf")]
)
def test_handwork_in_a_packages_robot_goes_by_values(rest: str, path: str, tmp_path: Path) -> None:
    run(created() + rest, tmp_path)
    file = tmp_path / "output" / path
    # The program changes the same line.
    file.write_text(file.read_text().replace('<mass value="2"/>', '<mass  value="2" />'))
    assert codes(run(created(3) + rest, tmp_path)) == ["merged-by-hand"]
    assert '<mass  value="3" />' in file.read_text()


def test_what_hand_and_program_both_changed_is_a_conflict(tmp_path: Path) -> None:
    file = tmp_path / "output/rover.urdf"
    run(created(), tmp_path)
    file.write_text(file.read_text().replace('<mass value="2"/>', '<mass value="9"/>'))
    by_hand = file.read_text()
    told = run(created(3), tmp_path)
    assert codes(told) == ["file-conflict"]
    assert "mast" in told[0].message
    assert file.read_text() == by_hand
    run(created(3), tmp_path, force=True)
    assert '<mass value="3"/>' in file.read_text()


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "nothing is left of it"),
        (" \n\n", "nothing is left of it"),
        ('<robot name="rover">\n', "holds no robot that can be read"),
        ("<launch/>\n", "holds no robot that can be read"),
    ],
)
def test_a_file_that_is_no_robot_any_more_is_a_conflict(
    text: str, reason: str, tmp_path: Path
) -> None:
    run(created(), tmp_path)
    file = tmp_path / "output/rover.urdf"
    file.write_text(text)
    for mass in (2, 3):
        told = run(created(mass), tmp_path)
        assert codes(told) == ["file-conflict"]
        assert reason in told[0].message
        assert file.read_text() == text
    run(created(), tmp_path, force=True)
    assert read_urdf(file.read_bytes()).description is not None


@pytest.mark.parametrize("in_package", [False, True])
def test_what_could_not_be_loaded_is_not_written(
    in_package: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robot_files, "MOST_BYTES", 500)
    program = created()
    if in_package:
        program = program.replace(
            "generate_robot rover",
            'create_package \'demo\' as demo maintained_by "Ada <a@b.cc>" licensed_under "MIT"\n'
            "demo contains rover\ngenerate_package demo",
        )
    [told] = run(program, tmp_path)
    assert told.code == "file-too-large"
    assert told.span is not None
    assert not list(tmp_path.glob("output/**/*.urdf"))


def test_a_file_that_nobody_knows_is_not_written_over(tmp_path: Path) -> None:
    file = tmp_path / "output/rover.urdf"
    file.parent.mkdir()
    file.write_text("<robot name='mine'/>\n")
    assert codes(run(created(), tmp_path)) == ["file-conflict"]
    assert file.read_text() == "<robot name='mine'/>\n"


@pytest.mark.parametrize(
    "change", [WIDER, HAND, WIDER + HAND, "arm no_longer_has_joint 'shoulder'\n"]
)
def test_a_loaded_robot_is_changed_and_changed_back(change: str, tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(LOADED)
    change += "arm no_longer_has_link 'upper'\n" if "no_longer" in change else ""
    first = run(LOAD + change + WRITE, tmp_path, in_place=True)
    assert not has_errors(first), first
    changed = file.read_bytes()
    assert changed != LOADED.encode()
    run(LOAD + change + WRITE, tmp_path, in_place=True)
    assert file.read_bytes() == changed
    assert run(LOAD + WRITE, tmp_path, in_place=True) == ()
    assert file.read_bytes() == LOADED.encode()


def test_the_output_folder_gets_a_changed_copy(tmp_path: Path) -> None:
    file, copy = tmp_path / "arm.urdf", tmp_path / "output/arm.urdf"
    file.write_text(LOADED)
    for _ in range(2):
        assert run(LOAD + WIDER + WRITE, tmp_path) == ()
        assert file.read_text() == LOADED
        assert copy.read_text() == LOADED.replace('"-1"', '"-2"').replace(
            'upper="1.0"', 'upper="2.0"'
        )
    assert run(LOAD + WRITE, tmp_path) == ()
    assert copy.read_text() == LOADED


def test_handwork_stays_in_a_loaded_robot(tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(LOADED)
    run(LOAD + WIDER + HAND + WRITE, tmp_path, in_place=True)
    by_hand = ("An arm.", "My arm."), ('"0.1 0.1 0.5"', '"0.2 0.1 0.5"')
    wanted = LOADED
    for each in by_hand:
        file.write_text(file.read_text().replace(*each))
        wanted = wanted.replace(*each)
    assert codes(run(LOAD + HAND + WRITE, tmp_path, in_place=True)) == ["merged-by-hand"]
    assert '"0.2 0.1 0.5"' in file.read_text()
    assert "hand" in file.read_text()
    assert 'upper="1.0"' in file.read_text()
    run(LOAD + WRITE, tmp_path, in_place=True)
    assert file.read_text() == wanted


def test_two_programs_change_one_robot(tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(LOADED)
    run(LOAD + WIDER + WRITE, tmp_path, in_place=True)
    run(LOAD + HAND + WRITE, tmp_path, name="b.plastron", in_place=True)
    both = file.read_bytes()
    assert b'"hand"' in both
    assert b'lower="-2"' in both
    run(LOAD + HAND + WRITE, tmp_path, name="b.plastron", in_place=True)
    assert file.read_bytes() == both
    run(LOAD + WRITE, tmp_path, name="b.plastron", in_place=True)
    run(LOAD + WRITE, tmp_path, in_place=True)
    assert file.read_text() == LOADED


def test_a_program_with_nothing_but_a_robot_needs_no_ros(tmp_path: Path) -> None:
    session = Session(created().encode(), tmp_path / "a.plastron", environ={})
    assert session.diagnostics == ()
    assert session.generated() == ()
    plan, found = session.plan()
    assert found == ()
    assert [each.name for each in plan.files] == ["rover.urdf"]


def test_what_comes_after_a_robot_is_written_is_told(tmp_path: Path) -> None:
    late = "rover has_link 'late'\nrover no_longer_has_link 'late'\n"
    told = run(created() + late, tmp_path)
    assert codes(told) == ["changed-after-generating"] * 2


def test_lines_that_fit_are_merged_as_lines(tmp_path: Path) -> None:
    file = tmp_path / "output/rover.urdf"
    more = "rover has_link 'eye'\n"
    more += "rover has_joint 'eye_joint' of joint_type fixed from 'mast' to 'eye'\n"
    run(created(more=more), tmp_path)
    wanted = file.read_text().replace("<robot", "<!-- mine -->\n<robot")
    file.unlink()
    run(created(), tmp_path)
    file.write_text(file.read_text().replace("<robot", "<!-- mine -->\n<robot"))
    run(created(more=more), tmp_path)
    assert file.read_text() == wanted


def test_what_is_laid_out_otherwise_is_the_programs_still(tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(LOADED)
    run(LOAD + WIDER + WRITE, tmp_path, in_place=True)
    line = '<limit lower="-2" upper="2.0" effort="10" velocity="1"/>'
    assert line in file.read_text()
    by_hand = file.read_text().replace(
        line, '<limit velocity="1" effort="10" upper="2.0" lower="-2"/>'
    )
    file.write_text(by_hand)
    assert codes(run(LOAD + WRITE, tmp_path, in_place=True)) == ["merged-by-hand"]
    back = by_hand.replace('upper="2.0" lower="-2"', 'upper="1.0" lower="-1"')
    assert file.read_text() == back


@pytest.mark.parametrize(
    "name", ["../evil", "a/b", "", ".", "..", ".hidden", "a\\b", "a b", "x" * 300, "a\x1b[2J", "-o"]
)
def test_no_name_leads_elsewhere(name: str, tmp_path: Path) -> None:
    program = f"create_robot '{name}' as rover\nrover has_link 'a'\ngenerate_robot rover\n"
    assert has_errors(run(program, tmp_path / "project"))
    assert list(tmp_path.rglob("*")) == []


def test_the_name_in_a_loaded_file_is_no_path(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text('<robot name="../../evil"><link name="a"/></robot>\n')
    program = "load_robot 'arm.urdf' as arm\narm has_link 'a' painted red\ngenerate_robot arm\n"
    run(program, tmp_path)
    run("load_robot 'arm.urdf' as arm\ngenerate_robot arm\n", tmp_path)
    written = [x.relative_to(tmp_path).as_posix() for x in tmp_path.rglob("*.urdf")]
    assert sorted(written) == ["arm.urdf", "output/arm.urdf"]
