"""What a session learns from an earlier text is what it would find out alone."""

from __future__ import annotations

import gc
from pathlib import Path
from weakref import ref

from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

TALKER = b"""\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker
"""

PROGRAM = """\
create_node 'talker' as talker
create_node 'listener' as listener using rclpy
create_message text of message_type String and input "hällo"
create_message point of message_type Point and input 1, 2, x=3
create_message twist of message_type Twist and input linear=(1, 2, 3), angular.z="fast"
talker publish text to 'chatter' of message_type String at 2 hz
talker publish text to 'chatter' of message_type String
listener publish twist to 'speed' of message_type Twist
subscribe listener to 'chatter' of message_type Point
listener client_requests 'clear' of service_type Empty with input 1
talker provides_service 'clear' of service_type Empty
unsubscribe talker from 'chatter'
generate_node talker
talker stop_publishing to 'chatter'
generate_node listener
load nowhere as lost
generate_node lost
""".splitlines(keepends=True)
LINES = st.sampled_from(
    [*PROGRAM, "\n", "create_node 'x' as\n", "subscribe talker too 'a'\n", "$\n"]
)
WORDS = st.sampled_from(
    ["talker", "listener", "text", "'chatter'", "Point", "1", '"', "x=", " ", "é", ",", "(", "-"]
)
INPUTS = st.sampled_from(
    [
        "none", "1", "-1", "300", "2.5", '"a"', '"3"', "True", "1, 2", "1, 2, 3", "x=1, y=2",
        "y=True", "z=1, z=2", "(1, 2, 3)", "(1, 2, 3), (0, 0, 1)", "linear=(1, 2, 3)",
        "linear.x=1, angular.z=2",
        "linear.w=1", "[]", "[1, 2.5, 3]", "[(1, 2, 3), (4, 5)]", "data=[1, -2]", "data=1e400",
        "header.frame_id=\"map\", pose.position=(1, 2, 3)", "a=5, b=6", "5, 6", "((1", "x=",
    ]
)  # fmt: skip
TYPES = st.sampled_from(
    [
        "String",
        "Int8",
        "Float64",
        "Bool",
        "Point",
        "Twist",
        "PoseStamped",
        "Polygon",
        "Empty",
        "Float64MultiArray",
        "geometry_msgs/msg/Point",
        "Strng",
        "Duration",
        "Image",
    ]
)


@st.composite
def values(draw: st.DrawFn) -> str:
    """Make a line that is all about its values; names and types come again, as they do."""
    if draw(st.booleans()):
        type_ = draw(st.sampled_from(["AddTwoInts", "SetBool", "Empty", "Trigger", "Trigge"]))
        node = draw(st.sampled_from(["talker", "listener"]))
        name = draw(st.sampled_from("abc"))
        inputs = draw(INPUTS)
        return f"{node} client_requests '{name}' of service_type {type_} with input {inputs}\n"
    variable = draw(st.sampled_from(["m1", "m2", "m3", "m4", "m5", "m6"]))
    made = f"create_message {variable} of message_type {draw(TYPES)} and input {draw(INPUTS)}\n"
    node, type_ = draw(st.sampled_from(["talker", "listener"])), draw(TYPES)
    sent = (
        f"{node} publish {variable} to '{draw(st.sampled_from('xyz'))}' of message_type {type_}\n"
    )
    return draw(st.sampled_from([made, made + sent]))


@st.composite
def edits(draw: st.DrawFn) -> tuple[float, float, str]:
    return (
        draw(st.floats(0, 1)),
        draw(st.sampled_from([0.0, 0.01, 0.1])),
        draw(LINES | WORDS | values() | INPUTS),
    )


def _boundary(text: bytes, share: float) -> int:
    at = min(len(text), round(share * len(text)))
    while 0 < at < len(text) and text[at] & 0xC0 == 0x80:
        at -= 1
    return at


def _place(text: bytes, first: float, last: float, *, is_line: bool) -> tuple[int, int]:
    """Return what an edit replaces: lines by a line, and within one line by a word."""
    start, end = _boundary(text, first), _boundary(text, last)
    if is_line:
        return text.rfind(b"\n", 0, start) + 1, text.rfind(b"\n", 0, end) + 1
    newline = text.find(b"\n", start, end)
    return start, end if newline < 0 else newline


@settings(max_examples=examples(100), deadline=None)
@given(st.lists(LINES | values(), max_size=25), st.lists(edits(), min_size=1, max_size=8))
def test_what_is_learnt_from_an_earlier_text_changes_nothing(
    lines: list[str], found: list[tuple[float, float, str]]
) -> None:
    path = Path("nowhere", "program.plastron")
    session = Session("".join([*PROGRAM, *lines]).encode(), path, environ={})
    earlier = session.snapshot()
    assert earlier.diagnostics
    for at, length, new in found:
        text = session.document.text
        session.edit(*_place(text, at, at + length, is_line=new.endswith("\n")), new.encode())
        snapshot = session.snapshot()
        snapshot.learn_from(earlier)
        alone = Session(session.document.text, path, environ={})
        assert snapshot.diagnostics == alone.diagnostics
        assert snapshot.workspace == alone.workspace
        earlier = snapshot


def test_a_snapshot_never_asks_the_session_that_is_edited_meanwhile(tmp_path: Path) -> None:
    """A program that loads what it generates: the loader asks for text, targets and types."""
    text = b"""\
create_node 'a' as a
subscribe a to 'x' of message_type String
generate_node a
load a_sub1 as b
"""
    live = Session(text, tmp_path / "program.plastron", environ={})
    snapshot = live.snapshot()

    def asked(*_: object) -> None:
        raise AssertionError("the snapshot asks the live session")

    for name in ("_rendered", "catalog", "_target", "_generate"):
        setattr(live, name, asked)
    live.edit(0, len(text), b"$")
    assert snapshot.diagnostics == ()
    assert list(snapshot.workspace.nodes) == ["a", "b"]
    assert snapshot.document.text == text


def test_a_snapshot_is_gone_when_nobody_needs_it(tmp_path: Path) -> None:
    """The collector rests while a program is edited: a cycle would keep every interpretation."""
    live = Session("".join(PROGRAM).encode(), tmp_path / "program.plastron", environ={})
    snapshot = live.snapshot()
    assert snapshot.diagnostics
    gone = ref(snapshot)
    gc.disable()
    try:
        del snapshot
        assert gone() is None
    finally:
        gc.enable()


CHANGE = b"""\
load 'talker.py' as talker
subscribe talker to 'heard' of message_type String
generate_node talker
"""


def test_a_renamed_program_is_known_by_the_text_that_it_has_now(tmp_path: Path) -> None:
    """What it wrote under its old name is its own, until the program is another."""
    made = TALKER, tmp_path / "make.plastron", Options(output=tmp_path)
    write(Session(*made, environ={}).plan()[0])
    (tmp_path / "talker_pub.py").rename(tmp_path / "talker.py")
    in_place = Options(in_place=True)
    old = Session(CHANGE, tmp_path / "old.plastron", in_place, environ={})
    assert old.diagnostics == ()
    write(old.plan()[0])

    renamed = Session(CHANGE, tmp_path / "new.plastron", in_place, environ={})
    for text in (CHANGE, CHANGE.replace(b"heard", b"told"), CHANGE):
        renamed.edit(0, len(renamed.document.text), text)
        alone = Session(text, tmp_path / "new.plastron", in_place, environ={})
        assert _starts(renamed) == _starts(alone)
        assert (b"heard" not in _starts(renamed)) == (text == CHANGE)


def _starts(session: Session) -> bytes:
    source = session.workspace.nodes["talker"].source
    assert source is not None
    return source.files.main
