"""What a session makes is let go by its reference counts: nothing waits for the cycle collector."""

from __future__ import annotations

import gc
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.graph import graph_of
from plastron_tui.output.graphs import FORMATS, render
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.targets import read_source

PROGRAM = "".join(
    f"create_node 'node_{i}' as node{i}\n"
    f"subscribe node{i} to 'heard' of message_type String\n"
    f"generate_node nobody{i}\n"
    for i in range(200)
).encode()

NODES = sorted(Path(__file__).parent.joinpath("nodes").glob("ros*/*.py"))[::6]


def interpret(_: Path) -> None:
    session = Session(PROGRAM, environ={})
    for text in (b"\n", b"$\n"):
        session.edit(0, 0, text)
        assert session.diagnostics


def create(folder: Path) -> None:
    text = b"""\
create_node 'talker' as talker
create_message text of message_type String and input "hello"
talker publish text to 'chatter' of message_type String
talker provides_service 'add' of service_type AddTwoInts
generate_node talker
"""
    plan, found = Session(text, folder / "a.plastron", Options(output=folder), environ={}).plan()
    assert not found
    assert write(plan) is not None


def change(folder: Path) -> None:
    """Load hand-written nodes, change them, and bring one half to the other client library."""
    for number, node in enumerate(NODES):
        library = ("rospy", "rclpy")[number % 2]
        text = f"""\
load '{node}' as loaded
subscribe loaded to 'heard' of message_type String
unsubscribe loaded from 'chatter'
generate_node loaded using {library}
load '{node.stem}_sub' as again
load nowhere as lost
"""
        session = Session(text.encode(), folder / "b.plastron", Options(output=folder), environ={})
        session.edit(0, 0, b"\n")
        assert session.diagnostics
        session.edit(0, 1, b"")
        session.plan()


def change_in_place(folder: Path) -> None:
    node = folder / "talker.py"
    node.write_bytes(NODES[0].read_bytes())
    text = b"load talker as t\nsubscribe t to 'heard' of message_type String\ngenerate_node t\n"
    session = Session(text, folder / "c.plastron", Options(in_place=True), environ={})
    for _ in range(2):
        write(session.plan()[0])
        session.files_changed()


def inspect(_: Path) -> None:
    for node in NODES:
        assert read_source(node, one(node.read_bytes())).source is not None


def draw(_: Path) -> None:
    graph = graph_of(Session(PROGRAM[:1_000], environ={}).workspace)
    # The standard library's encoder of JSON, where it indents, is functions that hold each other.
    for format_ in set(FORMATS) - {"json"}:
        assert render(graph, format_)


@pytest.mark.long
@pytest.mark.parametrize(
    "work",
    [interpret, create, change, change_in_place, inspect, draw],
    ids=lambda each: each.__name__,
)
def test_nothing_waits_for_the_collector(tmp_path: Path, work: Callable[[Path], None]) -> None:
    # What is made once and kept, and what imports leave behind, is no part of it.
    work(tmp_path)
    gc.collect()
    gc.disable()
    gc.set_debug(gc.DEBUG_SAVEALL)
    try:
        work(tmp_path)
        gc.collect()
        garbage = Counter(getattr(each, "__qualname__", str(type(each))) for each in gc.garbage)
    finally:
        gc.set_debug(0)
        gc.garbage.clear()
        gc.enable()
    assert not garbage
