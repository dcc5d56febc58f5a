from __future__ import annotations

import pytest
from textual.app import App, ComposeResult

from plastron_tui.studio.panels.bars import Bar, help_pieces

LAST = "create_message MESSAGE of message_type TYPE and input ‹VALUES›   the values of it"
FIRST = (
    "‹VARIABLE› publish MESSAGE to 'TOPIC_NAME' [at RATE hz] [with qos QOS]   the node that sends"
)
MIDDLE = (
    "VARIABLE publish MESSAGE to 'TOPIC_NAME' of message_type TYPE [at RATE ‹hz› | once | "
    "for_each …] [with qos …]   Let a node send a message to a topic: at a rate, once, or so"
)


class Host(App[None]):
    CSS = "Bar { height: 1; }"

    def compose(self) -> ComposeResult:
        yield Bar(id="status")


@pytest.mark.parametrize(
    ("help_", "width", "shown"),
    [
        (
            LAST,
            90,
            "create_message MESSAGE of message_type TYPE and input VALUES   the values of it",
        ),
        (LAST, 80, "create_message … of message_type TYPE and input VALUES   the values of it"),
        (LAST, 60, "create_message … and input VALUES   the values of it"),
        (LAST, 40, "create_message … and input VALUES…"),
        (FIRST, 100, FIRST.replace("‹", "").replace("›", "")),
        (
            FIRST,
            80,
            "VARIABLE publish MESSAGE to 'TOPIC_NAME' [at RATE …   the node that sends",
        ),
        (FIRST, 40, "VARIABLE …   the node that sends"),
        (FIRST, 30, "VARIABLE …   the node t…"),
        (MIDDLE, 76, "VARIABLE … [at RATE hz | once | for_each …   Let a node send a messag…"),
    ],
)
async def test_the_part_at_hand_stays_in_sight(help_: str, width: int, shown: str) -> None:
    async with Host().run_test(size=(width, 3)) as pilot:
        bar = pilot.app.query_one(Bar)
        bar.show(help_pieces(help_), (("1:2", "quiet"),))
        assert bar.render_line(0).text == f" {shown}".ljust(width - 4) + "1:2 "
