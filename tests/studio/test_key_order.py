"""A key waits for all that follows from the one before it, in however many steps."""

from __future__ import annotations

import asyncio

import pytest
from idle_loop import until
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding
from textual.message import Message
from textual.screen import Screen
from textual.widgets import Input, Label

from plastron_tui.studio.key_order import QUIET, InOrder, Unread
from plastron_tui.studio.terminal_driver import Burst

STEPS = 25


class Relay(Label, can_focus=True):
    """Says the same again and again before it says that it is done."""

    class Step(Message):
        def __init__(self, left: int) -> None:
            super().__init__()
            self.left = left

    class Done(Message):
        pass

    async def on_relay_step(self, message: Step) -> None:
        message.stop()
        await asyncio.sleep(0.001)
        self.post_message(self.Step(message.left - 1) if message.left else self.Done())


class Main(Screen[None]):
    BINDINGS = [Binding("f2", "ask")]  # noqa: RUF012 - Textual's way

    def compose(self) -> ComposeResult:
        yield Relay()
        yield Input()

    def on_mount(self) -> None:
        self.query_one(Relay).focus()

    def action_ask(self) -> None:
        self.query_one(Relay).post_message(Relay.Step(STEPS))

    def on_relay_done(self) -> None:
        self.set_focus(self.query_one(Input))


class Studio(InOrder):
    def get_default_screen(self) -> Screen[None]:
        return Main()


async def test_a_key_waits_for_all_steps_that_lead_to_another_focus() -> None:
    app = Studio()
    async with app.run_test() as pilot:
        for key in ("f2", "a", "b"):
            app.post_message(events.Key(key, key if len(key) == 1 else None))
        field = app.screen.query_one(Input)
        await until(pilot, lambda: field.value == "ab")


@pytest.mark.parametrize("text", ["xy", "x\ry"])
async def test_what_is_pasted_or_comes_at_once_keeps_its_place(text: str) -> None:
    app = Studio()
    async with app.run_test() as pilot:
        keys = [events.Key("enter" if each == "\r" else each, each) for each in text]
        for event in (events.Key("f2", None), events.Paste("p"), Burst(text, keys)):
            app.post_message(event)
        app.post_message(events.Key("b", "b"))
        field = app.screen.query_one(Input)
        await until(pilot, lambda: field.value == "pxyb")


@pytest.mark.parametrize(
    ("is_unasked", "keys", "heard"),
    [
        # It has been there for a while, and nobody types.
        (True, [(0.8, "y")], "y"),
        (True, [(0.1, "y"), (0.2, "n")], ""),
        (True, [(0.1, "enter")], ""),
        # Whoever is used to it answers and goes on.
        (True, [(0.1, "a"), (0.9, "y"), (0.95, "n")], "y n"),
        (True, [(0.5, "a"), (1.0, "b"), (1.5, "c"), (2.3, "y")], "y"),
        (True, [(0.1, "a"), (0.2, "escape")], "escape"),
        # One that was asked for waits for letters alone; with the arrows one has read it.
        (False, [(0.1, "d"), (0.2, "enter")], "enter"),
        (False, [(0.1, "d"), (0.2, "right"), (0.3, "d")], "right d"),
        (False, [(0.8, "d")], "d"),
    ],
)
def test_a_question_is_deaf_while_somebody_types(
    is_unasked: bool, keys: list[tuple[float, str]], heard: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("plastron_tui.studio.key_order.QUIET", QUIET)
    screen = Unread()
    screen.appeared, screen.is_unasked = 100.0, is_unasked
    last, found = 99.9, []
    for time, key in keys:
        event = events.Key(key, key if len(key) == 1 else None)
        found += [key] if screen.hears(event, last, 100.0 + time) else []
        last = 100.0 + time
    assert " ".join(found) == heard


async def test_without_a_word_of_messages_keys_arrive(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("plastron_tui.studio.key_order.hear_messages", lambda hear: None)
    app = Studio()
    async with app.run_test() as pilot:
        app.screen.set_focus(app.screen.query_one(Input))
        for key in ("f2", "a", "b"):
            app.post_message(events.Key(key, key if len(key) == 1 else None))
        field = app.screen.query_one(Input)
        await until(pilot, lambda: field.value == "ab")
