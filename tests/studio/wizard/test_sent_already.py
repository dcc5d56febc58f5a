"""Who lets a loaded node send something more hears what its file sends already."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import MORE, SEND, course, form_after

from plastron_tui.studio.wizard import strings
from plastron_tui.studio.wizard.sent_already import sent_already

FILE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Heart(Node):
    def __init__(self):
        super().__init__("heart")
        self.publisher = self.create_publisher(String, "beat", 10)


def main():
    rclpy.init()
    rclpy.spin(Heart())
"""
SAID = "heart.py sends to `beat` already; this is one more"


@pytest.mark.parametrize(
    ("program", "topic", "said"),
    [
        ("load 'heart.py' as heart\n", "alarm", SAID),
        ("load 'heart.py' as heart\n", "beat", ""),
        ("create_node 'heart' as heart\n", "alarm", ""),
    ],
)
def test_what_a_file_sends_is_said_of_another_topic(
    program: str, topic: str, said: str, tmp_path: Path
) -> None:
    (tmp_path / "heart.py").write_text(FILE)
    it = course(program, tmp_path)
    form = form_after(it, MORE, SEND)
    form.enter("topic", topic)
    look = it.look()
    filled = look.of(form)
    assert filled is not None
    assert sent_already(filled) == said
    assert it.helps(filled)["topic", None].endswith(f"; {SAID}") == bool(said)
    assert (f" {SAID}." in strings.review(look)) == bool(said)
