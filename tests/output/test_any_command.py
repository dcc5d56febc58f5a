"""Whatever command comes next finishes what was begun, in the project and nowhere else."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from plastron_tui.cli.group import cli
from plastron_tui.output.journal import Entry, Journal, journal_text
from plastron_tui.output.manifest import digest
from plastron_tui.output.own_files import JOURNAL, new_name
from plastron_tui.session import Session
from plastron_tui.studio.files import open_file

OLD = b"import rospy\nrospy.init_node('old')\n"
NEW = b"import rospy\nrospy.init_node('new')\n"

PROGRAM = "load '{}' as robot\ngenerate_node robot\n"


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project, and a folder beside it."""
    monkeypatch.setenv("XDG_STATE_HOME", os.fspath(tmp_path / "state"))
    for name in ("project/.git", "project/output", "outside"):
        (tmp_path / name).mkdir(parents=True)
    return tmp_path / "project"


def begin(folder: Path) -> Path:
    """Leave a folder as a process does that is killed before its only rename."""
    file = folder / "robot.py"
    file.write_bytes(OLD)
    (folder / new_name(0)).write_bytes(NEW)
    journal = Journal("0" * 32, (Entry(file.name, digest(OLD), digest(NEW)),))
    (folder / JOURNAL).write_bytes(journal_text(journal, os.fspath(folder)))
    return file


READERS = [("check",), ("graph",), ("generate", "--dry-run")]


@pytest.mark.parametrize(
    ("place", "arguments"),
    [*((place, each) for place in (".", "output") for each in READERS), (".", ("fmt", "--check"))],
)
def test_a_program_is_read(project: Path, place: str, arguments: tuple[str, ...]) -> None:
    file = begin(project / place)
    program = project / "a.plastron"
    program.write_text(PROGRAM.format(f"{place}/robot.py"))
    cli.main([*arguments, os.fspath(program)], standalone_mode=False)
    assert file.read_bytes() == NEW
    assert not list(project.rglob(".plastron-*"))


def test_a_node_is_inspected(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = begin(project)
    cli.main(["inspect", os.fspath(file)], standalone_mode=False)
    assert "new" in capsys.readouterr().out


def test_the_studio_opens_a_program(project: Path) -> None:
    file = begin(project)
    open_file(project / "a.plastron")
    (project / "a.plastron").touch()
    open_file(project / "a.plastron")
    assert file.read_bytes() == NEW


def test_a_program_leads_to_no_journal_outside_of_its_project(project: Path) -> None:
    file = begin(project.parent / "outside")
    for text in (PROGRAM.format("../outside/robot.py"), PROGRAM.format(file)):
        assert Session(text.encode(), project / "a.plastron").diagnostics
    (project / "plastron.yaml").write_text("output: ../outside\n")
    created = b"create_node 'a' as a\ngenerate_node a\n"
    assert Session(created, project / "a.plastron").diagnostics is not None
    assert file.read_bytes() == OLD


def test_the_studio_says_what_it_found(project: Path) -> None:
    """The only copy of a text has another name now, and that is said once."""
    begin(project)
    (project / ".plastron-7.old").write_text("somebody's")
    for name in ("a.plastron", "none.plastron"):
        (project / "a.plastron").touch()
        said = " ".join(open_file(project / name).said)
        if name == "a.plastron":
            assert "`robot.py`" in said
            assert "`.plastron-kept`" in said
        else:
            assert said == ""


def test_a_session_tells_what_was_finished_until_it_ends(project: Path) -> None:
    begin(project / "output")
    (project / "a.plastron").touch()
    session = Session(PROGRAM.format("output/robot.py").encode(), project / "a.plastron")
    for _ in range(3):
        assert "interrupted-write" in {found.code for found in session.diagnostics}
        session.files_changed()
