"""Random keys: what the editor holds and shows is what a fresh one would hold and show."""

from __future__ import annotations

import idle_loop
import pytest
from editor_host import Driver, editing
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as some
from machine import examples

from plastron_tui.language import Document
from plastron_tui.session import Session
from plastron_tui.studio.editor.buffer import Buffer
from plastron_tui.studio.editor.geometry import Geometry
from plastron_tui.studio.editor.highlights import highlight

PROGRAM = """\
create_node 'talker' as talker
/* a comment
over lines */
create_message hello of message_type String and input "h\u00e9llo \u65e5\u672c"
\ttalker publish hello to 'chatter' of message_type String
subscribe talker to
generate_node talker
"""
MOVES = ["up", "down", "left", "right", "home", "end", "pageup", "pagedown", "ctrl+left"]
MOVES += ["ctrl+right", "ctrl+home", "ctrl+end", "shift+down", "shift+right", "ctrl+shift+left"]
EDITS = ["enter", "backspace", "delete", "ctrl+k", "ctrl+d", "alt+up", "alt+down", "ctrl+w"]
EDITS += ["ctrl+underscore", "ctrl+z", "ctrl+y", "ctrl+x", "ctrl+v", "tab", "ctrl+l", "escape"]
TYPED = ["a", "c", "space", "apostrophe", "slash", "asterisk", "quotation_mark", "comma"]
KEYS = some.lists(
    some.one_of(some.sampled_from(MOVES), some.sampled_from(EDITS), some.sampled_from(TYPED)),
    max_size=25,
)


def check_text(at: Driver) -> None:
    """The rows and the tree are those of the text."""
    buffer, text = at.editor.state.buffer, at.editor.text
    text.decode()
    fresh = Buffer(Session(text, environ={}))
    assert [buffer.line_bytes(row) for row in range(buffer.row_count)] == [
        fresh.line_bytes(row) for row in range(fresh.row_count)
    ]
    tree, other = at.editor.session.document.tree, Document(text).tree
    assert str(tree.root_node) == str(other.root_node)
    for row, paint in at.editor.view.painter.paint.items():
        assert paint == highlight(fresh, row, row)[row]
    selection = at.editor.selection
    assert selection == (buffer.clamp(selection.anchor), buffer.clamp(selection.head))


async def check_screen(at: Driver) -> None:
    """Nothing on the screen is left over from before."""
    view = at.editor.view
    assert at.editor.session.document.tree is not None
    view.repaint()
    fresh = Geometry(at.editor.state)
    fresh.marks = view.marks
    fresh.width, fresh.is_wrapped = view.text_width, view.soft_wrap
    fresh.place_lines()
    assert view.geometry.lines.extra == fresh.lines.extra
    await at.pilot.pause()
    shown = at.app.export_screenshot()
    view.painter.paint.clear()
    view.refresh()
    await at.pilot.pause()
    assert at.app.export_screenshot() == shown


async def run(keys: list[str], *, wrap: bool) -> None:
    async with editing(PROGRAM, size=(50, 8)) as at:
        at.editor.view.soft_wrap = wrap
        await at.understand()
        for count, key in enumerate(keys):
            await at.press(key)
            await check_screen(at)
            check_text(at)
            if count % 5 == 4:
                await at.understand()
        while at.editor.state.undo():
            pass
        assert at.editor.text.decode() == PROGRAM


@pytest.mark.long
@given(KEYS, some.booleans())
@settings(
    max_examples=examples(25),
    deadline=None,
    suppress_health_check=list(HealthCheck),
    # To find fewer keys that fail as well takes longer than to read all of them.
    phases=[Phase.explicit, Phase.reuse, Phase.generate],
)
def test_random_keys(keys: list[str], wrap: bool) -> None:
    idle_loop.run(run(keys, wrap=wrap))
