"""Messages that come back to where they came from."""

from __future__ import annotations

import pytest
from workspaces import marked, run

from plastron_tui.diagnostics import Severity

START = """\
create_node 'a' as a
create_node 'b' as b
create_message m of message_type String and input "x"
create_message n of message_type String and input "y"
"""

# Who hears what and sends what, and which of them close a circle.
CIRCLES: list[tuple[list[str], list[str]]] = [
    (["a x x"], ["a x x"]),
    (["a x /x"], ["a x /x"]),
    (["a x up/x"], []),
    (["a x y"], []),
    (["a x y", "b y z"], []),
    (["a x y", "b y x"], ["b y x"]),
    (["b y x", "a x y"], ["a x y"]),
    (["a x y", "b y z", "a z x", "b x w"], ["a z x"]),
    (["a x y", "a y z", "b y x", "b z y"], ["b y x", "b z y"]),
    (["a x y when", "b y x"], []),
    (["a up/x /down/x", "b /down/x /up/x"], ["b /down/x /up/x"]),
]


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize(("reactions", "closing"), CIRCLES)
def test_a_circle_is_told_where_it_closes(
    reactions: list[str], closing: list[str], library: str
) -> None:
    text, said = START, {}
    heard = set()
    for each in reactions:
        node, trigger, topic, *when = each.split()
        if (node, trigger) not in heard:
            heard.add((node, trigger))
            text += f"subscribe {node} to '{trigger}' of message_type String\n"
        line = f"{node} publish m to '{topic}' of message_type String for_each '{trigger}'"
        said[line + (' when received.data = "go"' if when else "")] = each
        text += f"{[*said][-1]}\n"
    found = run(text, library).diagnostics
    assert {each.code for each in found} <= {"endless-messages"}
    assert {each.severity for each in found} <= {Severity.WARNING}
    assert [said[marked(text, each)] for each in found] == closing
