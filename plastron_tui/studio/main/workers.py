"""Work that waits for answers, beside the event loop."""

from __future__ import annotations

from collections.abc import Callable, Coroutine
from functools import partial
from typing import Any, ParamSpec

from textual.screen import Screen
from textual.worker import WorkType

_P = ParamSpec("_P")


def start_exclusive(
    screen: Screen[None],
    group: str,
    function: Callable[_P, Coroutine[Any, Any, None]],
    *args: _P.args,
    **kwargs: _P.kwargs,
) -> None:
    """Start a worker of a screen; the one of the group that still waits ends."""
    # Called by the worker: of one that ends before it begins no coroutine is left behind.
    work: WorkType[None] = partial(function, *args, **kwargs)
    screen.run_worker(work, group=group, exclusive=True)
