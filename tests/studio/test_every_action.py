"""Every action of the registry, by its key, with what it leads to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import PROGRAM, Driver, studio
from textual.app import App

from plastron_tui.studio.actions import ACTIONS, BY_ID
from plastron_tui.studio.main.run_actions import RunActions
from plastron_tui.studio.panels.registry import PANELS

Check = Callable[[Driver], bool]


@dataclass(frozen=True)
class Case:
    """What is the case before an action, and what is to be the case after it.

    Attributes:
        check: tells whether the action has done what it is for.
        before: keys that are pressed first.
        cursor: the text that the cursor is put on.
        program: another program.
        opens: the dialog that the action opens, where it opens one.
    """

    check: Check = lambda _: True
    before: tuple[str, ...] = ()
    cursor: str = ""
    program: str = PROGRAM
    opens: str | None = None


def panel(name: str) -> Case:
    def is_shown(driver: Driver) -> bool:
        focused = driver.main.focused
        inside = focused is not None and any(
            widget.id == name for widget in focused.ancestors_with_self
        )
        return driver.main.dock_layout.is_in_sight(name) and inside

    return Case(is_shown)


def text(expected: str, **rest: object) -> Case:
    return Case(lambda driver: driver.text == expected, **rest)  # type: ignore[arg-type]


def at(place: str, last: bool = False) -> Check:
    find = PROGRAM.rindex if last else PROGRAM.index
    return lambda driver: driver.main.editor.cursor_offset == find(place)


def has(kind: str) -> Check:
    return lambda driver: any(
        type(widget).__name__ == kind and widget.display for widget in driver.main.query("*")
    )


def selected(driver: Driver) -> tuple[int, bytes]:
    """Return what is selected, and how often it stands before."""
    editor = driver.main.editor
    start, end = editor.selection.start, editor.selection.end
    chosen = editor.text[start:end]
    return editor.text.count(chosen, 0, start) if chosen else -1, chosen


def _row(driver: Driver) -> int:
    return driver.main.editor.text.count(b"\n", 0, driver.main.editor.cursor_offset)


def _grown(driver: Driver) -> int:
    before, now = driver.before, driver.main.dock_layout.outline.size  # type: ignore[attr-defined]
    return (now.width + now.height) - (before.width + before.height)


LINES = PROGRAM.splitlines(keepends=True)
FIRST, SECOND, REST = LINES[0], LINES[1], "".join(LINES[2:])
WRONG = PROGRAM.replace("generate_node talker", "generate_node talkr")

CASES: dict[str, Case] = {
    "help": Case(opens="Help", before=("f1",)),
    "run": Case(lambda driver: getattr(driver.app, "started", None) == ["talk.plastron"]),
    "run_anew": Case(lambda driver: getattr(driver.app, "started", None) == ["talk.plastron"]),
    "stop": Case(lambda driver: "nothing runs" in driver.notes()),
    "generate": Case(opens="GenerateDialog"),
    "wizard": Case(lambda driver: driver.app.screen is not driver.main),
    "next_panel": Case(lambda driver: driver.main.dock_layout.focused_dock is not None),
    "panels": Case(lambda driver: not any(dock.display for dock in driver.main.dock_layout.docks)),
    "menu": Case(opens="ActionMenu"),
    "zoom": Case(lambda driver: not driver.main.editor.display, before=("alt+1",)),
    "wider": Case(lambda driver: _grown(driver) > 0, before=("alt+1",)),
    "narrower": Case(lambda driver: _grown(driver) < 0, before=("alt+1",)),
    **{each.name: panel(each.name) for each in PANELS},
    "fix": text(PROGRAM, program=WRONG, cursor="generate_node talkr"),
    "names": Case(opens="ActionMenu"),
    "back": Case(lambda driver: driver.main.editor.state.row == 0,
                 cursor="generate_node talker"),
    "forward": Case(lambda driver: driver.main.editor.state.row == 3, before=("alt+comma",),
                    cursor="generate_node talker"),
    "code": Case(cursor="subscribe listener", opens="CodeView"),
    "new": Case(lambda driver: driver.main.open.path is None and not driver.text),
    "open": Case(opens="ChooseFile"),
    "next_tab": Case(lambda driver: driver.text == PROGRAM, before=("ctrl+n", "x")),
    "previous_tab": Case(lambda driver: driver.text == PROGRAM, before=("ctrl+n", "x")),
    "close_tab": Case(lambda driver: driver.text == PROGRAM, before=("ctrl+n",)),
    "save": Case(lambda driver: driver.main.open.path.read_text() == "x" + PROGRAM, before=("x",)),
    "save_as": Case(opens="ChooseFile"),
    "welcome": Case(opens="Welcome"),
    "tour": Case(opens="Tour"),
    "trust": Case(lambda driver: "nothing in this project has to be trusted" in driver.notes()),
    "theme": Case(opens="ThemeMenu"),
    "keys": Case(lambda driver: bool(driver.main.query("KeyList"))),
    "config": Case(lambda driver: "from the next start of the studio on" in driver.notes()),
    "suspend": Case(lambda driver: getattr(driver.app, "suspended", 0) == 1),
    "quit": Case(lambda driver: bool(driver.app._exit)),
    "editor.undo": text(PROGRAM, before=("x",)),
    "editor.redo": text("x" + PROGRAM, before=("x", "ctrl+z")),
    "editor.cut": Case(lambda driver: driver.text == SECOND + REST
                       and driver.app.clipboard.strip() == FIRST.strip()),
    "editor.copy": Case(lambda driver: driver.app.clipboard.strip() == FIRST.strip()),
    "editor.paste": text(FIRST + PROGRAM, before=("ctrl+c",)),
    "editor.select_all": Case(lambda driver: selected(driver)[1].decode() == PROGRAM),
    "editor.find": Case(has("FindBar")),
    "editor.replace": Case(has("FindBar")),
    "editor.find_next": Case(lambda driver: selected(driver) == (1, b"chatter"),
                             before=("ctrl+f", *"chatter")),
    "editor.find_previous": Case(lambda driver: selected(driver) == (0, b"chatter"),
                                 before=("ctrl+f", *"chatter", "f3")),
    "editor.go_to_line": Case(lambda driver: type(driver.app.focused).__name__ == "Input"),
    "editor.complete": Case(lambda driver: driver.main.editor.popup.is_open,
                            program="\n" + PROGRAM),
    "editor.toggle_comment": text("// " + PROGRAM),
    "editor.duplicate": text(FIRST + PROGRAM),
    "editor.move_up": text(SECOND + FIRST + REST, cursor="create_message"),
    "editor.move_down": text(SECOND + FIRST + REST),
    "editor.delete_line": text(SECOND + REST),
    "editor.definition": Case(at("greeting of"), cursor="greeting to"),
    "editor.uses": Case(cursor="greeting to", opens="LineList"),
    "editor.rename": Case(lambda driver: type(driver.app.focused).__name__ == "Input",
                          cursor="greeting to"),
    "editor.format": text(PROGRAM, program=PROGRAM.replace("of message_type", "of   message_type")),
    "editor.external_editor": Case(lambda driver: "in $EDITOR" in driver.notes()),
    "editor.toggle_wrap": Case(lambda driver: not driver.main.editor.view.soft_wrap),
    "editor.next_problem": Case(lambda driver: _row(driver) == 3, program=WRONG),
    "editor.previous_problem": Case(lambda driver: _row(driver) == 3, program=WRONG,
                                    before=("ctrl+end",)),
}  # fmt: skip


def test_every_action_has_a_case() -> None:
    assert set(CASES) == {action.id for action in ACTIONS}


def test_every_action_has_a_key() -> None:
    assert [action.id for action in ACTIONS if not action.keys] == []


@pytest.fixture(autouse=True)
def _nothing_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Note what would start nodes, or stop the tests."""

    def start(runner: RunActions, path: Path) -> None:
        runner._screen.app.started = [path.name]  # type: ignore[attr-defined]

    def suspend(app: App[None]) -> None:
        app.suspended = getattr(app, "suspended", 0) + 1  # type: ignore[attr-defined]

    monkeypatch.setattr(RunActions, "_start", start)
    monkeypatch.setattr(App, "action_suspend_process", suspend)


async def prepared(driver: Driver, case: Case) -> None:
    if case.cursor:
        driver.main.editor.go_to(driver.text.index(case.cursor))
    await driver.press(*case.before)
    driver.before = driver.main.dock_layout.outline.size  # type: ignore[attr-defined]


# What is done to the text is the same in windows of all sizes.
@pytest.mark.parametrize(
    "action",
    mostly_long(
        [
            (name, size)
            for name in CASES
            for size in ((80, 24), (120, 40))
            if size == (80, 24) or not name.startswith("editor.")
        ],
        [(name, (80, 24)) for name in list(CASES)[::3]],
    ),
)
async def test_an_action_does_by_its_key_what_it_is_for(
    program: Path, action: tuple[str, tuple[int, int]]
) -> None:
    name, size = action
    case = CASES[name]
    program.write_text(case.program)
    async with studio(program, size) as driver:
        await prepared(driver, case)
        assert case.opens or not case.check(driver)
        await driver.pilot.press(BY_ID[name].keys.split(",")[-1])
        if case.opens is not None:
            await driver.dialog(case.opens)
            await driver.pilot.press("escape")
            await driver.back()
        else:
            await driver.until(lambda: case.check(driver))


async def test_the_editor_takes_no_key_of_another_action(program: Path) -> None:
    async with studio(program) as driver:
        taken = set(driver.main.editor._bindings.key_to_bindings)
        taken |= set(driver.main.editor.view._bindings.key_to_bindings)
        for action in ACTIONS:
            if not action.own:
                assert not taken & set(action.keys.split(",")), action.id
