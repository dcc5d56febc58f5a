"""Nodes of the wizard, run from the wizard, on a real ROS 2."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from machine import domain_id
from wizard_courses import MAKE, REACT, SEND
from wizard_driver import wizard_from_welcome

pytestmark = pytest.mark.live

HAS_ROS2 = (
    subprocess.run([sys.executable, "-c", "import rclpy, std_msgs.msg"], capture_output=True)
).returncode == 0
HEARD = "chatter: std_msgs.msg.String(data='hello')"


@pytest.mark.skipif(
    not HAS_ROS2 and not os.environ.get("CI"), reason="ROS 2 is missing: ./dev setup dev"
)
@pytest.mark.long
async def test_run_from_the_wizard_shows_the_message_arriving(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With every suggestion accepted, from nothing to the message in the output panel."""
    monkeypatch.setenv("ROS_DOMAIN_ID", domain_id())
    monkeypatch.setenv("ROS_LOG_DIR", str(here / "log"))
    async with wizard_from_welcome() as it:
        driver = it.driver
        await it.pick(MAKE)
        await it.press("enter")
        assert it.statements == ("create_node 'talker' as talker",)
        await it.pick(SEND)
        await it.finish()
        await it.pick("something more")
        await it.go(MAKE, REACT)
        await it.finish()
        await it.pick("run the nodes")
        await driver.dialog("ChooseFile")
        await it.type("two")
        await driver.pilot.press("enter")
        output = driver.main.panels["output"]
        await driver.until(lambda: f"listener | [INFO] {HEARD}" in output.text)
        # What travels is in sight, and has the keys: who comes from the wizard types nothing.
        await driver.until(lambda: driver.main.dock_layout.is_in_sight("live"))
        await driver.until(lambda: driver.main.focused is driver.main.panels["live"])
        await driver.app.run_call("screen.stop")
        await driver.until(lambda: "stopped" in output.text)
