"""The rows of the problems: the mistake, its remedy, and other places that explain it."""

from __future__ import annotations

from plastron_tui.session import Session
from plastron_tui.studio.analysis import analyse
from plastron_tui.studio.panels.problems import make, without

TEXT = b"""\
create_node 'a' as same
// in between
create_node 'b' as same
subscribe same to 'c' of message_type Sring
"""


def test_each_place_that_explains_a_mistake_has_a_row_of_its_own() -> None:
    analysis = analyse(Session(TEXT, environ={}), lambda: None)
    entries = make(analysis, None)
    exists, remedy, first, unknown, *_ = entries.all
    assert exists.text == "a node `same` exists already"
    assert remedy.part_of == exists.key
    assert (first.text, first.detail, first.depth) == ("first created here", "line 1", 1)
    assert first.whole == first.key, "it is gone to by itself"
    assert entries.at(TEXT.index(b"'a'")) == first
    assert not unknown.depth

    held = [found for found in analysis.diagnostics if found.message == exists.text]
    assert without(entries, held).all == entries.all[entries.all.index(unknown) :]
    assert without(entries, analysis.diagnostics).all == ()
