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
    ("width", "shown"),
    [
        (90, "create_message MESSAGE of message_type TYPE and input VALUES   the values of it"),
        (80, "create_message … of message_type TYPE and input VALUES   the values of it"),
        (60, "create_message … and input VALUES   the values of it"),
        (40, "create_message … VALUES   the val…"),
    ],
)
async def test_the_part_at_hand_stays_in_sight(width: int, shown: str) -> None:
    async with Host().run_test(size=(width, 3)) as pilot:
        bar = pilot.app.query_one(Bar)
        bar.show(help_pieces(HELP), (("1:2", "quiet"),))
        assert bar.render_line(0).text == f" {shown}".ljust(width - 4) + "1:2 "
