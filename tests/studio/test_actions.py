from __future__ import annotations

import sys
from contextlib import nullcontext
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import PROGRAM, SIZES, Driver, fail, studio
from textual import events
from textual.widgets import Button, Label

from plastron_tui.studio.actions import ACTIONS, BY_ID
from plastron_tui.studio.config import config_file
from plastron_tui.studio.editor.commands import BY_NAME
from plastron_tui.studio.main import edit_config
from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.panels.registry import PANELS
from plastron_tui.studio.screens.themes import ThemeMenu


def test_every_action_is_one_of_the_screen_the_app_or_the_editor() -> None:
    for action in ACTIONS:
        if action.own:
            name = action.call.partition("'")[2].rstrip("')")
            assert name in BY_NAME, action
        elif action.call.startswith("screen."):
            name = action.call.removeprefix("screen.").partition("(")[0]
            assert hasattr(MainScreen, f"action_{name}"), action


def test_no_key_has_two_actions() -> None:
    keys = [key for action in ACTIONS for key in action.keys.split(",") if key]
    assert len(keys) == len(set(keys))


async def test_the_registry_names_the_keys_that_the_editor_binds(program: Path) -> None:
    async with studio(program) as driver:
        bound: dict[str, set[str]] = {}
        for key, bindings in driver.main.editor._bindings.key_to_bindings.items():
            for binding in bindings:
                bound.setdefault(binding.id, set()).add(key)
        for action in ACTIONS:
            if action.own:
                wanted = set(action.keys.replace("ctrl+space", "ctrl+@").split(","))
                assert wanted & bound[action.id], action.id


async def test_keys_are_remapped_and_a_bad_configuration_is_said(program: Path, home: Path) -> None:
    config_file().parent.mkdir(parents=True)
    config_file().write_text(
        "theme: nord\nkeys:\n  generate: f11\n  generat: f12\n  graph.size: z\n"
        "width: 3\nmouse: perhaps\n"
    )
    async with studio(program) as driver:
        assert driver.app.theme == "nord"
        assert driver.main.styles.background.hex6 == driver.app.current_theme.background
        for said in ("line 4: no action `generat`; did you mean `generate`?",
                     "line 6: no setting `width`",
                     "line 7: `mouse` has a value that it cannot have"):  # fmt: skip
            assert said in driver.notes()
        assert "graph.size" not in driver.notes()
        await driver.press("alt+6", "z")
        assert "size: " in driver.notes()
        # What shows keys shows those that work.
        await driver.press("escape")
        assert "F5 Run  F11 Generate  F7 Panels" in driver.main.query_one("KeyBar").text
        await driver.press("f1")
        await driver.pilot.press("f1")
        dialog = await driver.dialog("Help")
        assert "F11" in next(
            x for x in dialog.query_one("TextView").text.splitlines() if "Show what would" in x
        )
        await driver.pilot.press("escape")
        await driver.back()
        await driver.press("escape")
        assert "F11 Generate" in driver.main.query_one("KeyBar").text
        await driver.pilot.press("f11")
        await driver.dialog("GenerateDialog")


@pytest.mark.parametrize("text", ["[", "- 1\n", "\0", "keys: [a]\n", "theme: 3\n"])
async def test_a_broken_configuration_is_said_and_defaults_count(program: Path, text: str) -> None:
    config_file().parent.mkdir(parents=True)
    config_file().write_text(text)
    async with studio(program, (80, 24)) as driver:
        assert "studio.yaml" in driver.notes()
        assert driver.text == PROGRAM


async def test_all_mistakes_in_the_settings_can_be_read_and_gone_to(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    config_file().parent.mkdir(parents=True)
    config_file().write_text("".join(f"wrong_{number}: 1\n" for number in range(7)))
    async with studio(program) as driver:
        assert "no setting `wrong_4`" in driver.notes()
        assert "… and 2 more: Alt-O lists those of the settings" in driver.notes()
        await driver.pilot.press("alt+o")
        dialog = await driver.dialog("LineList")
        rows = dialog.query_one("#dialog-places").options
        assert str(rows[-1].prompt) == "7  no setting `wrong_6`"
        monkeypatch.setenv("EDITOR", "nano -w")
        monkeypatch.setattr(driver.app, "suspend", nullcontext)
        opened: list[object] = []
        monkeypatch.setattr(edit_config, "run_editor", lambda *args: opened.extend(args))
        await driver.pilot.press("end", "enter")
        await driver.until(lambda: "settings count from the next start" in driver.notes())
        await driver.until(lambda: opened == [["nano", "-w"], config_file(), 7])


async def test_the_theme_and_the_layout_are_remembered(program: Path) -> None:
    async with studio(program) as driver:
        driver.app.theme = "gruvbox"
        await driver.show("topics")
        await driver.press("alt+plus")
        await driver.pilot.press("ctrl+q")
        await driver.until(lambda: driver.app._exit)
        width = driver.main.dock_layout.sizes["outline"]
    async with studio(program) as driver:
        assert driver.app.theme == "gruvbox"
        assert driver.main.styles.background.hex6 == driver.app.current_theme.background
        assert driver.main.dock_layout.outline.active == "topics"
        assert driver.main.dock_layout.sizes["outline"] == width
        assert driver.main.dock_layout.outline.size.width == width


@pytest.mark.parametrize(
    ("size", "docks"),
    [
        ((200, 60), {"outline", "result", "bottom"}),
        pytest.param((120, 40), {"outline", "bottom"}, marks=pytest.mark.long),
        ((80, 24), {"outline"}),
        pytest.param((60, 20), {"outline"}, marks=pytest.mark.long),
        pytest.param((40, 10), set(), marks=pytest.mark.long),
        ((20, 5), set()),
    ],
)
async def test_the_panels_follow_the_size_of_the_window(
    program: Path, size: tuple[int, int], docks: set[str]
) -> None:
    async with studio(program, (120, 40)) as driver:
        await driver.pilot.resize_terminal(*size)
        all_docks = driver.main.dock_layout.docks
        await driver.until(lambda: {dock.id for dock in all_docks if dock.display} == docks)
        assert driver.main.editor.view.size.height >= 1
        await driver.type("// x\n")
        for name in ("graph", "problems", "preview", "nodes"):
            driver.main.action_show(name)
            await driver.settle()
            assert driver.main.dock_layout.is_in_sight(name)


async def test_panels_are_hidden_enlarged_and_left(program: Path) -> None:
    async with studio(program) as driver:
        main = driver.main
        await driver.press("f9")
        assert not any(dock.display for dock in main.dock_layout.docks)
        await driver.press("f9")
        assert main.dock_layout.outline.display
        await driver.show("graph")
        await driver.press("ctrl+t")
        assert main.dock_layout.result.size.width == 120
        assert not main.editor.display
        await driver.press("escape")
        assert main.editor.view.has_focus
        assert main.dock_layout.result.size.height < 30


@pytest.mark.parametrize("size", [*SIZES, pytest.param((200, 60), marks=pytest.mark.long)])
async def test_f7_goes_through_all_panels(program: Path, size: tuple[int, int]) -> None:
    async with studio(program, size) as driver:
        seen = set()
        for _ in range(len(PANELS) + 1):
            await driver.press("f7")
            focused = driver.main.focused
            assert focused is not None
            if focused is driver.main.editor.view:
                break
            seen.add(driver.main.dock_layout.focused_dock.id)
        assert seen == {"outline", "result", "bottom"}


async def test_keys_reach_the_editor_whatever_is_said_of_the_focus(program: Path) -> None:
    async with studio(program) as driver:
        driver.main.set_focus(None)
        driver.app.post_message(events.AppBlur())
        await driver.press("x", "y")
        assert driver.text == f"xy{PROGRAM}"
        driver.app.post_message(events.AppBlur())
        await driver.pilot.pause()
        chosen: list[str | None] = []
        driver.app.push_screen(ThemeMenu(["one", "two"], "one", lambda _: None), chosen.append)
        await driver.dialog("ThemeMenu")
        await driver.pilot.press("down", "enter")
        await driver.until(lambda: chosen == ["two"])


async def test_help_is_about_what_has_the_focus(program: Path) -> None:
    async with studio(program) as driver:
        await driver.press("f1")
        card = driver.main.editor.view.card.card
        assert card is not None
        assert card.title == "create_node"
        await driver.pilot.press("f1")
        dialog = await driver.dialog("Help")
        assert "create_node 'NODE_NAME' as VARIABLE" in dialog.query_one("TextView").text
        await driver.pilot.press("escape")
        await driver.back()
        await driver.show("nodes")
        await driver.press("f1")
        dialog = await driver.dialog("Help")
        assert "Delete writes" in str(dialog.query_one("#dialog-text", Label).content)


async def test_the_tour_goes_around(tmp_path: Path) -> None:
    async with studio(None, welcome=True) as driver:
        await driver.dialog("Welcome")
        await driver.pilot.press("down", "down", "down", "enter")
        dialog = await driver.dialog("Tour")
        titles = []
        while driver.app.screen is dialog:
            titles.append(str(dialog.query_one("#dialog-title", Label).content))
            await driver.settle()
            assert dialog.query_one("#dialog-keys").size.height == 1
            await driver.pilot.press("enter")
            await driver.pilot.pause()
        assert len(titles) == len(set(titles)) == 6
        await driver.back()
        assert "listener" in driver.text
        assert driver.app.profile.remembered.toured


@pytest.mark.parametrize("size", mostly_long([(80, 24), (120, 40), (200, 50)], [(80, 24)]))
async def test_the_tour_does_not_hide_what_it_is_about(
    program: Path, size: tuple[int, int]
) -> None:
    async with studio(program, size) as driver:
        driver.main.action_tour()
        dialog = await driver.dialog("Tour")
        for panel in [None, "nodes", "preview", "graph", "problems", None]:
            await driver.settle()
            if panel is not None:
                about, card = driver.main.dock_layout.dock_of(panel), dialog.query_one("#tour")
                await driver.until(
                    lambda about=about, card=card: not about.region.overlaps(card.region)
                )
            await driver.pilot.press("enter")
        await driver.back()


async def test_the_status_line_helps_with_the_statement(program: Path) -> None:
    async with studio(program) as driver:
        status = driver.main.query_one("#status")
        assert "create_node" in status.text
        assert status.text.endswith("1:1")
        driver.main.editor.go_to(PROGRAM.index("'chatter'") + 3)
        await driver.settle()
        assert "'TOPIC_NAME'" in status.text
        assert any(tone == "here" and text == "'TOPIC_NAME'" for text, tone in status.left)


async def test_an_error_of_plastrons_own_is_shown_and_the_text_is_kept(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from plastron_tui.studio import analysis

    async with studio(program) as driver:
        monkeypatch.setattr(analysis, "analyse", fail)
        await driver.pilot.press("x")
        dialog = await driver.failure(b"x" + PROGRAM.encode())
        await driver.pilot.press("c")
        assert driver.app.clipboard == dialog.report
        await driver.pilot.press("escape")
        await driver.until(lambda: driver.app.screen is driver.main)
        await driver.pilot.press("y")
        assert driver.text == "xy" + PROGRAM


async def write(driver: Driver) -> None:
    await driver.pilot.press("f6")
    dialog = await driver.dialog("GenerateDialog")
    await driver.pilot.press("enter")
    await driver.until(lambda: dialog.is_written)


@pytest.mark.parametrize("size", SIZES)
async def test_generate_shows_then_writes_then_says_how_to_run(
    program: Path, size: tuple[int, int]
) -> None:
    output = program.parent / "output"
    async with studio(program, size) as driver:
        await driver.pilot.press("f6")
        dialog = await driver.dialog("GenerateDialog")
        assert [file.state.value for file in dialog.plan.files] == ["create", "create"]
        assert not output.exists()
        await driver.pilot.press("enter")
        await driver.until(lambda: dialog.is_written)
        assert sorted(file.name for file in output.glob("*.py")) == [
            "listener_sub1.py",
            "talker_pub.py",
        ]
        assert "plastron run" in str(dialog.query_one("#dialog-text", Label).content)
        assert [file.state.value for file in dialog.plan.files] == ["identical", "identical"]
        await driver.pilot.press("escape")
        await driver.back()


async def test_generate_leaves_what_was_changed_by_hand(program: Path) -> None:
    async with studio(program) as driver:
        await write(driver)
        await driver.pilot.press("escape")
        await driver.back()
        file = program.parent / "output" / "talker_pub.py"
        file.write_text("print('mine')\n")
        await driver.pilot.press("f6")
        dialog = await driver.dialog("GenerateDialog")
        assert dialog.plan.files[0].state.value == "conflict"
        assert "-print('mine')" in dialog.query_one("TextView").text
        await driver.pilot.press("enter")
        assert file.read_text() == "print('mine')\n"
        assert dialog.query_one("#force", Button).display
        await driver.pilot.click("#force")
        await driver.until(lambda: dialog.is_written)
        assert file.with_name("talker_pub.py.bak").read_text() == "print('mine')\n"
        assert "rospy" in file.read_text()


async def test_generate_with_a_mistake_shows_the_problems(program: Path) -> None:
    program.write_text(PROGRAM + "generate_node nobody\n")
    async with studio(program) as driver:
        await driver.press("f6")
        await driver.until(lambda: driver.main.panels["problems"].has_focus)
        assert "1 problem has to be fixed first" in driver.notes()


async def test_the_preview_of_a_changed_file_is_its_diff(program: Path) -> None:
    async with studio(program) as driver:
        await write(driver)
        await driver.pilot.press("escape")
        await driver.back()
        driver.main.action_show("preview")
        at = PROGRAM.index("hello")
        driver.main.editor.go_to(at)
        driver.main.editor.type_text("well, ")
        await driver.settle()
        await driver.until(lambda: "+" in driver.main.panels["preview"].text)
        assert '"well, hello"' in driver.main.panels["preview"].text
        driver.main.panels["preview"].action_toggle_diff()
        assert driver.main.panels["preview"].text.startswith("#!/usr/bin/env python3")


async def test_run_shows_what_the_nodes_print_and_stops(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = program.parent / "stand_in.py"
    script.write_text(
        "import sys, time\n"
        "print('talker | hello', flush=True)\n"
        "try:\n    time.sleep(60)\nexcept KeyboardInterrupt:\n    print('bye')\n"
    )
    wrapper = program.parent / "python"
    # What ends the nodes with the studio is a script of its own.
    wrapper.write_text(
        f'#!/bin/sh\ncase "$1" in *guard.py) exec "{sys.executable}" "$@";; esac\n'
        f'exec "{sys.executable}" "{script}"\n'
    )
    wrapper.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(wrapper))
    async with studio(program) as driver:
        # Twice at once is a slip of the finger, and starts the nodes once.
        await driver.pilot.press("f5", "f5")
        await driver.until(lambda: "talker | hello" in driver.main.panels["output"].text)
        assert driver.main.runner.is_running
        assert driver.main.dock_layout.is_in_sight("output")
        assert "running" in driver.main.query_one("#title").text
        await driver.app.run_call(BY_ID["stop"].call)
        await driver.until(lambda: not driver.main.runner.is_running)
        assert "bye" in driver.main.panels["output"].text
