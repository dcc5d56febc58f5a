"""What was interpreted before is gone on with only where all else is as it was then."""

from __future__ import annotations

import pytest
from workspaces import LIBRARIES, FakeReader, catalog

from plastron_tui.language import Document, lower
from plastron_tui.model import checkpoint
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import interpret

_NODE = """\
create_node 'n{0}' as n{0}
subscribe n{0} to 'topic_{0}' of message_type Int32
generate_node n{0}
"""
_PROGRAM = "".join(map(_NODE.format, range(4)))
_SETTING = Setting("rospy", LIBRARIES, catalog, FakeReader(), program="robot")


@pytest.mark.parametrize(
    ("setting", "is_same"),
    [
        (_SETTING, True),
        (_SETTING._replace(library="rclpy"), False),
        (_SETTING._replace(is_chosen=not _SETTING.is_chosen), False),
        (_SETTING._replace(program="another"), False),
        (_SETTING._replace(libraries=dict(LIBRARIES)), True),
        (_SETTING._replace(libraries={"rospy": LIBRARIES["rospy"]}), False),
    ],
)
def test_another_setting_begins_anew(
    monkeypatch: pytest.MonkeyPatch, setting: Setting, is_same: bool
) -> None:
    monkeypatch.setattr(checkpoint, "_BEFORE", 1)
    monkeypatch.setattr(checkpoint, "_LEAST", 1)
    program = lower(Document(_PROGRAM.encode()))
    learnt = interpret(program, _SETTING).learnt
    learnt = interpret(program, _SETTING, learnt).learnt
    assert learnt.checkpoint is not None
    found, alone = interpret(program, setting, learnt), interpret(program, setting)
    assert found.workspace == alone.workspace
    assert found.diagnostics == alone.diagnostics
    assert (found.learnt.checkpoint is learnt.checkpoint) == is_same
