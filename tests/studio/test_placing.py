"""Where a statement goes that is written for somebody."""

from __future__ import annotations

import pytest

from plastron_tui.session import Session
from plastron_tui.studio.placing import is_generated_last, placed

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


@pytest.mark.parametrize(
    ("rest", "node", "text"),
    [
        (b"", "a", HEAD + b"// new\n"),
        (b"generate_node a\n", "a", HEAD + b"// new\ngenerate_node a\n"),
        (b"\tgenerate_node\ta // a\n", "a", HEAD + b"// new\n\tgenerate_node\ta // a\n"),
        (b"generate_node a\n", None, HEAD + b"generate_node a\n// new\n"),
        (b"generate_node a // a", None, HEAD + b"generate_node a // a\n// new\n"),
    ],
)
def test_a_statement_goes_where_it_takes_effect(rest: bytes, node: str | None, text: bytes) -> None:
    session = Session(HEAD + rest, environ={})
    edit = placed(HEAD + rest, session.workspace, node, "// new")
    session.edit(edit.span.start, edit.span.end, edit.text.encode())
    assert session.document.text == text
