"""Actions, timers, parameters and quality of service in the panels, and what is done to them."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import SIZES, Driver, studio

from plastron_tui.studio.panels.registry import counts

ROBOT = """\
create_node 'driver' as driver managed using rclpy
driver has_parameter 'speed' of parameter_type float with default 0.5 between 0.1 and 2
driver has_parameter 'names' of parameter_type string_list with default ["a", "b"]
create_message go of message_type Twist and input linear.x=parameter 'speed' * 2
driver publish go to 'cmd_vel' of message_type Twist at parameter 'speed' hz with qos depth 5
subscribe driver to 'scan' of message_type LaserScan with qos sensor_data
driver publish go to 'back' of message_type Twist for_each 'scan'
driver repeats blink at 2 hz
driver provides_action 'count' of action_type Fibonacci

create_node 'asker' as asker using rclpy
asker sends_goal to 'count' of action_type Fibonacci with input 5
asker has_parameter 'speed' of parameter_type int with default 1
"""
ENTRIES = {
    "nodes": [
        "● driver rclpy · managed",
        "↑ cmd_vel geometry_msgs/Twist · depth 5",
        "↑ back geometry_msgs/Twist",
        "↓ scan sensor_msgs/LaserScan · sensor_data",
        "★ count example_interfaces/Fibonacci",
        "↻ blink 2 Hz",
        "= speed float · 0.5 · 0.1 to 2",
        '= names string_list · ["a", "b"]',
        "● asker rclpy",
        "☆ count example_interfaces/Fibonacci",
        "= speed int · 1",
    ],
    "services": [
        "★ /count example_interfaces/Fibonacci",
        "★ driver action server",
        "☆ asker action client",
    ],
}


@pytest.fixture
def robot(program: Path) -> Path:
    program.write_text(ROBOT)
    return program


@pytest.mark.parametrize("size", SIZES)
async def test_panels_show_what_else_a_node_does(robot: Path, size: tuple[int, int]) -> None:
    async with studio(robot, size) as driver:
        # Actions are counted with services.
        assert counts(driver.main.open.analysis)["services"] == 1
        for name, entries in ENTRIES.items():
            await driver.show(name)
            assert driver.shown(name) == entries, name
        await driver.show("topics")
        assert "↓ driver subscription · sensor_data" in driver.shown("topics")
        assert "↑ driver publisher · depth 5" in driver.shown("topics")
        await driver.show("graph")
        assert "/count" in driver.main.panels["graph"].text


async def go_to(driver: Driver, panel: str, text: str) -> None:
    driver.main.action_show(panel)
    await driver.settle()
    await driver.press("home", *["down"] * driver.shown(panel).index(text))


ENDED = {
    ENTRIES["nodes"][4]: "driver stop_action 'count'",
    ENTRIES["nodes"][5]: "driver stop_repeating blink",
    ENTRIES["nodes"][7]: "driver no_longer_has_parameter 'names'",
    ENTRIES["nodes"][9]: "asker stop_goal to 'count'",
}


async def take_back(driver: Driver, text: str) -> None:
    """Undo what was done to an entry; it was one step."""
    driver.main.editor.undo()
    await driver.settle()
    assert driver.text == text


async def test_what_an_entry_shows_is_ended_by_a_statement(robot: Path) -> None:
    async with studio(robot) as driver:
        for entry, statement in ENDED.items():
            await go_to(driver, "nodes", entry)
            await driver.press("delete")
            assert statement in driver.text.splitlines()
            assert not driver.main.open.analysis.diagnostics, statement
            await take_back(driver, ROBOT)


# The panel, the entry's row in it, the old and the new name, and the lines that have it.
RENAMED = [
    ("nodes", 4, "'count'", "sum", [8, 11]),
    ("nodes", 9, "'count'", "sum", [8, 11]),
    ("services", 0, "'count'", "sum", [8, 11]),
    ("nodes", 6, "'speed'", "v", [1, 3, 4]),
    ("nodes", 10, "'speed'", "v", [12]),
    ("nodes", 3, "'scan'", "laser", [5, 6]),
]


@pytest.mark.parametrize("library", ["rclpy", "rospy"])
async def test_actions_and_parameters_get_other_names(robot: Path, library: str) -> None:
    text = ROBOT.replace("rclpy", library).replace(" managed", "")
    text = text.replace(" with qos sensor_data", "")
    robot.write_text(text)
    before = text.splitlines()
    async with studio(robot) as driver:
        for panel, row, old, new, lines in RENAMED:
            await driver.show(panel)
            await driver.press("home", *["down"] * row)
            await driver.pilot.press("f2")
            await driver.dialog("Prompt")
            await driver.pilot.press(*new, "enter")
            await driver.back()
            changed = [
                line.replace(old, f"'{new}'") if number in lines else line
                for number, line in enumerate(before)
            ]
            assert driver.text.splitlines() == changed, (panel, row)
            assert not driver.main.open.analysis.diagnostics, (panel, row)
            await take_back(driver, text)


async def test_a_message_that_two_nodes_send_has_one_name_of_a_parameter(robot: Path) -> None:
    robot.write_text(ROBOT + "asker publish go to 'mine' of message_type Twist\n")
    async with studio(robot) as driver:
        await go_to(driver, "nodes", ENTRIES["nodes"][6])
        await driver.pilot.press("f2")
        await driver.dialog("Prompt")
        await driver.pilot.press("v", "enter")
        await driver.back()
        assert "'speed'" not in driver.text
        assert not driver.main.open.analysis.diagnostics


async def test_a_timer_is_not_renamed(robot: Path) -> None:
    async with studio(robot) as driver:
        await go_to(driver, "nodes", ENTRIES["nodes"][5])
        bound = driver.main.active_bindings.values()
        offered = {each.binding.action for each in bound if each.enabled}
        assert "ask('rename')" not in offered and "ask('end')" in offered
