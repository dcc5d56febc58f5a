"""Programs that change launch files, run again: after handwork, other programs, and a revert."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

FOUND = b"""<launch>
  <arg name='robot' default='rover'/>

  <node pkg='demo' exec='a'/>

  <!-- kept -->
  <node pkg='demo' exec='z'/>
</launch>
"""
ADDS = "load_launch 'b.launch.xml' as b\nb starts 'demo/b'\ngenerate_launch b\n"
RENAMED = ADDS.replace("'demo/b'", "'demo/b' as 'other'")
TAKES = "load_launch 'b.launch.xml' as b\nb no_longer_starts 'a'\ngenerate_launch b\n"
EMPTY = "load_launch 'b.launch.xml' as b\ngenerate_launch b\n"


def run(
    folder: Path,
    program: str,
    *,
    name: str = "p.plastron",
    in_place: bool = True,
    force: bool = False,
) -> tuple[Diagnostic, ...]:
    """Run a program and write what it makes, unless it has errors or conflicts."""
    options = Options("rclpy", folder / "output", in_place=in_place, force=force)
    session = Session(program.encode(), folder / name, options, environ={})
    plan, problems = session.plan()
    found = (*session.diagnostics, *problems)
    if has_errors(found):
        return found
    result = write(plan, force=force)
    return (*found, *result.diagnostics)


def codes(found: tuple[Diagnostic, ...]) -> list[str]:
    return [each.code for each in found]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    found = tmp_path / "b.launch.xml"
    found.write_bytes(FOUND)
    return found


@pytest.mark.parametrize("program", [ADDS, RENAMED, TAKES])
def test_a_second_run_changes_nothing(file: Path, program: str) -> None:
    assert run(file.parent, program) == ()
    made, remembered = file.read_bytes(), (file.parent / ".plastron.json").read_bytes()
    assert made != FOUND
    assert run(file.parent, program) == ()
    assert file.read_bytes() == made
    assert (file.parent / ".plastron.json").read_bytes() == remembered


@pytest.mark.parametrize("first", [ADDS, RENAMED, TAKES])
@pytest.mark.parametrize("second", [ADDS, RENAMED, TAKES, EMPTY])
def test_a_changed_program_makes_what_it_had_made_at_once(
    file: Path, first: str, second: str
) -> None:
    run(file.parent, second)
    at_once = file.read_bytes()
    file.write_bytes(FOUND)
    (file.parent / ".plastron.json").unlink(missing_ok=True)
    run(file.parent, first)
    assert run(file.parent, second) == ()
    assert file.read_bytes() == at_once


@pytest.mark.parametrize("in_place", [True, False])
@pytest.mark.parametrize(
    "before, after", [(b"<!-- kept -->", b"<!-- by hand -->"), (b"'rover'", b"'hand'")]
)
@pytest.mark.parametrize("second", [ADDS, RENAMED])
def test_handwork_is_merged(
    file: Path, in_place: bool, before: bytes, after: bytes, second: str
) -> None:
    run(file.parent, ADDS, in_place=in_place)
    made = file if in_place else file.parent / "output" / file.name
    text = made.read_bytes()
    made.write_bytes(text.replace(before, after))
    found = run(file.parent, second, in_place=in_place)
    assert set(codes(found)) <= {"merged-by-hand"}
    assert after in made.read_bytes()
    assert (b"other" in made.read_bytes()) is (second == RENAMED)
    assert made.read_bytes().count(b"exec='b'") == 1


def test_handwork_beside_what_a_program_wrote_is_merged(file: Path) -> None:
    run(file.parent, ADDS)
    file.write_bytes(file.read_bytes().replace(b"exec='z'", b"exec='y'"))
    assert codes(run(file.parent, RENAMED)) == ["merged-by-hand"]
    assert b"exec='y'" in file.read_bytes()
    assert file.read_bytes().count(b"exec='b'") == file.read_bytes().count(b"other") == 1


def test_what_is_taken_out_by_hand_stays_out(file: Path) -> None:
    run(file.parent, ADDS)
    lines = file.read_bytes().splitlines(keepends=True)
    by_hand = b"".join(line for line in lines if b"exec='a'" not in line)
    file.write_bytes(by_hand)
    assert codes(run(file.parent, ADDS)) == ["merged-by-hand"]
    assert file.read_bytes() == by_hand
    assert codes(run(file.parent, EMPTY)) == ["merged-by-hand"]
    assert b"exec='a'" not in file.read_bytes()
    assert b"exec='b'" not in file.read_bytes()


def test_the_same_lines_changed_on_both_sides_are_a_conflict(file: Path) -> None:
    run(file.parent, ADDS)
    by_hand = file.read_bytes().replace(b"exec='b'", b"exec='b' respawn='true'")
    file.write_bytes(by_hand)
    assert codes(run(file.parent, RENAMED)) == ["file-conflict"]
    assert file.read_bytes() == by_hand
    run(file.parent, RENAMED, force=True)
    assert b"other" in file.read_bytes()
    assert b"respawn" not in file.read_bytes()


def test_a_file_that_was_put_back_is_what_a_program_starts_from(file: Path) -> None:
    run(file.parent, ADDS)
    file.write_bytes(FOUND.replace(b"kept", b"new"))
    assert run(file.parent, ADDS) == ()
    assert b"exec='b'" in file.read_bytes()
    assert b"new" in file.read_bytes()


def test_two_programs_change_one_file(file: Path) -> None:
    run(file.parent, ADDS)
    run(file.parent, TAKES, name="q.plastron")
    both = file.read_bytes()
    assert b"exec='b'" in both
    assert b"exec='a'" not in both
    for name, program in (("p.plastron", ADDS), ("q.plastron", TAKES)):
        assert run(file.parent, program, name=name) == ()
        assert file.read_bytes() == both


def test_a_loaded_launch_of_a_package_is_written_once(file: Path) -> None:
    program = (
        f"{ADDS}create_package 'rover' as rover described_as \"x\" maintained_by "
        '"A <a@b.example>" licensed_under "MIT"\nrover contains b\ngenerate_package rover\n'
    )
    assert run(file.parent, program, in_place=False) == ()
    made = [each.relative_to(file.parent) for each in file.parent.rglob(file.name)]
    assert sorted(map(str, made)) == ["b.launch.xml", "output/rover/launch/b.launch.xml"]


@pytest.mark.parametrize(
    ("first", "second", "before", "after"),
    [
        (RENAMED, ADDS, b"exec='b'", b"exec='c'"),
        (RENAMED, TAKES, b"exec='b'", b"exec='c'"),
        (RENAMED, EMPTY, b"exec='b'", b"exec='c'"),
        (ADDS, TAKES, b"</launch>", b"<group>\n</launch>"),
    ],
)
def test_handwork_is_kept_where_the_program_would_undo_it(
    file: Path, first: str, second: str, before: bytes, after: bytes
) -> None:
    run(file.parent, first)
    by_hand = file.read_bytes().replace(before, after)
    file.write_bytes(by_hand)
    assert codes(run(file.parent, second)) == ["file-conflict"]
    assert file.read_bytes() == by_hand
