"""A pause of Python's cycle collector for passes that make many objects and no cycles."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def collection_paused() -> Iterator[None]:
    """Keep the collector from walking, over and over, what a pass has made so far.

    Without it the time of a statement grows with the length of the program. What was made goes
    straight to the oldest generation, as the next collection would put it there after walking it.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.freeze()
            gc.unfreeze()
            gc.enable()
