"""Every way through the wizard, by keyboard alone and by mouse alone, in a small window."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from functools import partial
from pathlib import Path

import pytest
from machine import mostly_long
from studio_driver import Driver
from wizard_courses import ALL, PACKAGED, ROBOTS, TWO_NODES, put_beside
from wizard_driver import WizardDriver, way_to, wizard, wizard_from_welcome

from plastron_tui.language import Declaration
from plastron_tui.model.kinds import Publisher, Subscription
from plastron_tui.session import Session
from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.studio.wizard.goals import Aim, aim_of
from plastron_tui.studio.wizard.pages import PageKind

Step = Callable[[], Awaitable[None]]
Pick = Callable[[str], Awaitable[None]]

TAKEN_BACK = """
talker sends_goal to 'count' of action_type Fibonacci with input none
listener provides_action 'count' of action_type Fibonacci
listener has_parameter 'speed' of parameter_type float with default 0.5
listener repeats look at 2 hz
"""
"""What a program has besides in which there is something of every kind to take back."""

BY_MOUSE = ("publish", "load")
BY_KEYS = ("publish", "stop_request")
"""What is gone through where `long` tests are left out; one of them by mouse."""


def keyword(declaration: Declaration) -> str:
    return declaration.keyword


@pytest.fixture
def file(two: Path) -> Path:
    """A program in which every statement can be written."""
    put_beside(two.parent)
    return two


def program_for(declaration: Declaration, file: Path) -> str:
    text = TWO_NODES
    if declaration.undoes is not None:
        text = text.replace("generate_node", "// generate_node") + TAKEN_BACK
    if aim_of(declaration) in (Aim.TYPE, Aim.PACKAGE, Aim.LAUNCH):
        text += PACKAGED
    if aim_of(declaration) is Aim.ROBOT:
        text += ROBOTS
    if aim_of(declaration) is Aim.WRITE:
        text = text.replace("generate_node listener\n", "")
    file.write_text(text)
    return text


async def check_end(it: WizardDriver, declaration: Declaration, before: str, file: Path) -> None:
    """The statement is in the program, nothing is wrong, and one step takes it out again."""
    main = it.driver.main
    assert "something more" in it.menu
    text = it.driver.text
    session = Session(text.encode(), file, environ={})
    assert session.diagnostics == ()
    made = [one for one in session.program.statements if type(one) is declaration.type]
    old = Session(before.encode(), file, environ={}).program.statements
    assert len(made) == len([one for one in old if type(one) is declaration.type]) + 1
    main.editor.undo()
    assert it.driver.text == before
    main.editor.redo()
    assert it.driver.text == text


async def through(it: WizardDriver, declaration: Declaration, go_on: Step, pick: Pick) -> None:
    """Write a statement, with all suggestions accepted."""
    for way in way_to(declaration):
        while it.kind is PageKind.FORM:
            await go_on()
        await pick(way)
    for _ in range(6):
        if it.screen.is_done:
            break
        await go_on()


# The others go to their last step, and back, and to the end by mouse, further down.
@pytest.mark.parametrize(
    "declaration",
    mostly_long(
        [each for each in ALL if each in ALL[1::2] or each.keyword in BY_KEYS], BY_KEYS, keyword
    ),
)
async def test_by_keyboard_alone(declaration: Declaration, file: Path) -> None:
    before = program_for(declaration, file)
    async with wizard(file) as it:
        await through(it, declaration, partial(it.press, "enter"), it.pick)
        await check_end(it, declaration, before, file)
        await it.press("escape")
        assert not it.is_open and it.driver.main.editor.view.has_focus


@pytest.mark.parametrize(
    "declaration",
    mostly_long([each for each in ALL if each.keyword in BY_MOUSE], ["load"], keyword),
)
async def test_by_mouse_alone(declaration: Declaration, file: Path) -> None:
    before = program_for(declaration, file)
    async with wizard(file) as it:
        await through(it, declaration, partial(it.click, "#wizard-next"), it.click_item)
        await check_end(it, declaration, before, file)
        await it.click_item("back to the text")
        assert not it.is_open


@pytest.mark.long
@pytest.mark.parametrize("declaration", ALL[::2], ids=keyword)
async def test_back_from_every_step_keeps_what_was_entered(
    declaration: Declaration, file: Path
) -> None:
    """By keyboard to the last step, back to the first, and by mouse alone to the end."""
    before = program_for(declaration, file)
    async with wizard(file) as it:
        await it.go(*way_to(declaration))
        entered = {}
        while it.kind is PageKind.FORM:
            names = ("topic", "service", "name", "variable", "function")
            label = next((n for n in names if n in it.rows and not it.row(n).is_fixed), None)
            if label is not None and declaration.undoes is None:
                await it.write(label, "mine")
            entered[it.title, it.screen.course.at] = (it.rows, it.form.key_here)
            await it.press("enter")
        assert it.kind is PageKind.REVIEW
        statements = it.statements
        steps = it.screen.course.at
        for number in range(steps):
            # Both ways: the key, and the button.
            if number % 2:
                await it.click("#wizard-back")
            else:
                await it.press("f2")
            place = (it.title, it.screen.course.at)
            if place in entered:
                assert (it.rows, it.form.key_here) == entered[place]
            elif it.kind is not PageKind.FORM:
                assert it.here in way_to(declaration)
        assert it.kind is PageKind.START
        await it.press("f2")
        assert it.kind is PageKind.START

        reviewed = []

        async def go_on() -> None:
            if it.kind is PageKind.REVIEW:
                reviewed.append(it.statements)
            await it.click("#wizard-next")

        await through(it, declaration, go_on, it.click_item)
        assert reviewed == [statements]
        await check_end(it, declaration, before, file)
        await it.click_item("back to the text")
        assert not it.is_open


@pytest.mark.parametrize("steps", mostly_long(range(6), [1]))
async def test_escape_leaves_without_a_trace(file: Path, steps: int) -> None:
    async with wizard(file) as it:
        for _ in range(steps):
            await it.press("enter")
            if it.kind is PageKind.FORM:
                await it.write("variable" if "variable" in it.rows else "topic", "other")
        filled_in = steps > 0 and it.screen.course.is_filled_in
        while it.screen.course.at > 0:
            at = it.screen.course.at
            await it.press("escape")
            assert it.screen.course.at == at - 1
        await it.pilot.press("escape")
        if filled_in:
            question = await it.driver.dialog("Question")
            assert "forget" in str(question.query_one("#dialog-title").content)
            await it.pilot.press("enter")
            await it.driver.until(lambda: it.is_open)
            await it.click("#wizard-leave")
            await it.driver.dialog("Question")
            await it.pilot.press("l")
        await it.driver.back()
        assert not it.is_open
        assert it.driver.text == TWO_NODES
        assert not it.driver.main.open.is_changed
        it.driver.main.editor.undo()
        assert it.driver.text == TWO_NODES


def has_gone_on(driver: Driver, name: str) -> bool:
    """Tell whether another dialog has opened than that of the name, or that one is done."""
    screen = driver.app.screen
    is_other = type(screen).__name__ not in ("MainScreen", name)
    return is_other or getattr(screen, "is_written", False)


async def test_from_nothing_to_two_nodes_that_talk_in_few_keys(
    here: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From the welcome to two nodes that run, with every suggestion accepted: 13 keys."""
    runs: list[bool] = []
    monkeypatch.setattr(MainScreen, "action_run", lambda _, *given: runs.append(True))
    async with wizard_from_welcome() as it:
        driver = it.driver
        for _ in range(40):
            name = type(driver.app.screen).__name__
            await it.press("enter")
            await driver.until(lambda: it.is_open or runs or has_gone_on(driver, name))  # noqa: B023
            if runs:
                break
        assert it.keys == 13
        session = Session(driver.text.encode(), environ={})
        assert session.diagnostics == ()
        (node, other) = session.workspace.nodes.values()
        assert set(node.of(Publisher)) == set(other.of(Subscription)) == {"chatter"}
