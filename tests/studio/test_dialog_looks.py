"""What is lit in a dialog is what the keys are for, and nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_driver import studio
from textual.color import Color
from textual.geometry import Size
from textual.widgets import Button, OptionList

from plastron_tui.studio.panels.diff_lines import difference
from plastron_tui.studio.panels.styles import Piece
from plastron_tui.studio.panels.text_view import TextView
from plastron_tui.studio.screens.dialog import is_tall
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
        # The letter that gives an answer is marked.
        marks = [[(span.start, span.end) for span in each.label.spans if "underline" in span.style]
                 for each in question.query(Button)]  # fmt: skip
        assert marks == [[(0, 1)]] * 3
        assert yes.styles.text_style.bold and not later.styles.text_style.bold


@pytest.mark.parametrize(
    ("rows", "text", "is_so"),
    [(3, "", False), (14, "one line", False), (15, "one line", True), (12, "x" * 300, True)],
)
def test_a_dialog_is_as_high_as_what_is_in_it(rows: int, text: str, is_so: bool) -> None:
    assert is_tall(rows, text, Size(80, 24)) is is_so


async def test_what_is_looked_at_leaves_the_answers_in_sight(program: Path) -> None:
    async with studio(program, (80, 24)) as driver:
        for rows, is_high in ((3, False), (14, False), (15, True), (300, True)):
            lines = tuple((Piece("a long line " * 20),) for _ in range(rows))
            question = Question("Well?", ANSWERS, text="one line", lines=lines)
            driver.app.push_screen(question)
            await driver.dialog("Question")
            box, view = question.query_one("#dialog"), question.query_one("#dialog-view")
            assert box.has_class("-tall") is is_high
            assert view.size.height in (rows, rows + 1) or (is_high and view.size.height > 8)
            buttons = question.query_one("#dialog-buttons").region
            assert box.content_region.contains_region(buttons) and buttons.height
            await driver.pilot.press("escape")
            await driver.back()
        driver.app.push_screen(
            Question("Well?", ANSWERS, lines=difference(b"a\n", b"b\nc\n", program))
        )
        question = await driver.dialog("Question")
        view = question.query_one(TextView)
        for row, line in enumerate(view.lines):
            grounds = [segment.style.bgcolor for segment in view.render_line(row) if segment.text]
            assert len(set(grounds)) == 1, line
            is_changed = line[1:] and line[1].text in ("+", "-")
            assert (grounds[0] != view.rich_style.bgcolor) is bool(is_changed)


@pytest.mark.parametrize(("rows", "is_roomy"), [(50, True), (24, False)])
async def test_empty_rows_of_the_welcome_push_nothing_out(rows: int, is_roomy: bool) -> None:
    async with studio(None, (100, rows), welcome=True) as driver:
        welcome = await driver.dialog("Welcome")
        options = welcome.query_one(OptionList)
        [*_, heading] = (str(each.prompt) for each in options.options if each.disabled)
        assert heading == ("\n" if is_roomy else "") + " Examples that work"
        top = welcome.query_one("#welcome-title").region.bottom
        assert options.region.y - top == int(is_roomy)
        if is_roomy:
            assert not options.show_vertical_scrollbar
