"""What stays in the lines above and below where the window is narrow; what keys are called."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from plastron_tui.studio.actions import ACTIONS, KEPT
from plastron_tui.studio.key_display import key_name
from plastron_tui.studio.main.program_bars import OLDER, Title
from plastron_tui.studio.main.tab_run import TabRun
from plastron_tui.studio.panels.key_bar import Key, fitting

NAMES = {
    "f1": "F1",
    "f15": "Shift-F3",
    "shift+f5": "Shift-F5",
    "ctrl+q": "Ctrl-Q",
    "ctrl+underscore": "Ctrl-/",
    "ctrl+at": "Ctrl-Space",
    "ctrl+shift+up": "Ctrl-Shift-↑",
    "alt+1": "Alt-1",
    "alt+enter": "Alt-Enter",
    "alt+question_mark": "Alt-?",
    "alt+minus": "Alt--",
    "left_square_bracket": "[",
    "escape": "Esc",
    "delete": "Delete",
    "tab": "Tab",
    "space": "Space",
    "pageup": "PgUp",
    "d": "d",
    "K": "K",
}


@pytest.mark.parametrize("key", NAMES)
def test_a_key_is_called_as_on_keyboards(key: str) -> None:
    assert key_name(key) == NAMES[key]


def test_no_key_of_an_action_has_a_name_that_cannot_be_read() -> None:
    for key in ",".join(action.keys for action in ACTIONS if action.keys).split(","):
        name = key_name(key)
        assert name.isprintable()
        assert not set(name) & set("^_ "), name


FOOTER = [
    Key(key_name(action.keys.split(",")[0]), action.title, "", action.id)
    for action in ACTIONS
    if action.footer
]


@pytest.mark.parametrize(
    ("width", "titles"),
    [
        (120, "Help Run Generate Panels Menu Save Open Quit"),
        (80, "Help Run Generate Panels Menu Save Quit"),
        (60, "Help Run Generate Menu Quit"),
        (50, "Help Run Panels Menu Quit"),
        (41, "Help Run Menu Quit"),
        (30, "Help Run Menu"),
        (5, ""),
    ],
)
def test_the_footer_keeps_what_matters(width: int, titles: str) -> None:
    found = fitting(FOOTER, KEPT, width)
    assert [key.title for key in found] == titles.split()
    assert sum(key.width + 2 for key in found) - 2 < max(width, 1)


@pytest.mark.parametrize(
    ("width", "stage", "text"),
    [
        (80, "", "plastron talk.plastron ● work/  rclpy (ROS 2 kilted)"),
        (80, "running", "plastron talk.plastron ● running: F5 stops  work/  rclpy (ROS 2 kilted)"),
        (70, "running", "talk.plastron ● running: F5 stops  work/  rclpy (ROS 2 kilted)"),
        (60, "running", "talk.plastron ● running: F5 stops  rclpy (ROS 2 kilted)"),
        (50, "running", "talk.plastron ● running: F5 stops  rclpy"),
        (40, "running", "talk.plastron ● running  rclpy"),
        (
            70,
            "building it… 9 s",
            "talk.plastron ● building it… 9 s: F5 stops  rclpy (ROS 2 kilted)",
        ),
        (10, "running", "talk.plastron ● running  rclpy"),
    ],
)
def test_the_title_drops_first_what_matters_less(width: int, stage: str, text: str) -> None:
    title = Title("talk.plastron", True, "work", "rclpy (ROS 2 kilted)", "rclpy", stage, "F5")
    left, right = title.pieces(width)
    assert "".join(words for words, _ in (*left, *right)) == text


@pytest.mark.parametrize(
    ("width", "text"),
    [
        (90, "talk.plastron   running an older text: F5 stops, Alt-R runs anew  work/  rclpy"),
        (76, "talk.plastron   running an older text: F5 stops, Alt-R runs anew  rclpy"),
        (50, "talk.plastron   running an older text  rclpy"),
    ],
)
def test_the_title_says_that_what_runs_is_older(width: int, text: str) -> None:
    stage = "running an older text"
    title = Title("talk.plastron", False, "work", "rclpy", "rclpy", stage, "F5", "Alt-R")
    left, right = title.pieces(width)
    assert "".join(words for words, _ in (*left, *right)).removeprefix("plastron ") == text


def test_the_last_line_of_a_node_is_known_without_what_its_logger_puts_before_it() -> None:
    run = TabRun()
    run.note_said(["asker  | begun", "asker  | [INFO] [1.5] [asker]: add: sum=5", "asker  | "])
    run.note_said(["old    | [WARN] [1.5]: it did not fit", "plain  | [1, 2]", "no label"])
    assert run.said == {"asker": "add: sum=5", "old": "it did not fit", "plain": "[1, 2]"}
    run.note_said(["asker | [INFO] add: example_interfaces.srv.AddTwoInts_Response(sum=5)"])
    assert run.said["asker"] == "add: (sum=5)"


def test_nodes_run_once_what_they_need_is_built() -> None:
    run = TabRun()
    assert run.stage(0.0) == ""
    nodes = SimpleNamespace(is_started=False)
    run.running = cast(Any, nodes)
    assert run.stage(1.0) == "starting"
    run.note_progress(["plastron run a", "building `it`: compiling"], 2.0)
    run.note_progress(["building `it`: compiling, 25 %"], 4.0)
    assert run.stage(14.9) == "building it… 12 s"
    run.note_progress(["building `other`: configuring"], 20.0)
    assert run.stage(20.0) == "building other… 0 s"
    nodes.is_started = True
    assert run.stage(30.0) == "running"
    run.text = b"a // b\n"
    run.compare(b"a\n")
    assert run.stage(30.0) == "running"
    run.compare(b"b\n")
    assert run.stage(30.0) == OLDER
    run.compare(b"a\n")
    # What a node prints is told by it, not by the build.
    nodes.is_started = False
    run.note_progress(["talker | building `third`: no"], 31.0)
    assert run.stage(32.0) == "running" and run.built == "other"
