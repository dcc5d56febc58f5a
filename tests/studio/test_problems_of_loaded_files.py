"""What breaks rules in the files that a program loads, in the panel of problems."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import studio

TALKER = """\
import rospy
from std_msgs.msg import String

rospy.init_node('talker')
pub = rospy.Publisher('chatter', String{})
rospy.spin()
"""
PROGRAM = "load talker as t\nsubscribe t to 'orders' of message_type String\ngenerate_node t\n"
ROWS = [
    "▲ the publisher has no `queue_size`: `publish` waits for every subscriber talker.py:5 · RC407",
    "= add `queue_size=10`",
]


@pytest.fixture
def loaded(tmp_path: Path) -> Path:
    (tmp_path / "talker.py").write_text(TALKER.format(""))
    (tmp_path / "a.plastron").write_text(PROGRAM)
    return tmp_path / "a.plastron"


async def test_a_problem_of_a_loaded_file_is_shown_until_it_is_mended(loaded: Path) -> None:
    async with studio(loaded) as driver:
        await driver.show("problems")
        assert driver.shown("problems") == ROWS
        driver.main.look_at_disk()
        loaded.with_name("talker.py").write_text(TALKER.format(", queue_size=10"))
        driver.main.look_at_disk()
        await driver.until(lambda: driver.shown("problems") == [])


async def test_what_the_project_ignores_is_not_shown(loaded: Path) -> None:
    loaded.with_name("plastron.yaml").write_text("lint: {ignore: RC407}\n")
    async with studio(loaded) as driver:
        await driver.show("problems")
        assert driver.shown("problems") == []


async def test_a_program_that_loads_it_no_more_has_no_problem_of_it(loaded: Path) -> None:
    async with studio(loaded) as driver:
        await driver.show("problems")
        assert driver.shown("problems") == ROWS
        loaded.write_text("create_node 'arm' as arm\n")
        driver.main.look_at_disk()
        await driver.until(lambda: driver.shown("problems") == [])
