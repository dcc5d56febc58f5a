"""Programs of a workspace: their own mistakes, and their nodes among the others."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import told, write_tree

from plastron_tui.cli.lint_programs import read_program
from plastron_tui.lint.selection import Selection
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.rewriting import note_all
from plastron_tui.project.linting.run import LintOptions, LintRun

PROGRAM = """\
create_node 'listener' as listener using rospy
subscribe listener to 'chatter' of message_type String
generate_node listener
"""
TALKER = """\
import rospy
from std_msgs.msg import {type}
rospy.init_node('{name}')
pub = rospy.Publisher('chatter', {type}, queue_size=1)
rospy.spin()
"""
WRONG = TALKER.format(name="talker", type="Int32")
OWN = TALKER.format(name="listener", type="String")


@pytest.mark.parametrize(
    ("program", "files", "found"),
    [
        (PROGRAM, {}, []),
        (PROGRAM, {"talker.py": WRONG}, [("RG101", 2)]),
        (PROGRAM + "subscribe lisener to 'b' of message_type String\n", {}, [("unknown-node", 4)]),
        (PROGRAM + "bad  // noqa: unknown-statement, syntax-error\n", {}, None),
        # The node is written: its file counts, and is right.
        (PROGRAM, {"talker.py": TALKER.format(name="t", type="String"), "listener.py": OWN}, []),
        # What its own check tells of its statements is told once.
        (
            PROGRAM
            + "create_node 'talker' as talker using rospy\n"
            + "create_message one of message_type Int32 and input 1\n"
            + "talker publish one to 'chatter' of message_type Int32 at 2 hz\n",
            {},
            [("topic-type-conflict", 6)],
        ),
        ("\0", {}, None),
    ],
)
def test_a_program_among_files(
    tmp_path: Path, program: str, files: dict[str, str], found: list[tuple[str, int]] | None
) -> None:
    root = write_tree(tmp_path, {"a.plastron": program, **files})
    cache = FactCache(root, tmp_path / "cache")
    options = LintOptions((root,), Selection(), workers=1, cache=cache, read_program=read_program)
    run = LintRun(options)
    if found is None:
        assert all(each.diagnostic.file == root / "a.plastron" for each in run.told)
    else:
        assert told(run) == found


def test_mistakes_of_programs_are_chosen_as_rules_are(tmp_path: Path) -> None:
    wrong = PROGRAM + "subscribe lisener to 'b' of message_type String\n"
    root = write_tree(tmp_path, {"a.plastron": wrong})

    def codes(selection: Selection) -> list[str]:
        cache = FactCache(root, tmp_path / "cache")
        options = LintOptions((root,), selection, workers=1, cache=cache, read_program=read_program)
        return [code for code, _ in told(LintRun(options))]

    assert codes(Selection()) == ["unknown-node"]
    assert codes(Selection(("unknown-node",))) == ["unknown-node"]
    assert codes(Selection(("RG",))) == []
    assert codes(Selection((), ("unknown-node",))) == []
    assert codes(Selection((), (), {"*.plastron": ("unknown-node",)})) == []


@pytest.mark.parametrize("line", ["nonsense it is\n", "create_node 'talker as talker\n"])
def test_nobody_means_what_is_no_sentence(tmp_path: Path, line: str) -> None:
    root = write_tree(tmp_path, {"a.plastron": PROGRAM + line})
    cache = FactCache(root, tmp_path / "cache")
    run = LintRun(LintOptions((root,), workers=1, cache=cache, read_program=read_program))
    assert run.told
    assert note_all(run).done == 0
    assert (root / "a.plastron").read_text() == PROGRAM + line
