from __future__ import annotations

import gc

from plastron_tui.session import Session

PROGRAM = "".join(
    f"create_node 'node_{i}' as node{i}\n"
    f"subscribe node{i} to 'heard' of message_type String\n"
    f"generate_node nobody{i}\n"
    for i in range(200)
).encode()


def test_an_interpretation_is_let_go_without_the_collector() -> None:
    """The studio makes one after every pause in typing, and the collector seldom comes."""
    session = Session(PROGRAM, environ={})
    assert session.diagnostics
    gc.collect()
    gc.disable()
    try:
        for _ in range(3):
            session.edit(0, 0, b"\n")
            assert session.diagnostics
        found = gc.collect()
    finally:
        gc.enable()
    assert found < 200
