"""What is interpreted anew from a checkpoint is what the whole program means."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.diagnostics import has_errors
from plastron_tui.model import checkpoint
from plastron_tui.session import Session

_PROGRAM = """\
create_node 'talker' as talker using rclpy
create_node 'listener' as listener using rclpy
create_message text of message_type String and input "hello"
create_message point of message_type Point and input 1, 2, z=3
create_message speed of message_type Twist and input linear.x=1, angular.z=2
talker publish text to 'chatter' of message_type String at 2 hz
subscribe talker to 'heard' of message_type String
subscribe listener to 'chatter' of message_type String calling hear
talker has_parameter 'rate' of parameter_type float with default 2
generate_node talker
listener publish point to 'place' of message_type Point
talker provides_service 'add' of service_type AddTwoInts
listener client_requests 'add' of service_type AddTwoInts with input 1, 2
talker repeats tick at 5 hz
talker renames topic 'chatter' to 'news'
listener renames topic 'chatter' to 'news'
unsubscribe talker from 'heard'
generate_node listener using rclpy
create_node 'mover' as mover managed using rclpy
mover publish speed to 'cmd_vel' of message_type Twist at 3 hz
generate_node mover
listener publish text to '~/loud' of message_type String
talker stop_publishing to 'news'
generate_node talker
create_package 'demo' as demo
demo contains talker
create_message_type Mark with float64 x
Mark has_field "float64 y"
generate_package demo
""".splitlines(keepends=True)
_LINES = st.sampled_from(
    [
        *_PROGRAM,
        "\n",
        "talker publish text to 'heard' of message_type String\n",
        "subscribe talker to 'place' of message_type String\n",
        "create_message old of message_type Time and input 1, 2\n",
        "create_node 'rover' as rover using rospy\n",
        "subscribe lost to 'x' of message_type String\n",
        "unsubscribe listener from 'chatter'\n",
        "create_node 'talker' as\n",
        "$\n",
    ]
)
_AT = st.integers(0, len(_PROGRAM))


@st.composite
def _edits(draw: st.DrawFn) -> list[tuple[int, int, list[str]]]:
    """Make edits that are near each other, as somebody writes who thinks of one thing."""
    place = draw(_AT)
    near = st.integers(max(0, place - 1), place + 1)
    edit = st.tuples(near, st.sampled_from([0, 0, 1, 2]), st.lists(_LINES, max_size=2))
    return draw(st.lists(edit, min_size=2, max_size=8))


@pytest.fixture(autouse=True, scope="module")
def _checkpoints_everywhere() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(checkpoint, "_BEFORE", 1)
        patch.setattr(checkpoint, "_LEAST", 1)
        yield


def _edit(session: Session, line: int, count: int, new: list[str]) -> None:
    lines = session.document.text.decode().splitlines(keepends=True)
    start = len("".join(lines[:line]).encode())
    end = start + len("".join(lines[line : line + count]).encode())
    session.edit(start, end, "".join(new).encode())


def _as_alone(session: Session, earlier: Session) -> Session:
    """Return a snapshot that has learnt, and means what a session means that has not."""
    snapshot = session.snapshot()
    snapshot.learn_from(earlier)
    alone = Session(snapshot.document.text, environ={})
    assert snapshot.diagnostics == alone.diagnostics
    assert snapshot.workspace == alone.workspace
    return snapshot


@settings(max_examples=examples(30), deadline=None)
@given(_AT, _edits())
def test_a_program_means_the_same_whether_it_was_interpreted_from_a_checkpoint(
    length: int, edits: list[tuple[int, int, list[str]]]
) -> None:
    path = Path("nowhere", "program.plastron")
    session = Session("".join(_PROGRAM[: length + 3]).encode(), path, environ={})
    snapshots = [session.snapshot()]
    assert snapshots[0].workspace is not None
    for line, count, new in edits:
        _edit(session, line, count, new)
        snapshot = session.snapshot()
        snapshot.learn_from(snapshots[-1])
        _ = snapshot.diagnostics
        snapshots.append(snapshot)
        # What was found out before is not touched: it may be on the screen.
        for each in snapshots[-3:]:
            alone = Session(each.document.text, path, environ={})
            assert each.diagnostics == alone.diagnostics
            assert each.workspace == alone.workspace
            assert each.interpret().own_types == alone.interpret().own_types


_BEGIN = _PROGRAM[:8]
_TEXTS = "talker publish text to 'q' of message_type String\n"
_POINTS = "listener publish point to 'q' of message_type Point\n"


@pytest.mark.parametrize(
    ("begin", "ends"),
    [
        pytest.param(_BEGIN, ["\n", _TEXTS, _POINTS], id="a topic is free again"),
        pytest.param(
            [*_BEGIN, _TEXTS, _PROGRAM[8]],
            ["\n", "talker stop_publishing to 'q'\n", _POINTS],
            id="a topic is in use again",
        ),
        pytest.param(_BEGIN, ["".join(_PROGRAM[24:26]), "\n"], id="a node is in no package"),
        pytest.param(
            [*_BEGIN, *_PROGRAM[24:]], ["\n", "\n", "demo contains listener\n"], id="a package"
        ),
        pytest.param(
            _BEGIN,
            ["\n", "\n", "unsubscribe talker from 'heard'\n", "generate_node talker\n"],
            id="a node is as it was",
        ),
        pytest.param(
            ["subscribe late to 'x' of message_type String\n", *_BEGIN],
            ["\n", "\n", "create_node late as\n", "\n"],
            id="a broken line counts for what stands before it",
        ),
    ],
)
def test_what_was_written_at_the_end_before_counts_no_longer(
    begin: list[str], ends: list[str]
) -> None:
    session = Session("".join([*begin, "\n"]).encode(), environ={})
    earlier = session.snapshot()
    assert earlier.workspace.nodes
    for end in ends:
        _edit(session, len(begin), 1, [end])
        earlier = _as_alone(session, earlier)


_CLEAN = [*_PROGRAM[:20], *_PROGRAM[22:24]]
_WARNED = [*_CLEAN, "listener provides_service 'add' of service_type AddTwoInts\n"]


@pytest.mark.parametrize(
    ("program", "are_moved"),
    [
        pytest.param(_CLEAN, True, id="nodes"),
        pytest.param([*_CLEAN, *_PROGRAM[24:]], False, id="a package"),
        pytest.param(_WARNED, False, id="a warning"),
    ],
)
def test_statements_that_stand_elsewhere_mean_the_same(program: list[str], are_moved: bool) -> None:
    for line in range(0, len(program) + 1, 2):
        session = Session("".join(program).encode(), environ={})
        earlier = session.snapshot()
        assert not has_errors(earlier.diagnostics)
        for new in ("$\n", "é", "# ä\n"):
            _edit(session, line, 0, [new])
            earlier = _as_alone(session, earlier)
        assert (earlier.interpret().learnt.workspace is not None) == are_moved


@pytest.mark.parametrize("line", [1, 11, 16])
def test_what_was_behind_the_end_of_a_program_is_gone(line: int) -> None:
    session = Session("".join(_CLEAN).encode(), environ={})
    earlier = session.snapshot()
    assert earlier.diagnostics == ()
    comment = ["# ä\n"]
    for at, count, new in (
        *((line, 0, comment), (line, 0, comment), (line, 0, comment)),
        *((line - 1, 99, []), (line - 1, 0, comment), (0, 99, []), (0, 0, comment)),
    ):
        _edit(session, at, count, new)
        earlier = _as_alone(session, earlier)


def test_statements_before_a_checkpoint_are_not_run_again() -> None:
    session = Session("".join(_PROGRAM[:20]).encode(), environ={})
    earlier = session.snapshot()
    assert earlier.diagnostics
    for _ in range(3):
        _edit(session, 18, 0, ["#\n"])
        snapshot = session.snapshot()
        snapshot.learn_from(earlier)
        known, nodes = earlier.interpret().learnt.checkpoint, snapshot.workspace.nodes
        kept = [name for name, node in nodes.items() if node is earlier.workspace.nodes[name]]
        earlier = snapshot
    assert known is not None and len(known.statements) >= 14
    assert snapshot.interpret().learnt.checkpoint is known
    assert "talker" in kept
