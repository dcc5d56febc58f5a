"""Folders that an earlier version generated, and somebody worked in: nothing of that is lost."""

from __future__ import annotations

import shutil
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import pytest
from again_driver import shown

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.output.plan import FilePlan
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

EARLIER = Path(__file__).parent / "earlier"
MARK = "  # by hand\n"


class Folder(NamedTuple):
    """How a folder was made, and how its program changes.

    Attributes:
        files: what the program writes, from the folder.
        changes: texts of the program, and what takes their place.
        gone: the endpoints that the changes take out.
        new: the endpoints that they add.
        sent: what a publisher sends then, as its file says it.
        library: the client library of created nodes.
        in_place: whether loaded nodes are written over what they come from.
        program: the program's name.
        warnings: the codes of what is said of all of it, besides that there is handwork.
    """

    files: tuple[str, ...]
    changes: tuple[tuple[str, str], ...]
    gone: tuple[tuple[str, str], ...]
    new: tuple[tuple[str, str], ...]
    sent: str = ""
    library: str = "rospy"
    in_place: bool = False
    program: str = "robot.plastron"
    warnings: tuple[str, ...] = ()


CREATED = Folder(
    ("made/talker_node.py", "made/listener_node.py"),
    (
        ("publish five to 'count'", "publish five to 'mood'"),
        (
            "subscribe listener to 'count' of message_type Int32",
            "listener provides_service 'start' of service_type Trigger",
        ),
        ("listener provides_service 'stop' of service_type Empty", ""),
        (
            "client_requests 'reset' of service_type Empty",
            "client_requests 'start' of service_type Trigger",
        ),
        ('input "hello"', 'input "hi"'),
    ),
    (
        ("publishers", "count"),
        ("clients", "reset"),
        ("subscriptions", "count"),
        ("services", "stop"),
    ),
    (("publishers", "mood"), ("clients", "start"), ("services", "start")),
    'String(data="hi")',
)
LOADED = Folder(
    ("made/robot.py",),
    (("publish hello to 'chatter'", "publish hello to 'news'"), ("robot stop_service 'reset'", "")),
    (("publishers", "chatter"),),
    (("publishers", "news"), ("services", "reset")),
)
FOLDERS = {
    "created_rospy": CREATED,
    "created_rclpy": CREATED._replace(library="rclpy"),
    "loaded_rospy": LOADED._replace(warnings=("uncalled-function",)),
    "loaded_rclpy": LOADED._replace(warnings=("uncalled-function",)),
    "ported_to_rospy": LOADED,
    "ported_to_rclpy": LOADED,
    "merged_created": CREATED,
    "merged_loaded": LOADED,
    "in_place": Folder(
        ("nodes/robot.py",),
        (("publish five to 'second'", "publish five to 'third'"),),
        (("publishers", "second"),),
        (("publishers", "third"),),
        in_place=True,
        program="second.plastron",
    ),
    "two_nodes": Folder(
        ("made/robot.py",),
        (("'count'", "'more'"),),
        (("subscriptions", "count"),),
        (("subscriptions", "more"),),
    ),
    "renamed": Folder(
        ("made/guide_node.py",),
        (("subscribe guide to 'chatter'", "subscribe guide to 'news'"),),
        (("subscriptions", "chatter"),),
        (("subscriptions", "news"),),
    ),
}
each_folder = pytest.mark.parametrize("name", FOLDERS)


class Work:
    """A copy of one of the folders."""

    def __init__(self, here: Path, name: str) -> None:
        self.how = FOLDERS[name]
        self.path = here / name
        shutil.copytree(EARLIER / name, self.path)
        self.files = [self.path / each for each in self.how.files]

    def plan(self) -> tuple[FilePlan, list[Diagnostic]]:
        program = self.path / self.how.program
        options = Options(self.how.library, self.path / "made", in_place=self.how.in_place)
        session = Session(program.read_bytes(), program, options, environ={})
        plan, told = session.plan()
        return plan, [*session.diagnostics, *told, *plan.conflicts]

    def generate(self) -> tuple[set[str], list[str]]:
        """Generate, as the command does; return the files' states and the codes of all warnings."""
        plan, told = self.plan()
        assert [each for each in told if each.severity is Severity.ERROR] == []
        assert [file.path for file in plan.files] == self.files
        result = write(plan)
        assert result.diagnostics == ()
        return {file.state.value for file in plan.files}, [str(each.code) for each in told]

    def change_program(self, changes: tuple[tuple[str, str], ...] | None = None) -> None:
        program = self.path / self.how.program
        text = program.read_text()
        for old, new in changes or self.how.changes:
            assert text.count(old) == 1
            text = text.replace(old, new)
        program.write_text(text)

    def texts(self) -> list[str]:
        return [file.read_text() for file in self.files]

    def endpoints(self) -> Counter[tuple[str, str | None]]:
        return sum((shown(file) for file in self.files), Counter())


def by_hand(texts: list[str]) -> list[list[str]]:
    return [[line for line in text.splitlines(True) if line.endswith(MARK)] for text in texts]


def test_every_folder_is_tried() -> None:
    assert {each.name for each in EARLIER.iterdir() if each.is_dir()} == set(FOLDERS)


# The program of the two nodes had to say since which of them it means: it is not the same.
@pytest.mark.parametrize("name", sorted(FOLDERS.keys() - {"two_nodes"}))
def test_the_same_program_changes_nothing(tmp_path: Path, name: str) -> None:
    work = Work(tmp_path, name)
    before = work.texts()
    assert all(by_hand(before))
    states, codes = work.generate()
    assert states == {"identical"}
    assert set(codes) <= {"merged-by-hand", *work.how.warnings}
    assert work.texts() == before


@each_folder
def test_a_changed_program_is_merged_with_the_handwork(tmp_path: Path, name: str) -> None:
    work = Work(tmp_path, name)
    before, had = work.texts(), work.endpoints()
    work.change_program()
    states, codes = work.generate()
    assert states == {"changed"}
    assert set(codes) == {"merged-by-hand", *work.how.warnings}
    assert by_hand(work.texts()) == by_hand(before)
    assert work.endpoints() == had - Counter(work.how.gone) + Counter(work.how.new)
    merged = work.texts()
    assert work.how.sent in "".join(merged)
    assert work.generate()[0] == {"identical"}
    assert work.texts() == merged


@pytest.mark.parametrize("name", sorted(FOLDERS.keys() - {"in_place", "merged_created", "renamed"}))
def test_without_handwork_a_file_is_as_in_a_new_folder(tmp_path: Path, name: str) -> None:
    work = Work(tmp_path, name)
    work.change_program()
    for file in work.files:
        lines = file.read_text().splitlines(True)
        file.write_text("".join(line for line in lines if not line.endswith(MARK)))
    assert work.generate() == ({"changed"}, [*work.how.warnings])
    texts = work.texts()
    shutil.rmtree(work.path / "made")
    assert work.generate() == ({"create"}, [*work.how.warnings])
    assert work.texts() == texts
