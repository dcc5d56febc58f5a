"""Choosing a file that the program has loaded already: it goes on with its node."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import CHANGE, MORE, NODE_FILE, SEND, choose, course, to_menu_or_review

from plastron_tui.session import Options, Session
from plastron_tui.studio.wizard import strings
from plastron_tui.studio.wizard.menu import writes_too
from plastron_tui.studio.wizard.pages import PageKind

TOPIC = "use another topic, or rename something"
LOADED = "load 'sonar.py' as ears\nears repeats tick at 5 hz\ngenerate_node ears\n"
OTHER = NODE_FILE.replace("'sonar'", "'other'")
TWO = """\
import rclpy
from rclpy.node import Node


class Left(Node):
    def __init__(self):
        super().__init__("left")


class Right(Node):
    def __init__(self):
        super().__init__("right")
"""


def test_a_file_that_is_loaded_goes_on_with_its_node(tmp_path: Path) -> None:
    (tmp_path / "sonar.py").write_text(NODE_FILE)
    it = course(LOADED, tmp_path)
    choose(it, CHANGE)
    look = it.look()
    assert it.page.kind is PageKind.FORM
    cells = look.filled[0].cells
    assert (cells["source"].text, cells["variable"].text) == ("sonar.py", "ears")
    # Nothing is written by that page, and nothing keeps it from being left.
    assert look.outcome is None and not it.blocking(look)
    look = to_menu_or_review(it)
    assert it.page.kind is PageKind.PURPOSE and look.node == "ears"
    choose(it, TOPIC)
    look = to_menu_or_review(it)
    assert it.page.kind is PageKind.REVIEW and look.outcome is not None
    assert [each.split()[0] for each in look.outcome.lines] == ["ears"]
    # Of its one topic nobody has to choose the name that goes.
    assert look.filled[-1].cells["old"].reason == "the only topic of `ears`"
    assert b"repeats tick at 5 hz" in look.outcome.session.document.text
    it.back()
    assert it.page.kind is PageKind.FORM


@pytest.mark.parametrize(
    ("files", "program", "suggested"),
    [
        ({"sonar.py": NODE_FILE, "other.py": OTHER}, LOADED, ("other.py", "", "other")),
        ({"two.py": TWO}, "load 'two.py' node 'left' as l\n", ("two.py", "right", "right")),
        (
            {"two.py": TWO},
            "load 'two.py' node 'left' as l\nload 'two.py' node 'right' as r\n",
            ("two.py", "left", "l"),
        ),
    ],
)
def test_what_is_not_loaded_yet_comes_first(
    tmp_path: Path, files: dict[str, str], program: str, suggested: tuple[str, str, str]
) -> None:
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    it = course(program, tmp_path)
    choose(it, CHANGE)
    cells = it.look().filled[0].cells
    assert tuple(cells[name].text for name in ("source", "name", "variable")) == suggested


def test_two_loads_of_one_file_are_a_problem_before_they_are_run(tmp_path: Path) -> None:
    (tmp_path / "sonar.py").write_text(NODE_FILE)
    again = "load 'sonar.py' as again\nagain renames topic 'range' to 'far'\ngenerate_node again\n"
    session = course(LOADED + again, tmp_path).session
    _, planned = session.plan()
    (found,) = session.diagnostics
    assert found in planned and found.code == "same-file"
    # The last page of whatever is added says it, and does not mind.
    it = course(LOADED + again, tmp_path)
    choose(it, MORE, SEND)
    look = to_menu_or_review(it)
    assert look.problems == ()
    assert strings.review(look).endswith(
        "before it goes: two texts would be written to `sonar.py`."
    )


def test_where_a_changed_file_is_written_is_asked(tmp_path: Path) -> None:
    (tmp_path / "sonar.py").write_text(NODE_FILE)
    program = tmp_path / "program.plastron"
    session = Session(LOADED.encode(), program, environ={})
    folder = f"{session.output.name}/"
    assert writes_too(session, "ears") == (
        f"write the changed sonar.py to {folder}, too; your own file stays as it is"
    )
    assert writes_too(session, "new") == f"write new to its file in {folder}, too"
    session = Session(LOADED.encode(), program, Options(in_place=True), {})
    assert writes_too(session, "ears") == "write the changed sonar.py, too"
