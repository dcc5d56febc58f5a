"""Texts with a selection, without a screen."""

from __future__ import annotations

from plastron_tui.session import Session
from plastron_tui.studio.editor.state import TextState


def state_of(text: str, anchor: int = 0, head: int | None = None) -> TextState:
    state = TextState(Session(text.encode(), environ={}))
    state.select(anchor, anchor if head is None else head)
    return state


def text_of(state: TextState) -> str:
    return state.buffer.text.decode()
