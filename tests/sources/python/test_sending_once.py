"""Messages that a loaded node sends once, and what takes them out again."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES
from test_reacting import BACK, made

ONCE = "create_message go of message_type Twist and input none\n"
ONCE += "driver publish go to 'out' of message_type Twist once"
IN_MAIN = """\
import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('driver')
    rclpy.spin(node)


main()
"""
WRITTEN = """\
    out_is_heard = False

    def publish_out():
        \"\"\"Publish to out, once: when somebody listens.\"\"\"
        nonlocal out_is_heard
        was_heard = out_is_heard
        out_is_heard = out_pub.get_subscription_count() > 0
        if was_heard and out_is_heard:
            # A subscription that is there for so long knows this publisher too.
            out_timer.cancel()
            out_pub.publish(Twist())

    out_timer = node.create_timer(0.2, publish_out)
"""


@pytest.mark.parametrize("file", [*FILES, "rclpy function"])
def test_what_is_sent_once_is_taken_out_whole(tmp_path: Path, file: str) -> None:
    text = FILES.get(file, IN_MAIN)
    after, told = made(tmp_path, text, ONCE)
    assert not told
    assert after != text
    assert made(tmp_path, after, BACK) == (text, [])


def test_a_function_of_main_sends_once(tmp_path: Path) -> None:
    after, _ = made(tmp_path, IN_MAIN, ONCE)
    assert WRITTEN in after


def test_what_somebody_added_to_it_stays(tmp_path: Path) -> None:
    after, _ = made(tmp_path, FILES["rclpy class"], ONCE)
    after = after.replace("self.out_is_heard = False\n", "self.out_is_heard = False\n" * 2)
    assert made(tmp_path, after, BACK)[0] == after
