"""A form that stays until the node has answered, which may refuse what is sent."""

from __future__ import annotations

from pathlib import Path

from studio_driver import studio
from textual.widgets import Label

from plastron_tui.runtime.live_parts import LiveParameter
from plastron_tui.session import Session
from plastron_tui.studio.panels.live_row import Kind, LiveRow
from plastron_tui.studio.wizard.live_orders import form_for


async def test_what_waits_for_its_answer_is_not_sent_again(program: Path) -> None:
    parameter = LiveParameter("speed", 0.5, "float")
    row = LiveRow("k", Kind.PARAMETER, "speed", "/a", 2, parameter=parameter)
    order = form_for(row, Session(b""), {})
    assert not isinstance(order, str)
    form, sent = order.dialog, []

    def ask(given: object) -> bool:
        sent.append(given)
        return True

    form.ask = ask
    async with studio(program) as driver:
        driver.app.push_screen(form)
        await driver.dialog("LiveForm")
        help_ = form.query_one("#wizard-help", Label)
        await driver.press("enter", "enter")
        assert len(sent) == 1 and str(help_.content).startswith("waiting for")
        form.answered("it is too fast", is_failure=True)
        assert str(help_.content) == "✗ it is too fast" and help_.has_class("-wrong")
        await driver.press("enter")
        assert len(sent) == 2 and not help_.has_class("-wrong")
        form.answered("", is_failure=False)
        await driver.back()
