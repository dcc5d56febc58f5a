from __future__ import annotations

import pytest
from textual.app import App, ComposeResult

from plastron_tui.studio.panels.bars import Bar, help_pieces

HELP = "create_message MESSAGE of message_type TYPE and input ‹VALUES›   the values of it"


class Host(App[None]):
    CSS = "Bar { height: 1; }"

    def compose(self) -> ComposeResult:
        yield Bar(id="status")


@pytest.mark.parametrize(
    ("width", "text", "shown"),
    [
        (
            90,
            HELP,
            " create_message MESSAGE of message_type TYPE and input VALUES   the values of it",
        ),
        (80, HELP, " create_message … message_type TYPE and input VALUES   the values of it"),
        (60, HELP, " create_message … input VALUES   the values of it"),
        (40, HELP, " create_message … VALUES   the va… 1:2"),
        (40, "a ‹part› of a long line about a statement", " a part of a long line about a st… 1:2"),
        (40, "a statement starts with create_node, load", " a statement starts with create_n… 1:2"),
    ],
)
async def test_the_part_at_hand_stays_in_sight(width: int, text: str, shown: str) -> None:
    async with Host().run_test(size=(width, 3)) as pilot:
        bar = pilot.app.query_one(Bar)
        bar.show(help_pieces(text), (("1:2", "quiet"),))
        assert bar.render_line(0).text.removesuffix(" ").removesuffix("1:2").rstrip(" ") in shown
        assert bar.render_line(0).text.endswith("1:2 ")
