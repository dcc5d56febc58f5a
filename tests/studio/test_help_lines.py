"""Help is broken so that all of it can be read, and begins with the keys."""

from __future__ import annotations

import pytest

from plastron_tui.studio.actions import ACTIONS
from plastron_tui.studio.panels.styles import Line
from plastron_tui.studio.screens.help import Help
from plastron_tui.studio.screens.help_lines import action_lines, key_lines, statement_lines


def texts(lines: object) -> list[str]:
    return ["".join(piece.text for piece in line) for line in lines]  # type: ignore[attr-defined]


@pytest.mark.parametrize("width", [40, 64, 92])
def test_no_line_is_wider_than_the_room(width: int) -> None:
    keys = {action.id: "Ctrl-Shift-X" for action in ACTIONS}
    what = "Write the statement that ends it: unsubscribe, stop_publishing, …"
    lines: list[Line] = [*key_lines([("Delete d", what)], width), *action_lines(keys, width)]
    found = texts([*lines, *statement_lines(width)])
    assert [line for line in found if len(line) > width] == []
    said = " ".join(" ".join(found).split())
    for action in ACTIONS:
        assert action.title in said and action.help.rstrip(".") in said
    assert what in said
    assert "subscribe VARIABLE to 'TOPIC_NAME' of message_type MESSAGE_TYPE" in said


def test_keys_come_first_and_statements_last() -> None:
    rows = texts(Help("editor", [("F2 r", "Rename")], {"run": "F5"}).lines(70))
    assert rows[:2] == ["Keys here", "  F2 r          Rename"]
    assert rows.index("Studio") < rows.index("Edit") < rows.index("Statements")
    assert "Statements" not in texts(Help("nodes", [], {}).lines(70))
    assert "  F5            Run: Write and start the nodes; while they run, stop" in rows
