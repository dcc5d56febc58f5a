"""What a session, a catalog and an editor keep has a limit, however long they live."""

from __future__ import annotations

import gc
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import pytest

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.session import Session
from plastron_tui.sources.text_memo import MEMO
from plastron_tui.studio.editor.history import Change, History, Kind, Selection, Step

NODE = """\
import rospy
from std_msgs.msg import String

rospy.init_node('talker')
pub = rospy.Publisher('chatter', String, queue_size=10)
# {comment}
"""
ROUNDS = 40
SMALL = 2_000
"""How many bytes more there may be after a round; what the rounds make is far larger."""

Round = Callable[[int], object]


def _load(session: Session, path: Path, number: int) -> None:
    path.write_text(NODE.format(comment=str(number) * 5_000))
    session.edit(0, len(session.document.text), f"load '{path.name}' as node\n".encode())
    assert not session.diagnostics
    assert session.workspace.nodes["node"].source is not None


def load_another_file(folder: Path) -> Round:
    session = Session(b"", folder / "a.plastron", environ={})
    return lambda number: _load(session, folder / f"node_{number}.py", number)


def load_a_file_that_changed(folder: Path) -> Round:
    session = Session(b"", folder / "a.plastron", environ={})
    return lambda number: _load(session, folder / "node.py", number)


def ask_for_types_that_are_not_there(_: Path) -> Round:
    catalog = Catalog("noetic")

    def ask(number: int) -> None:
        for each in range(100):
            bare = f"Type{number}x{each}"
            for kind in InterfaceKind:
                assert not catalog.candidates(bare, kind)
                assert catalog.find(InterfaceName("std_msgs", bare), kind) is None

    return ask


def replace_much(_: Path) -> Round:
    history = History()
    text = 600_000

    def replace(number: int) -> None:
        change = Change(0, b"", bytes([number]) * text)
        step = Step(Kind.OTHER, [change], Selection(0, 0), Selection(0, 0), float(number))
        history.add(step)
        if number % 3 == 0:
            history.undone.append(history.done.pop())

    return replace


def forget() -> None:
    """Leave only what is kept for good: what is remembered of texts has its own bound, in bytes."""
    MEMO.clear()
    gc.collect()


@pytest.mark.long
@pytest.mark.parametrize(
    "begin",
    [
        load_another_file,
        load_a_file_that_changed,
        ask_for_types_that_are_not_there,
        replace_much,
    ],
    ids=lambda each: each.__name__,
)
def test_what_is_kept_has_a_limit(tmp_path: Path, begin: Callable[[Path], Round]) -> None:
    do = begin(tmp_path)
    tracemalloc.start()
    try:
        for number in range(ROUNDS):
            do(number)
        forget()
        before = tracemalloc.get_traced_memory()[0]
        for number in range(ROUNDS, 2 * ROUNDS):
            do(number)
        forget()
        after = tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
    assert (after - before) / ROUNDS < SMALL


def test_the_newest_steps_can_be_undone() -> None:
    history = History()
    here = Selection(0, 0)
    for number in range(11_000):
        history.add(Step(Kind.OTHER, [Change(0, b"", b"x")], here, here, float(number)))
    assert [step.time for step in history.done] == list(range(1_000, 11_000))


def test_a_step_that_is_larger_than_the_history_can_be_undone() -> None:
    history = History()
    here = Selection(0, 0)
    for number in range(2):
        large = Change(0, b"x" * 20_000_000, b"")
        history.add(Step(Kind.OTHER, [large], here, here, float(number)))
    assert [step.time for step in history.done] == [1]
