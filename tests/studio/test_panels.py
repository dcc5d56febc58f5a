from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import PROGRAM, SIZES, studio

from plastron_tui.studio.panels.registry import PANELS

ENTRIES = {
    "nodes": ["● talker rospy", "↑ chatter std_msgs/String", "● listener rospy",
              "↓ chatter std_msgs/String"],
    "topics": ["≈ /chatter std_msgs/String", "↑ talker publisher", "↓ listener subscription"],
    "services": [],
    "messages": ["✉ greeting std_msgs/String", 'data = "hello"'],
    "problems": [],
}  # fmt: skip


@pytest.mark.parametrize("size", SIZES)
async def test_each_panel_shows_what_the_text_means(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        for name, entries in ENTRIES.items():
            await driver.show(name)
            assert driver.main.panels[name].has_focus
            assert driver.shown(name) == entries


@pytest.mark.parametrize("size", SIZES)
async def test_the_preview_shows_the_file_of_the_node_at_the_cursor(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        driver.main.action_show("preview")
        await driver.settle()
        assert "rospy.Publisher(" in driver.main.panels["preview"].text
        driver.main.editor.go_to(PROGRAM.index("subscribe"))
        await driver.settle()
        await driver.until(lambda: "rospy.Subscriber(" in driver.main.panels["preview"].text)
        assert driver.main.panels["preview"].current.name == "listener_sub1.py"


@pytest.mark.parametrize("size", SIZES)
async def test_the_graph_is_drawn(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        driver.main.action_show("graph")
        await driver.settle()
        rows = driver.main.panels["graph"].text.split("\n")
        assert rows[1] == " │ talker │────▶│ /chatter │────▶│ listener │"


@pytest.mark.parametrize("size", SIZES)
async def test_an_entry_leads_to_its_statement_and_the_entry_follows_the_cursor(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        await driver.show("nodes")
        await driver.press("end", "enter")
        assert driver.main.editor.cursor_offset == PROGRAM.index("subscribe")
        assert driver.main.editor.view.has_focus
        driver.main.editor.go_to(0)
        await driver.settle()
        assert driver.main.panels["nodes"]._here == "node talker"


@pytest.mark.parametrize(
    ("key", "row", "line"),
    [
        ("delete", 3, "unsubscribe listener from 'chatter'\ngenerate_node listener\n"),
        ("delete", 1, "talker stop_publishing to 'chatter'\ngenerate_node talker\n"),
    ],
)
async def test_what_is_done_to_an_entry_is_a_statement(
    program: Path, key: str, row: int, line: str
) -> None:
    async with studio(program) as driver:
        await driver.show("nodes")
        await driver.press(*["down"] * row, key)
        assert line in driver.text
        await driver.press("ctrl+z")
        assert driver.text == PROGRAM


async def test_an_entry_is_renamed_everywhere(program: Path) -> None:
    async with studio(program) as driver:
        for panel, row, new, count in (
            ("nodes", 0, "speaker", 4),
            ("nodes", 1, "news", 2),
            ("topics", 0, "news", 2),
            ("topics", 2, "news", 2),
            ("messages", 0, "hi", 2),
        ):
            await driver.show(panel)
            await driver.press("home", *["down"] * row)
            await driver.pilot.press("f2")
            await driver.dialog("Prompt")
            await driver.pilot.press(*new, "enter")
            await driver.back()
            assert driver.text.count(new) == count
            assert not driver.main.open.analysis.diagnostics
            driver.main.editor.undo()
            await driver.settle()
            assert driver.text == PROGRAM


async def test_a_problem_is_shown_and_mended(program: Path) -> None:
    program.write_text(PROGRAM.replace("subscribe listener", "subscrib listener"))
    async with studio(program, (80, 24)) as driver:
        driver.main.action_show("problems")
        await driver.settle()
        problem, remedy = driver.shown("problems")
        assert remedy == "= did you mean `subscribe`?"
        assert "line 7" in problem
        await driver.press("f")
        assert driver.text == PROGRAM
        assert driver.shown("problems") == []


async def test_a_topic_that_only_one_side_uses_is_marked(program: Path) -> None:
    program.write_text(PROGRAM.partition("\n\n")[0])
    async with studio(program) as driver:
        driver.main.action_show("topics")
        await driver.settle()
        assert driver.shown("topics")[0].endswith("nobody listens")


async def test_branches_fold(program: Path) -> None:
    async with studio(program) as driver:
        await driver.show("nodes")
        await driver.press("home", "space")
        assert len(driver.shown("nodes")) == 3
        await driver.press("space")
        assert len(driver.shown("nodes")) == 4


async def test_what_is_typed_is_understood(program: Path) -> None:
    async with studio(None, (80, 24)) as driver:
        await driver.type("create_node 'arm' as arm\n")
        driver.main.action_show("nodes")
        await driver.settle()
        assert driver.shown("nodes") == ["● arm rospy does nothing"]


@pytest.mark.parametrize("size", SIZES)
async def test_the_preview_scrolls(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        driver.main.action_show("preview")
        await driver.settle()
        view = driver.main.focused
        assert view.show_vertical_scrollbar
        for key, rows in (("down", 1), ("pagedown", 2), ("end", view.max_scroll_y), ("home", 0)):
            await driver.press(key)
            await driver.until(lambda rows=rows: view.scroll_offset.y >= rows)
        await driver.until(lambda: view.scroll_offset.y == 0)


@pytest.mark.parametrize("size", SIZES)
async def test_help_is_about_the_panel(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        for panel in PANELS:
            await driver.show(panel.name)
            await driver.pilot.press("f1")
            dialog = await driver.dialog("Help")
            assert str(dialog.query_one("#dialog-title").content) == panel.title
            assert str(dialog.query_one("#dialog-text").content) == panel.about
            assert "Back to the editor" in dialog.query_one("TextView").text
            await driver.pilot.press("escape")
            await driver.back()


async def test_a_narrow_panel_says_all_of_a_fix(program: Path) -> None:
    program.write_text(PROGRAM + "listener provides_service 'add' of service_type AddTwoInst\n")
    async with studio(program, (40, 20)) as driver:
        driver.main.action_show("problems")
        await driver.settle()
        panel = driver.main.panels["problems"]
        rows = [panel.render_line(y).text for y in range(4)]
        assert {len(row) for row in rows} == {40}
        assert any(row.rstrip().endswith("⚑ write `AddTwoInts`") for row in rows)
