"""How often a node does something is changed by saying it anew."""

from __future__ import annotations

from pathlib import Path

import pytest
from wizard_courses import MORE, REPEAT, applied, course, form_after, to_menu_or_review

from plastron_tui.session import Session

CREATED = """\
create_node 'blinker' as blinker
blinker repeats blink at 2 hz
generate_node blinker
"""
LOADED = "load 'blinker.py' as blinker\ngenerate_node blinker\n"
FILE = """\
import rclpy
from rclpy.node import Node


class Blinker(Node):
    def __init__(self):
        super().__init__("blinker")
        self.timer = self.create_timer(0.5, self.blink)

    def blink(self):
        self.get_logger().info("on")


def main():
    rclpy.init()
    rclpy.spin(Blinker())
"""


@pytest.mark.parametrize(
    ("program", "lines"),
    [
        (CREATED, ["blinker repeats blink at 10 hz"]),
        (LOADED, ["blinker stop_repeating blink", "blinker repeats blink at 10 hz"]),
    ],
)
def test_a_timer_that_is_there_gets_another_rate(
    program: str, lines: list[str], tmp_path: Path
) -> None:
    (tmp_path / "blinker.py").write_text(FILE)
    it = course(program, tmp_path)
    form = form_after(it, MORE, REPEAT)
    filled = it.look().of(form)
    assert filled is not None
    assert [each.text for each in it.choices(filled, "function", None, "")] == ["blink"]
    form.enter("function", "blink")
    look = to_menu_or_review(it)
    assert look.problems == () and look.outcome is not None
    text = applied(program.encode(), look.outcome.edits).decode()
    assert [each for each in text.splitlines() if "repeat" in each] == lines
    session = Session(text.encode(), tmp_path / "program.plastron", environ={})
    assert session.diagnostics == ()
