"""What breaks rules in the files that a program loads: `check` and the studio tell the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE

from plastron_tui.project.loaded_problems import loaded_problems
from plastron_tui.session import Session
from plastron_tui.studio.analysis import analyse
from plastron_tui.studio.panels import problems

LOADED = NO_QUEUE + "rospy.init_node('talker')\nrospy.spin()\n"
PROGRAM = b"load talker as t\nsubscribe t to 'b' of message_type String\ngenerate_node t\n"


def _session(folder: Path, text: str, settings: str = "") -> Session:
    (folder / "talker.py").write_text(text)
    (folder / "plastron.yaml").write_text(settings)
    return Session(PROGRAM, folder / "a.plastron", environ={})


@pytest.mark.parametrize(
    ("text", "settings", "count"),
    [
        (LOADED, "", 1),
        (LOADED.replace("String)", "String)  # noqa: RC407"), "", 0),
        (LOADED.replace("String)", "String, queue_size=1)"), "", 0),
        (LOADED, "lint: {ignore: RC407}", 0),
        (LOADED, "lint: {per_file_ignores: {talker.py: RC}}", 0),
        (LOADED, "lint: {select: RG}", 0),
    ],
)
def test_what_is_found(tmp_path: Path, text: str, settings: str, count: int) -> None:
    session = _session(tmp_path, text, settings)
    found = loaded_problems(session)
    assert [(str(each.code), each.file) for each in found] == [
        ("RC407", tmp_path / "talker.py")
    ] * count
    # What `generate` needs is another matter.
    assert session.diagnostics == ()


def test_the_problems_of_the_studio_have_it(tmp_path: Path) -> None:
    analysis = analyse(_session(tmp_path, LOADED), lambda: None)
    assert analysis.diagnostics == ()
    assert problems.count(analysis) == 1
    first = problems.make(analysis, None).all[0]
    assert (first.name, first.line) == ("talker.py:3", 3)


def test_a_file_that_changes_is_looked_at_again(tmp_path: Path) -> None:
    session = _session(tmp_path, LOADED)
    assert len(loaded_problems(session)) == 1
    (tmp_path / "talker.py").write_text(LOADED.replace("String)", "String, queue_size=1)"))
    session.files_changed()
    assert loaded_problems(session) == ()
