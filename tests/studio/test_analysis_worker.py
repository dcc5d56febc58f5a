"""The worker that finds out what a program means."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable, Iterator
from time import monotonic, sleep

import pytest
from textual.message import Message

from plastron_tui import collector
from plastron_tui.session import Session
from plastron_tui.studio import analysis_worker as module
from plastron_tui.studio.analysis import PartMemo, analyse
from plastron_tui.studio.analysis_worker import Analysed, AnalysisWorker
from plastron_tui.studio.discarding import Discarded
from plastron_tui.studio.panels.panel import Request

NODES, PROBLEMS = Request("nodes", True), Request("problems", True)
MANY = b"".join(b"create_node 'n%d' as n%d\n" % (n, n) for n in range(300))
PROGRAM = b"create_node 'talker' as talker\ngenerate_node talker\n"


def until(condition: Callable[[], bool]) -> None:
    end = monotonic() + 60
    while not condition():
        assert monotonic() < end
        sleep(0.01)


def test_an_answer_after_an_edit_is_that_of_the_new_text_alone() -> None:
    found: list[Message] = []
    worker = AnalysisWorker(found.append)
    worker.start()
    session = Session(PROGRAM, environ={})
    worker.ask((NODES, PROBLEMS), session.snapshot())
    until(lambda: len(found) == 1)
    session.edit(0, 0, b"create_node 'other' as other\n")
    worker.ask((NODES, PROBLEMS), session.snapshot())
    until(lambda: len(found) == 2)
    worker.stop()
    worker.join(5)
    last = found[-1]
    assert isinstance(last, Analysed)
    alone = Session(session.document.text, environ={})
    assert last.analysis.diagnostics == alone.diagnostics
    assert last.analysis.workspace == alone.workspace
    assert last.analysis.written_at(0) == "other"
    assert last.analysis.written_at(session.document.text.index(b"generate_node")) == "talker"
    assert [entry.text for entry in last.analysis.made[NODES].all] == ["other", "talker"]


def test_what_is_no_longer_shown_is_let_go() -> None:
    found: list[Message] = []
    worker = AnalysisWorker(found.append)
    worker.start()
    session = Session(PROGRAM, environ={})
    worker.ask((), session.snapshot())
    until(lambda: len(found) == 1)
    first = found[0]
    assert isinstance(first, Analysed)
    seen = weakref.ref(first.analysis)
    session.edit(0, 0, b"\n")
    worker.ask((), session.snapshot())
    until(lambda: len(found) == 2)
    found.clear()
    del first
    until(lambda: seen() is None)
    worker.stop()
    worker.join(5)


def test_nobody_waits_for_what_is_let_go() -> None:
    analysis = analyse(Session(MANY, environ={}), lambda: None)
    seen = weakref.ref(analysis)
    discarded = Discarded()
    discarded.add(analysis)
    del analysis
    assert seen() is None
    steps: list[None] = []
    discarded.let_go(lambda: len(steps) == 2 or bool(steps.append(None)))
    assert len(steps) == 2
    discarded.let_go(lambda: bool(steps.append(None)))
    assert len(steps) == 2 + 6
    discarded.let_go(lambda: pytest.fail("nothing is left"))


def test_the_entries_of_what_stands_before_an_edit_are_not_made_again() -> None:
    found: list[Message] = []
    worker = AnalysisWorker(found.append)
    worker.start()
    session = Session(MANY, environ={})
    for number in range(1, 4):
        worker.ask((NODES,), session.snapshot())
        until(lambda number=number: len(found) == number)
        last = session.document.text.rindex(b"create")
        session.edit(last, last, b"\n")
    worker.stop()
    worker.join(5)
    before, now = (each.analysis.made[NODES].all for each in found[1:])
    assert [each.text for each in before] == [each.text for each in now]
    assert before[0] is now[0] and before[-1] is not now[-1]


def test_an_answer_about_a_text_that_was_edited_is_given_up() -> None:
    found: list[Message] = []
    worker = AnalysisWorker(found.append)
    session = Session(PROGRAM, environ={})
    worker.ask((NODES,), session.snapshot())
    worker.interrupt()
    worker.start()
    until(lambda: worker.is_idle)
    assert not found
    worker.ask((NODES,), session.snapshot())
    until(lambda: bool(found))
    worker.stop()
    worker.join(5)


def test_a_newer_text_ends_the_look_at_an_older_one() -> None:
    class Newer(Exception):  # noqa: N818 - no error
        pass

    beats: list[None] = []

    def pulse() -> None:
        beats.append(None)
        if len(beats) == 3:
            raise Newer

    lines = (b"create_node 'n%d' as n%d\n" % (n, n) for n in range(2_000))
    session = Session(b"".join(lines), environ={})
    with pytest.raises(Newer):
        session.interpret(pulse)
    assert len(session.interpret(pulse).workspace.nodes) == 2_000
    assert len(beats) > 5


class Cycle:
    """What only the collector can let go: it holds itself."""

    def __init__(self) -> None:
        self.own = self


@pytest.fixture
def seldom() -> Iterator[None]:
    """The collector as the studio sets it for its process."""
    thresholds = gc.get_threshold()
    collector.look_seldom()
    yield
    gc.set_threshold(*thresholds)


@pytest.mark.usefixtures("seldom")
def test_garbage_is_let_go_when_nobody_asks_for_a_while(monkeypatch: pytest.MonkeyPatch) -> None:
    """Textual leaves cycles behind at each drawing; the collector waits for its hour."""
    monkeypatch.setattr(module, "_REST", 0.05)
    monkeypatch.setattr(collector, "DUE", 3)
    made: list[weakref.ref[Cycle]] = []
    worker = AnalysisWorker(lambda _: made.append(weakref.ref(Cycle())))
    worker.start()
    session = Session(PROGRAM, environ={})
    for count in range(1, 9):
        session.edit(0, 0, b"\n")
        worker.ask((NODES,), session.snapshot())
        until(lambda count=count: len(made) == count)
    until(lambda: all(each() is None for each in made))
    worker.stop()
    worker.join(5)


def test_what_an_analysis_did_not_ask_for_is_there_for_the_next_one() -> None:
    first = PartMemo()
    assert first.once("a", lambda: 1) == first.once("a", lambda: 2) == 1
    first.forget()
    # One that was given up before it had asked for everything.
    second = PartMemo(first)
    third = PartMemo(second)
    assert third.once("a", lambda: 3) == 1
    second.forget()
    assert PartMemo(second).once("a", lambda: 4) == 4
