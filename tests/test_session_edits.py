"""What a session learns from an earlier text is what it would find out alone."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from plastron_tui.session import Session

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
    ["talker", "listener", "text", "'chatter'", "Point", "1", '"', "x=", " ", "é"]
)


@st.composite
def edits(draw: st.DrawFn) -> tuple[float, float, str]:
    return draw(st.floats(0, 1)), draw(st.sampled_from([0.0, 0.01, 0.1])), draw(LINES | WORDS)


def _boundary(text: bytes, share: float) -> int:
    at = min(len(text), round(share * len(text)))
    while 0 < at < len(text) and text[at] & 0xC0 == 0x80:
        at -= 1
    return at


@settings(max_examples=100, deadline=None)
@given(st.lists(LINES, max_size=25), st.lists(edits(), min_size=1, max_size=8))
def test_what_is_learnt_from_an_earlier_text_changes_nothing(
    lines: list[str], found: list[tuple[float, float, str]]
) -> None:
    path = Path("nowhere", "program.plastron")
    session = Session("".join([*PROGRAM, *lines]).encode(), path, environ={})
    earlier = session.snapshot()
    assert earlier.diagnostics
    for at, length, new in found:
        text = session.document.text
        session.edit(_boundary(text, at), _boundary(text, at + length), new.encode())
        snapshot = session.snapshot()
        snapshot.learn_from(earlier)
        alone = Session(session.document.text, path, environ={})
        assert snapshot.diagnostics == alone.diagnostics
        assert snapshot.workspace == alone.workspace
        earlier = snapshot
