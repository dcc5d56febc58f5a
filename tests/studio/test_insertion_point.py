"""Where a statement goes that is written for somebody."""

from __future__ import annotations

import pytest

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.session import Session
from plastron_tui.studio.insertion_point import Ground, is_generated_last, placed

HEAD = b"create_node 'one' as a\nsubscribe a to 'x' of message_type String\n"


@pytest.mark.parametrize(
    ("rest", "last"),
    [
        (b"", None),
        (b"generate_node a\n", b"generate_node a"),
        (b"generate_node a\n// a is done\n", b"generate_node a"),
        (b"generate_node a // and what of a ?\n", b"generate_node a"),
        (b"generate_node a\ncreate_node 'a' as b\n", b"generate_node a"),
        (b"generate_node a\n"
         b"create_message a1 of message_type Bool and input True\n", b"generate_node a"),
        (b"generate_node a\nunsubscribe a from 'x'\n", None),
        (b"generate_node a\nunsubscribe\ta\tfrom 'x'\n", None),
        (b"generate_node a\n"
         b"subscribe a to 'y' of message_type Bool\n"
         b"  generate_node\ta // again\n", b"generate_node\ta"),
    ],
)  # fmt: skip
def test_whether_a_node_is_generated_after_all_that_is_done_with_it(
    rest: bytes, last: bytes | None
) -> None:
    session = Session(HEAD + rest, environ={})
    span = is_generated_last(session.program, session.workspace, "a")
    assert (None if span is None else (HEAD + rest)[span.start : span.end]) == last


SUBSCRIBE = b"subscribe a to 'y' of message_type String\n"
NEW = b"unsubscribe a from 'x'"
SPEAK = b"a publish m to 'y' of message_type Bool"
MESSAGE = b"create_message m of message_type Bool and input True\n"


@pytest.mark.parametrize(
    ("rest", "node", "new", "text"),
    [
        (b"", "a", NEW, b"%b\n"),
        (b"generate_node a\n", "a", NEW, b"%b\ngenerate_node a\n"),
        (b"generate_node a", "a", NEW, b"%b\ngenerate_node a"),
        (b"\tgenerate_node\ta // a\n", "a", NEW, b"%b\n\tgenerate_node\ta // a\n"),
        (b"generate_node a\n", None, NEW, b"generate_node a\n%b\n"),
        (b"generate_node a // a", None, NEW, b"generate_node a // a\n%b\n"),
        (b"generate_node a\n  \n", None, NEW, b"generate_node a\n%b\n  \n"),
        (b"generate_node a  \n", None, NEW, b"generate_node a\n%b\n  \n"),
        # A line that begins within a remark is no place for a statement.
        (b"/*\n*/ generate_node a\n", "a", NEW, b"/*\n*/ generate_node a\n%b\n"),
        # What a statement names has to be there; a word that only looks like it has not.
        (MESSAGE + b"generate_node a\n", "a", SPEAK, MESSAGE + b"%b\ngenerate_node a\n"),
        (b"generate_node a\n" + MESSAGE, "a", SPEAK, b"generate_node a\n" + MESSAGE + b"%b\n"),
        (b"generate_node a\n" + MESSAGE, "a",
         b"subscribe a to 'z' of message_type Bool calling m",
         b"%b\ngenerate_node a\n" + MESSAGE),
    ],
)  # fmt: skip
def test_a_statement_goes_where_it_takes_effect(
    rest: bytes, node: str | None, new: bytes, text: bytes
) -> None:
    session = Session(HEAD + rest, environ={})
    ground = Ground(session.document, session.program, session.workspace)
    placing = placed(ground, node, [new.decode()])
    edit = placing.edit
    assert session.document.text == HEAD + rest
    session.edit(edit.span.start, edit.span.end, edit.text.encode())
    assert session.document.text == HEAD + text.replace(b"%b", new)
    assert [session.document.text[start:end] for start, end in placing.spans] == [new]


@pytest.mark.parametrize("rest", [b"", b"generate_node a\n"])
def test_what_has_to_follow_something_goes_behind_it(rest: bytes) -> None:
    session = Session(HEAD + rest + SUBSCRIBE, environ={})
    ground = Ground(session.document, session.program, session.workspace)
    after = session.program.statements[-1].span
    placing = placed(ground, "a", ["unsubscribe a from 'y'"], late=["generate_node a"], after=after)
    assert placing.lines == ("unsubscribe a from 'y'", "generate_node a")
    assert placing.edit.span.start == after.end


def test_an_empty_program_has_room_for_a_statement() -> None:
    session = Session(b" \n\t", environ={})
    ground = Ground(session.document, session.program, session.workspace)
    placing = placed(ground, None, ["create_node 'a' as a"], is_apart=True)
    assert placing.edit == Edit(Span(0, 3), "create_node 'a' as a\n")


ROBOT = b"create_robot 'r' as r\n"
LINK = b"r has_link 'arm'"


@pytest.mark.parametrize(
    ("rest", "text"),
    [
        (b"", b"%b\n"),
        (b"create_node 'n' as n\n", b"%b\ncreate_node 'n' as n\n"),
        (b"r has_link 'base' // the root\ncreate_node 'n' as n\n",
         b"r has_link 'base' // the root\n%b\ncreate_node 'n' as n\n"),
        (b"generate_robot r\ncreate_node 'n' as n\n",
         b"%b\ngenerate_robot r\ncreate_node 'n' as n\n"),
        # Within a remark nothing takes effect.
        (b"/*\n*/ r has_link 'b' /*\n*/\ncreate_node 'n' as n\n",
         b"/*\n*/ r has_link 'b' /*\n*/\ncreate_node 'n' as n\n%b\n"),
    ],
)  # fmt: skip
def test_what_is_said_of_a_robot_stays_together(rest: bytes, text: bytes) -> None:
    session = Session(ROBOT + rest, environ={})
    ground = Ground(session.document, session.program, session.workspace)
    edit = placed(ground, "r", [LINK.decode()]).edit
    session.edit(edit.span.start, edit.span.end, edit.text.encode())
    assert session.document.text == ROBOT + text.replace(b"%b", LINK)
