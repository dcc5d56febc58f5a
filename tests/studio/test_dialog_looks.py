"""What is lit in a dialog is what the keys are for, and nothing else."""

from __future__ import annotations

from pathlib import Path

from studio_driver import studio
from textual.color import Color
from textual.widgets import Button

from plastron_tui.studio.screens.question import Question

ANSWERS = [("yes", "Yes"), ("no", "No"), ("later", "Later")]


async def test_only_the_button_with_the_focus_is_filled(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        driver.app.push_screen(Question("Well?", ANSWERS))
        question = await driver.dialog("Question")
        fill = Color.parse(driver.app.theme_variables["primary"])

        def filled() -> list[str | None]:
            return [each.id for each in question.query(Button) if each.styles.background == fill]

        assert filled() == ["yes"]
        await driver.pilot.press("right")
        await driver.until(lambda: filled() == ["no"])
        # What the dialog is for is still to be seen.
        yes, _, later = question.query(Button)
        assert yes.styles.text_style.bold and not later.styles.text_style.bold
