"""A file that is no program is not shown as one: what it is is said, and what loads it offered."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, studio
from textual.widgets import Input, Label

from plastron_tui.project.other_files import loading_program, other_kind, program_beside

NODE = """\
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("wall_follower")
node.create_publisher(String, "chatter", 10)
rclpy.spin(node)
"""
TWO = """\
import rclpy

rclpy.init()
left = rclpy.create_node("arm")
right = rclpy.create_node("right-arm")
"""
ALIKE = """\
import rclpy

rclpy.init()
one = rclpy.create_node("left_arm")
other = rclpy.create_node("left-arm")
"""
LOADED = "load 'wallbot.py' as wall_follower\n\ngenerate_node wall_follower\n"


@pytest.mark.parametrize(
    ("name", "text", "program", "beside"),
    [
        ("wallbot.py", NODE, LOADED, "wallbot"),
        ("two.py", TWO,
         "load 'two.py' node 'arm' as arm\nload 'two.py' node 'right-arm' as right_arm\n\n"
         "generate_node arm\ngenerate_node right_arm\n", "two"),
        ("alike.py", ALIKE,
         "load 'alike.py' node 'left_arm' as left_arm\n"
         "load 'alike.py' node 'left-arm' as left_arm_2\n\n"
         "generate_node left_arm\ngenerate_node left_arm_2\n", "alike"),
        ("none.py", "print()\n", None, "none"),
        ("it's.py", NODE, None, "it's"),
        ("rover.urdf.xacro", "", "load_robot 'rover.urdf.xacro' as rover\n\ngenerate_robot rover\n",
         "rover"),
        ("up.launch.xml", "", "load_launch 'up.launch.xml' as up\n\ngenerate_launch up\n", "up"),
        ("2.launch", "", "load_launch '2.launch' as loaded_2\n\ngenerate_launch loaded_2\n", "2"),
        ("with.msg", "", "load_type 'with.msg' as loaded_with\n\ngenerate_type loaded_with\n",
         "with"),
        ("package.xml", "", "load_package '.' as my_rover\n\ngenerate_package my_rover\n",
         "my-rover"),
    ],
)  # fmt: skip
def test_a_program_that_loads_a_file(
    name: str, text: str, program: str | None, beside: str, tmp_path: Path
) -> None:
    file = tmp_path / "my-rover" / name
    file.parent.mkdir()
    file.write_text(text)
    kind = other_kind(file)
    assert kind is not None
    made = loading_program(file, kind)
    assert (None if made is None else made.decode()) == program
    assert program_beside(file) == file.with_name(f"{beside}.plastron")


@pytest.mark.parametrize("name", ["a.plastron", "a", "a.txt", "wall.md"])
def test_what_may_be_a_program(name: str) -> None:
    assert other_kind(Path(name)) is None


async def test_a_node_is_loaded_not_opened(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    node = program.with_name("wallbot.py")
    node.write_text(NODE)
    monkeypatch.chdir(program.parent)
    async with studio(Path("wallbot.py"), welcome=True, others=[program]) as driver:
        dialog = await driver.dialog("Question")
        title = str(dialog.query_one("#dialog-title", Label).content)
        assert title == "wallbot.py is Python, not a program"
        assert driver.text == PROGRAM
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.text == LOADED
        assert driver.main.open.path == node.with_suffix(".plastron")
        assert driver.shown("nodes")[0].startswith("● wall_follower")
        assert str(node) not in driver.app.profile.remembered.recent
        # By Ctrl-O the program that is there already comes in front.
        await driver.press("alt+e")
        driver.main.files.open_file(node)
        await driver.dialog("Question")
        await driver.pilot.press("enter")
        await driver.back()
        assert driver.text == LOADED
        assert len(driver.main.program.tabs) == 2
        # A program under such a name could not be opened again.
        await driver.pilot.press("alt+s")
        dialog = await driver.dialog("ChooseFile")
        dialog.query_one(Input).value = "mine.py"
        await driver.pilot.press("enter")
        await driver.until(lambda: "by its name mine.py is Python" in driver.notes())
    assert node.read_text() == NODE
    assert not program.with_name("mine.py").exists()
