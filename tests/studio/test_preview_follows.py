"""The preview shows the line that the statement at the cursor becomes."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import studio

from plastron_tui.session import Options, Session
from plastron_tui.studio.analysis import analyse
from plastron_tui.studio.panels.preview import previews_of

PROGRAM = """\
create_node 'talker' as talker
create_message m of message_type String and input "hello"
talker publish m to 'chatter' of message_type String at 2 hz
subscribe talker to 'other' of message_type String
talker has_parameter 'speed' of parameter_type float with default 0.5
generate_node talker
"""


LINES = {
    "rclpy": ["super().__init__(", None, "create_publisher(String", "create_subscription(String",
              "declare_parameter(", None],
    "rospy": ["rospy.init_node(", None, "rospy.Publisher(", "rospy.Subscriber(", "~speed", None],
    "roscpp": ["ros::init(", None, "advertise<", "subscribe(", "speed", None],
    "rclcpp": ["class TalkerNode", None, "create_publisher<", "create_subscription<", "speed",
               None],
}  # fmt: skip


@pytest.mark.parametrize("library", LINES)
def test_a_statement_is_known_to_become_a_line(library: str) -> None:
    session = Session(PROGRAM.encode(), None, Options(target=library))
    (preview, *_) = previews_of(analyse(session, lambda: None), "talker")
    at = 0
    for text, code in zip(PROGRAM.splitlines(keepends=True), LINES[library], strict=True):
        found = preview.line_at(at)
        at += len(text)
        assert (found is None) == (code is None), text
        if found is not None and code is not None:
            assert code in "".join(piece.text for piece in preview.lines[found - 1])


async def test_the_preview_follows_the_cursor(tmp_path: Path) -> None:
    path = tmp_path / "talk.plastron"
    path.write_text(PROGRAM)
    async with studio(path, (80, 24)) as driver:
        await driver.show("preview")
        panel = driver.main.panels["preview"]
        view = panel._view
        driver.main.editor.focus()
        await driver.press("ctrl+home", "down", "down", "down")
        await driver.until(lambda: view.scroll_offset.y > 0)

        def shown() -> list[str]:
            rows = range(view.scrollable_content_region.height)
            return [view.render_line(row).text.rstrip() for row in rows]

        (marked,) = [row for row in shown() if "▸" in row]
        assert "rospy.Subscriber" in marked
        # A message becomes no line of its own; what was read stays in sight.
        top = view.scroll_offset.y
        await driver.press("up", "up")
        assert not any("▸" in row for row in shown()) and view.scroll_offset.y == top
        await driver.press("up")
        assert any("▸" in row and "init_node" in row for row in shown())
