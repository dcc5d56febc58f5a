"""The live panel, fed by a monitor that needs no ROS."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from stand_in_nodes import Nodes, asked, live, wait_shown, watch_stand_in
from studio_driver import PROGRAM, studio
from textual import events
from textual.widgets import Label

from plastron_tui.runtime import monitor
from plastron_tui.studio import key_order
from plastron_tui.studio.main import live_actions
from plastron_tui.studio.main.live_actions import LiveActions
from plastron_tui.studio.main.watched_run import WatchedRun
from plastron_tui.studio.panels.key_bar import KeyBar
from plastron_tui.studio.panels.live_row import Kind
from plastron_tui.studio.panels.live_watching import Watching


@pytest.fixture
def orders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file in which the monitor writes down what it is asked."""
    return watch_stand_in(tmp_path, monkeypatch)


async def test_what_travels_is_shown_and_nodes_are_spoken_to(program: Path, orders: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        await driver.show("live")
        assert "nothing runs" in live(driver).entries.empty
        await driver.press("f5")
        line = await wait_shown(driver, "≈ /chatter")
        assert driver.main.focused is live(driver)
        await wait_shown(driver, "/chatter      2.0 Hz 0.25")
        # Only what is in sight is listened to, and nothing unfolded yet.
        watched = asked(orders, "watch")[-1]
        rows = live(driver).size.height
        assert "/chatter" in watched["topics"] and len(watched["topics"]) == rows - 1
        assert watched["full"] == ["/chatter"]
        assert live(driver).row.name == "/chatter", line
        # Its fields.
        await driver.press("right")
        await wait_shown(driver, "linear.x")
        # A message, from a field of the topic: what does not fit is said, and not sent. Keys that
        # come before the form is there are for it.
        await driver.press("down", "down")
        footer = driver.main.query_one(KeyBar)
        assert footer.text.startswith("Enter Open  p Publish") and "Quit" in footer.text
        for key in ("p", *"fast"):
            driver.app.post_message(events.Key(key, key))
        form = await driver.dialog("LiveForm")
        # It begins with the last message, which what is typed replaces.
        await driver.until(lambda: "fast" in form.given.values())
        await driver.pilot.press("enter")
        await driver.pilot.pause()
        assert "takes a number" in str(form.query_one("#wizard-help", Label).content)
        assert not asked(orders, "publish")
        await driver.pilot.press("backspace", *["backspace"] * 3, "0", ".", "5", "enter")
        await driver.back()
        await driver.until(lambda: "done: publish" in driver.notes())
        (order,) = asked(orders, "publish")
        assert (order["name"], order["values"]) == ("/chatter", {"linear": {"x": 0.5}})
        # The same again is another message, and another note.
        await driver.pilot.press("p")
        await driver.dialog("LiveForm")
        await driver.pilot.press("enter")
        await driver.back()
        await driver.until(lambda: "done: publish (2)" in driver.notes())
        assert [each["values"] for each in asked(orders, "publish")] == [order["values"]] * 2
        # From another field it begins there.
        await driver.press("down")
        await driver.pilot.press("p")
        form = await driver.dialog("LiveForm")
        await driver.until(lambda: form.focused.parent.path == ("linear", "y"))
        await driver.pilot.press("escape")
        await driver.back()
        # The card of a topic says what comes there; the wizard gives the focus back.
        assert driver.main.program.said_now("/chatter") == "2.0 Hz, 0.25"
        assert driver.main.program.said_now("/nowhere") == ""
        card = driver.main.program.card_at(driver.main.open.text.index(b"chatter"))
        assert card.rows[0][:2] == ("now", "2.0 Hz, 0.25")
        await driver.press("ctrl+u")
        await driver.dialog("Wizard")
        await driver.pilot.press("escape")
        await driver.back()
        assert live(driver).has_focus
        # A parameter.
        await driver.press("end", "right")
        await wait_shown(driver, "speed")
        await driver.press("down")
        assert "s Set" in footer.text and "Watch again" not in footer.text
        await driver.pilot.press("enter")
        await driver.dialog("LiveForm")
        form = driver.app.screen
        # What does not fit is not sent; what the node does not want stays in the form.
        for typed, said in (("2.5", "a number from 0 to 1"), ("0.25", "not now")):
            await driver.pilot.press(*["backspace"] * 4, *typed, "enter")
            help_ = form.query_one("#wizard-help", Label)
            await driver.until(lambda said=said, help_=help_: said in str(help_.content))
        await driver.pilot.press("backspace", "backspace", "7", "5", "enter")
        await driver.back()
        await driver.until(lambda: "speed is 0.75 now" in driver.notes())
        assert [each["value"] for each in asked(orders, "set")] == [0.25, 0.75]
        assert "not now" not in driver.notes()
        # A service, whose answer is shown below it.
        await driver.press("up", "up", "up")
        assert live(driver).row.name == "/add"
        await driver.pilot.press("enter")
        await driver.dialog("LiveForm")
        await driver.pilot.press("1", "enter")
        await driver.back()
        await wait_shown(driver, "→ done: call")
        # With a filter only what it finds is there, and listened to.
        await driver.press("slash", *"040", "space", *"FLOAT")
        await driver.until(lambda: asked(orders, "watch")[-1]["topics"] == ["/topic_040"])
        bar = driver.main.query_one("#live-filter")
        assert [row.name for row in live(driver)._live] == ["topics", "/topic_040"]
        assert "1 of 54" in str(bar.query_one("#live-count", Label).content)
        await driver.press("enter")
        assert live(driver).has_focus and live(driver).row.name == "/topic_040"
        await driver.show("graph")
        await driver.until(lambda: not bar.display)
        await driver.press("alt+v")
        await driver.until(lambda: bar.display)
        await driver.press("slash", *"none")
        assert "nothing has these words" in live(driver).entries.empty and not live(driver).lines
        await driver.press("escape")
        assert live(driver).has_focus and len(live(driver).lines) > 50 and not bar.display
        await driver.press("end", *["up"] * 5)
        assert live(driver).row.name == "/add"
        # Out of sight nothing is listened to; back in sight it is again.
        await driver.press("alt+1")
        await driver.until(lambda: not asked(orders, "watch")[-1]["nodes"])
        assert live(driver).watching(2) == Watching()
        await driver.press("alt+v")
        await driver.until(lambda: asked(orders, "watch")[-1]["nodes"])
        # Another monitor takes the place of one that dies, without a word.
        await driver.press("enter")
        await driver.dialog("LiveForm")
        await driver.pilot.press("backspace", "enter")
        await driver.back()
        watches = driver.main.runner.watched.live
        await driver.until(lambda: watches._retried and live(driver)._graphs[0].is_watched)
        assert "not watched" not in driver.notes()
        # Where that one dies too, that is said; the nodes run on, and another one can be had.
        await driver.press("enter")
        await driver.dialog("LiveForm")
        await driver.pilot.press("enter")
        await driver.back()
        await driver.until(lambda: "the nodes run on, but are not watched" in driver.notes())
        await driver.press("home")
        await wait_shown(driver, "not watched, press R to watch again")
        # What was seen last is shown as that.
        chatter = next(row for row in live(driver)._live if row.name == "/chatter")
        assert chatter.is_old and chatter.rate == "2.0 Hz"
        assert driver.main.runner.is_running
        assert "r Watch again" in footer.text and "Enter" not in footer.text
        await driver.press("r", "home")
        await driver.until(lambda: "ended" not in "".join(live(driver).lines))
        # Nodes that have ended are marked.
        await driver.press("f5")
        await driver.until(lambda: not driver.main.runner.is_running)
        assert live(driver).has_focus
        await wait_shown(driver, "ended: this was seen last")
        await wait_shown(driver, "/chatter      2.0 Hz 0.25")
        assert (await wait_shown(driver, "/talker")).endswith("ended")
        # The parameters that were in sight stay as well.
        await wait_shown(driver, "speed              0.5")
        assert all(row.is_old for row in live(driver)._live if row.kind in (Kind.TOPIC, Kind.NODE))
        await driver.press("home", "down")
        assert live(driver).row.name == "/chatter" and "Publish" not in footer.text
        assert "Open" in footer.text


async def test_messages_at_a_rate_and_goals_are_sent_and_canceled(
    program: Path, orders: Path
) -> None:
    async with studio(program, (80, 24)) as driver:
        await driver.show("live")
        await driver.press("f5")
        await wait_shown(driver, "/chatter      2.0 Hz 0.25")
        footer = driver.main.query_one(KeyBar)
        assert "x Stop sending" not in footer.text
        # A rate that is none is said at its field, and nothing is sent.
        await driver.pilot.press("p")
        form = await driver.dialog("LiveForm")
        await driver.pilot.press("0", ".", "5", *["down"] * 6, *"often", "enter")
        help_ = form.query_one("#wizard-help", Label)
        await driver.until(lambda: "such as 10 hz" in str(help_.content))
        assert not asked(orders, "publish") and form.focused.parent.path == ("how often",)
        await driver.pilot.press(*["backspace"] * 5, *"10 hz", "enter")
        await driver.back()
        await wait_shown(driver, "▶ sending at 10 hz: linear")
        (order,) = asked(orders, "publish")
        assert (order["rate"], order["values"]) == (10, {"linear": {"x": 0.5}})
        assert not driver.notes()
        # Where it is sent, one key ends that; nowhere else.
        assert live(driver).row.name == "/chatter" and "x Stop sending" in footer.text
        await driver.press("down", "down")
        assert live(driver).row.name == "/topic_000" and "x Stop sending" not in footer.text
        # What moves a robot goes on out of sight, and that is said.
        await driver.show("graph")
        await driver.until(lambda: "still sending to /chatter; x in Live" in driver.notes())
        await driver.press("alt+v")
        await driver.press("up", "x")
        await driver.until(lambda: not any("sending" in line for line in live(driver).lines))
        assert asked(orders, "stop") == [{"do": "stop", "name": "/chatter"}]
        # A goal, whose feedback and end are shown below its action.
        await driver.press("end", "up")
        assert live(driver).row.name == "/count" and "g Goal" in footer.text
        await driver.press("enter")
        await driver.dialog("LiveForm")
        await driver.pilot.press("enter")
        await driver.back()
        await driver.until(lambda: "it needs an order" in driver.notes())
        panel = live(driver)
        # The action is the last row in sight: what comes of it is brought there.
        top = panel.index + 1 - panel.size.height
        panel.scroll_to(y=top, animate=False, force=True, immediate=True)
        for key, character in (("g", "g"), ("5", "5"), ("enter", None)):
            driver.app.post_message(events.Key(key, character))
        await wait_shown(driver, "▶ order: 5 → accepted, sequence: [0, 1]")
        await driver.until(lambda: driver.app.screen is driver.main)
        assert asked(orders, "goal")[-1]["values"] == {"order": 5}
        await driver.until(lambda: panel.scroll_offset.y == top + 1)
        await driver.press("down", "x")
        await wait_shown(driver, "– order: 5 → canceled")
        assert asked(orders, "cancel") == [
            {"do": "cancel", "goal": asked(orders, "goal")[-1]["id"]}
        ]
        assert "x Cancel the goal" not in footer.text
        # With the nodes everything ends that is sent to them.
        await driver.press("g")
        await driver.dialog("LiveForm")
        await driver.pilot.press("enter")
        await driver.back()
        await driver.until(lambda: len(live(driver)._graphs[0].goals) == 2)
        await driver.press("down")
        assert "x Cancel the goal" in footer.text
        await driver.press("f5")
        await driver.until(lambda: not driver.main.runner.is_running)
        await driver.show("live")
        await wait_shown(driver, "order: 5 → not watched any more")


def test_what_is_built_before_nodes_start_is_said_unless_others_are_watched() -> None:
    said: list[str] = []
    live = SimpleNamespace(preparing=said.append, starting=lambda: None)
    watched = WatchedRun(cast(LiveActions, live), cast(Any, None))
    watched.preparing(
        ["plastron run a", "building `a`: compiling, 25 %", "building `b`: configuring"]
    )
    watched.preparing(["talker | building `it`: no"])
    assert said == ["building `b`: configuring"]
    watched._newest = cast(Any, object())
    watched.preparing(["building `c`: compiling"])
    assert len(said) == 1


async def test_in_a_wide_window_the_output_stays(
    program: Path, orders: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with studio(program, (160, 40)) as driver:
        await driver.press("f5")
        await wait_shown(driver, "≈ /chatter")
        assert driver.main.focused is driver.main.editor.view
        assert driver.main.dock_layout.is_in_sight("live")
        assert driver.main.dock_layout.is_in_sight("output")
        # A studio that was stopped has not read what the monitor said meanwhile: it is asked twice.
        monkeypatch.setattr(monitor, "SILENT", 0.0)
        look = driver.main.runner.watched.live._look_at_monitors
        look()
        monkeypatch.setattr(monitor, "SILENT", 60.0)
        look()
        monkeypatch.setattr(monitor, "SILENT", 0.0)
        look()
        assert "did not answer any more" not in driver.notes()
        # A monitor that hangs is ended, and that is said.
        await driver.until(lambda: "did not answer any more" in driver.notes())
        assert driver.main.runner.is_running


async def test_of_the_nodes_of_all_tabs_those_of_the_tab_in_front_are_its_own(
    program: Path, orders: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = program.with_name("other.plastron")
    other.write_text(PROGRAM)
    (command,) = Nodes.monitors

    def own() -> bool:
        return not next(row for row in live(driver)._live if row.name == "/talker").is_foreign

    async with studio(program, (160, 40)) as driver:
        main = driver.main
        runner = main.runner
        monkeypatch.setattr(Nodes, "monitors", (replace(command, nodes={"t": ("/talker",)}),))
        await driver.press("f5")
        await wait_shown(driver, "≈ /chatter")
        assert own()
        main.files.open_file(other)
        await driver.settle()
        first, second = main.program.tabs
        watched = runner.watched
        assert not own()
        # Another program's nodes are built, and that fails: those that run are watched all along.
        with monkeypatch.context() as building:
            building.setattr(Nodes, "monitors", ())
            await driver.press("f5")
            await driver.until(lambda: runner.runs_in(second))
            await wait_shown(driver, "≈ /chatter")
            runner.stop()
            await driver.until(lambda: not runner.runs_in(second))
            await wait_shown(driver, "≈ /chatter")
        assert main.program.tab is second and watched._newest is first
        assert "gone" not in "".join(live(driver).lines)
        # One monitor watches all of them, and goes on when others start or end.
        monitor_before = watched.live._monitors[2]
        monkeypatch.setattr(Nodes, "monitors", (replace(command, nodes={"l": ("/listener",)}),))
        await driver.press("f5")
        await driver.until(lambda: watched._newest is second)
        await wait_shown(driver, "≈ /chatter")
        assert not own()
        # Types are those of the program in front, else of the one that was started last.
        assert watched.live._sessions == (second.open.session,)
        await driver.press("alt+e")
        await driver.until(own)
        assert watched.live._sessions == (first.open.session, second.open.session)
        await driver.press("alt+e")
        await driver.until(lambda: not own())
        # Who stops nodes knows why they are gone: that is said in quiet.
        await driver.press("alt+e")
        runner.stop()
        await driver.until(lambda: not runner.runs_in(first))
        row = next(row for row in live(driver)._live if row.name == "/talker")
        assert (row.value, row.tone) == ("stopped", "quiet") and runner.runs_in(second)
        monkeypatch.setattr(Nodes, "monitors", (replace(command, nodes={"t": ("/talker",)}),))
        await driver.press("f5")
        await driver.until(lambda: watched._newest is first)
        runner.forget(second)
        assert watched.live._monitors[2] is monitor_before
        await wait_shown(driver, "≈ /chatter")
        # What was seen last of nodes that were ended is shown with their own program only.
        runner.forget(first)
        await driver.until(lambda: not live(driver).lines)
        assert "nothing runs" in live(driver).entries.empty


async def test_what_is_gathered_waits_while_somebody_types(
    program: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with studio(program) as driver:
        actions = driver.main.runner.watched.live
        await driver.press("x")
        typed = driver.app._last_typed
        for typed_before, shown_before, is_held_back in [
            (0.1, 0.5, True),
            (0.1, 1.5, False),
            (0.5, 0.5, False),
        ]:
            actions._shown_at = typed + typed_before - shown_before
            for module in (key_order, live_actions):
                monkeypatch.setattr(module, "monotonic", lambda: typed + typed_before)  # noqa: B023
            assert actions._is_held_back == is_held_back, (typed_before, shown_before)
        monkeypatch.undo()
