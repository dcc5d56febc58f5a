"""What is done to an entry of a panel, for every kind of entry, created and loaded."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, Driver, studio

SERVICES = """\
create_node 'adder' as adder
adder provides_service 'add' of service_type AddTwoInts
generate_node adder
create_node 'caller' as caller
caller client_requests 'add' of service_type AddTwoInts with input 5, 6
"""
FILE = """\
import rospy
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

def heard(message):
    rospy.loginfo(message.data)

def reset(request):
    return TriggerResponse(True, "")

rospy.init_node('old')
news = rospy.Publisher('status', String, queue_size=1)
rospy.Subscriber('chatter', String, heard)
rospy.Service('reset', Trigger, reset)
go = rospy.ServiceProxy('go', Trigger)
while not rospy.is_shutdown():
    news.publish("fine")
    rospy.sleep(1)
"""
LOADED = "load 'old.py' as old\ngenerate_node old\n"


async def go_to(driver: Driver, panel: str, text: str) -> None:
    """Put the panel's cursor on the first entry that starts with a text."""
    driver.main.action_show(panel)
    await driver.settle()
    rows = driver.shown(panel)
    row = next(at for at, line in enumerate(rows) if line.startswith(text))
    await driver.press("home", *["down"] * row)


async def rename(driver: Driver, new: str) -> None:
    await driver.pilot.press("f2")
    await driver.dialog("Prompt")
    await driver.pilot.press(*new, "enter")
    await driver.back()


ENDED = {
    PROGRAM: [
        ("nodes", "↑ chatter", "talker stop_publishing to 'chatter'\ngenerate_node"),
        ("nodes", "↓ chatter", "unsubscribe listener from 'chatter'\ngenerate_node"),
        ("topics", "↑ talker", "talker stop_publishing to 'chatter'\ngenerate_node"),
    ],
    SERVICES: [
        ("nodes", "◆ add", "adder stop_service 'add'\ngenerate_node adder"),
        ("nodes", "◇ add", "with input 5, 6\ncaller stop_request 'add'\n"),
        ("services", "◆ adder", "adder stop_service 'add'\ngenerate_node adder"),
    ],
}


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("text", ENDED, ids=["topics", "services"])
async def test_an_entry_is_ended(program: Path, size: tuple[int, int], text: str) -> None:
    program.write_text(text)
    async with studio(program, size) as driver:
        for panel, entry, statement in ENDED[text]:
            await go_to(driver, panel, entry)
            await driver.press("delete")
            assert statement in driver.text
            # A node that has nothing left to do is the only thing that can be wrong then.
            assert {found.code for found in driver.main.open.analysis.diagnostics} <= {"idle-node"}
            assert driver.main.editor.view.has_focus
            await driver.press("ctrl+z")
            assert driver.text == text


async def test_what_a_loaded_file_does_is_ended(loaded: Path) -> None:
    async with studio(loaded) as driver:
        for entry, statement in (
            ("↑ status", "old stop_publishing to 'status'"),
            ("↓ chatter", "unsubscribe old from 'chatter'"),
            ("◆ reset", "old stop_service 'reset'"),
            ("◇ go", "old stop_request 'go'"),
        ):
            await go_to(driver, "nodes", entry)
            await driver.press("d")
            assert driver.text == LOADED.replace("generate_node", f"{statement}\ngenerate_node")
            assert driver.main.open.analysis.diagnostics == ()
            assert not any(line.startswith(entry) for line in driver.shown("nodes"))
            driver.main.editor.undo()
            await driver.settle()
            assert driver.text == LOADED


async def test_what_starts_after_the_generation_ends_after_it(program: Path) -> None:
    program.write_text(PROGRAM + "subscribe talker to 'late' of message_type String\n")
    async with studio(program) as driver:
        await go_to(driver, "nodes", "↓ late")
        await driver.press("delete")
        assert driver.text.endswith("\nunsubscribe talker from 'late'\n")


async def test_a_node_is_generated_once(program: Path) -> None:
    program.write_text(PROGRAM.replace("generate_node listener\n", ""))
    async with studio(program) as driver:
        await go_to(driver, "nodes", "↓ chatter")
        await driver.press("g")
        assert driver.text == PROGRAM
        await go_to(driver, "nodes", "● talker")
        await driver.press("g")
        assert driver.text == PROGRAM
        assert driver.main.editor.cursor_offset == PROGRAM.index("generate_node talker")
        assert "talker is generated here" in driver.notes()


async def test_a_loaded_node_is_generated(loaded: Path) -> None:
    loaded.write_text("load 'old.py' as old")
    async with studio(loaded) as driver:
        await go_to(driver, "nodes", "● old")
        await driver.press("g")
        assert driver.text == "load 'old.py' as old\ngenerate_node old\n"


@pytest.mark.parametrize(
    ("entry", "new", "text"),
    [
        ("↓ chatter", "news", "old renames topic 'chatter' to 'news'\n"),
        ("◆ reset", "again", "old renames service 'reset' to 'again'\n"),
        ("↑ status", "state", "old renames topic 'status' to 'state'\n"),
    ],
)
async def test_what_a_loaded_file_has_is_renamed_by_a_statement(
    loaded: Path, entry: str, new: str, text: str
) -> None:
    async with studio(loaded) as driver:
        await go_to(driver, "nodes", entry)
        await rename(driver, new)
        assert driver.text == LOADED.replace("generate_node", f"{text}generate_node")
        assert driver.main.open.analysis.diagnostics == ()
        assert f"{entry[0]} {new} " in "\n".join(driver.shown("nodes"))


async def test_the_variable_of_a_loaded_node_is_renamed(loaded: Path) -> None:
    async with studio(loaded) as driver:
        await go_to(driver, "nodes", "● old")
        await rename(driver, "arm")
        assert driver.text == "load 'old.py' as arm\ngenerate_node arm\n"


async def test_a_node_with_another_variable_gets_another_name(program: Path) -> None:
    program.write_text("create_node 'arm' as left\ngenerate_node left\n")
    async with studio(program) as driver:
        await go_to(driver, "nodes", "● arm")
        await rename(driver, "hand")
        assert driver.text == "create_node 'hand' as left\ngenerate_node left\n"


async def test_a_name_that_cannot_be_is_refused(program: Path) -> None:
    async with studio(program) as driver:
        for panel, entry, new, said in (
            ("nodes", "● talker", "listener", "a node `listener` exists already"),
            ("nodes", "● talker", "a b", "white space"),
            ("topics", "≈ /chatter", "a b", "white space"),
            ("messages", "✉ greeting", "talker", "`talker` is a variable already"),
            ("messages", "✉ greeting", "load", "keyword"),
        ):
            told = len(driver.notes())
            await go_to(driver, panel, entry)
            await driver.pilot.press("f2")
            dialog = await driver.dialog("Prompt")
            dialog.query_one("Input").value = new
            await driver.pilot.press("enter")
            await driver.back()
            assert driver.text == PROGRAM
            assert said in driver.notes()[told:]


MISTAKES = {
    "subscribe listenr to": "subscribe listener to",
    "publish greting to": "publish greeting to",
    "message_type Strin\ngenerate_node l": "message_type String\ngenerate_node l",
    "generat_node talker": "generate_node talker",
}


@pytest.mark.parametrize("size", SIZES)
async def test_a_mistake_is_mended_with_one_key(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        for (wrong, right), keys in product(MISTAKES.items(), (("f",), ("enter", "alt+enter"))):
            driver.main.editor.replace_all(PROGRAM.replace(right, wrong).encode())
            driver.main.editor.go_to(0)
            driver.main.action_show("problems")
            await driver.until(lambda: driver.shown("problems"))
            panel = driver.main.panels["problems"]
            assert any("⚑" in panel.render_line(y).text for y in range(2))
            await driver.press(*keys)
            assert driver.text == PROGRAM
            assert driver.shown("problems") == []


ACTS = ("end", "rename", "generate", "fix")


async def test_only_what_can_be_done_with_an_entry_is_offered(program: Path) -> None:
    program.write_text("nothing\ngenerat_node talker\n" + PROGRAM)
    async with studio(program) as driver:
        for panel, entry, acts in (
            ("nodes", "● listener", {"rename", "generate"}),
            ("nodes", "↓ chatter", {"end", "rename", "generate"}),
            ("topics", "≈ /chatter", {"rename"}),
            ("messages", "✉ greeting", {"rename"}),
            ("messages", "data =", set()),
            ("problems", "✖ `nothing`", set()),
            ("problems", "✖ `generat_node`", {"fix"}),
        ):
            await go_to(driver, panel, entry)
            bound = driver.main.active_bindings.values()
            offered = {each.binding.action for each in bound if each.enabled}
            assert {what for what in ACTS if f"ask('{what}')" in offered} == acts, entry
