"""The worker that finds out what the program means, in a thread of its own.

It takes the newest request only, and posts what it found; it touches no widget.
"""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING, NamedTuple

from textual.message import Message

if TYPE_CHECKING:
    from plastron_tui.session import Session

    from .analysis import Analysis
    from .panels.picture import Size

_SWITCH = 0.001
"""Seconds after which a busy thread lets the event loop go on; Python's own are five times that."""

_LARGE = 100_000
"""From so many bytes on, a walk of Python's cycle collector takes longer than a key may."""

_IDLE, _KEPT = 0.3, 4
"""Seconds without a question after which what is no longer shown is let go, and how many analyses
may wait for that: to let one of a large program go stops everything for some milliseconds."""

_REST, _DUE, _OVERDUE, _MOST = 3.0, 50, 250, 500
"""Seconds without a question after which the collector looks at everything, if that is due. With a
large program it takes some tenths of a second, in which no key is drawn. The numbers count answers
about a large program: from the first on it is due, from the second on a shorter rest is enough,
and from the third on none is needed."""

_NEVER = 1_000_000_000
"""Looks at young objects after which the collector looks at all of its own accord."""


class Wanted(NamedTuple):
    """What is in sight, and so has to be known.

    Attributes:
        panels: the panels with entries.
        preview: the variable of the node whose files are shown.
        graph: where the graph is shown, None where it is not.
    """

    panels: tuple[str, ...] = ()
    preview: str | None = None
    graph: Size | None = None


class Stale(Exception):  # noqa: N818 - no error: the text has changed meanwhile
    """A newer text is there; what was begun is of no use."""


class Analysed(Message):
    """What a text means is known, or one more part of it."""

    def __init__(self, analysis: Analysis, seconds: float) -> None:
        super().__init__()
        self.analysis = analysis
        self.seconds = seconds

    def can_replace(self, message: Message) -> bool:
        """Let the newest stand for all."""
        return isinstance(message, Analysed)


class AnalysisFailed(Message):
    """The worker met an error of Plastron's own."""

    def __init__(self, error: BaseException) -> None:
        super().__init__()
        self.error = error


class Analyst:
    """Answers the newest question, in a thread."""

    def __init__(self, post: Callable[[Message], object]) -> None:
        self._post = post
        self._condition = threading.Condition()
        self._session: Session | None = None
        self._wanted: Wanted | None = None
        self._is_stopped = False
        self._last: Analysis | None = None
        self._old: list[Analysis | Session] = []
        self._thread = threading.Thread(target=self._run, name="analyst", daemon=True)
        self._switch = sys.getswitchinterval()
        self._thresholds = gc.get_threshold()
        self._is_spared = False
        self._answers = 0

    def start(self) -> None:
        """Start the thread."""
        sys.setswitchinterval(_SWITCH)
        self._thread.start()

    def stop(self) -> None:
        """Let the thread end after what it does now."""
        with self._condition:
            self._is_stopped = True
            self._condition.notify()
        sys.setswitchinterval(self._switch)
        gc.set_threshold(*self._thresholds)

    def join(self, seconds: float) -> None:
        """Wait for the thread to end, so long at most."""
        self._thread.join(seconds)

    def ask(self, wanted: Wanted, session: Session | None = None) -> None:
        """Ask what a snapshot means; None asks for more about the last one."""
        with self._condition:
            if session is not None:
                self._session = session
            self._wanted = wanted
            self._condition.notify()

    def _run(self) -> None:
        while True:
            with self._condition:
                self._condition.wait_for(self._has_work, self._patience)
                if self._is_stopped:
                    return
                session, wanted = self._session, self._wanted
                self._session = self._wanted = None
            if wanted is None:
                self._tidy_up()
                continue
            try:
                if session is not None and len(session.document.text) >= _LARGE:
                    self._spare()
                    with _without_collector():
                        self._answer(session, wanted)
                    if self._garbage >= _MOST:
                        self._collect()
                else:
                    self._answer(session, wanted)
            except Stale:
                if session is not None:
                    self._old.append(session)
            except Exception as error:
                self._post(AnalysisFailed(error))
            del self._old[:-_KEPT]

    def _spare(self) -> None:
        """Let the collector look at all of a large program at a time that is chosen here only."""
        self._answers += 1
        if not self._is_spared:
            self._is_spared = True
            # Python would look again after each ten of its looks at what is young.
            gc.set_threshold(*self._thresholds[:2], _NEVER)

    @property
    def _patience(self) -> float | None:
        """For how long to wait for work before there is something else to do."""
        if self._old:
            return _IDLE
        if not self._is_spared:
            return None
        return _REST if self._garbage < _OVERDUE else _IDLE

    @property
    def _garbage(self) -> int:
        """How often something became old unseen: by answers, or by Python's own looks since."""
        return self._answers + gc.get_count()[2]

    def _collect(self) -> None:
        self._answers = 0
        gc.collect()

    def _tidy_up(self) -> None:
        """Let go what is no longer needed: here and now, not in the event loop at the next key."""
        if self._old:
            self._old.clear()
        elif gc.isenabled() and self._garbage >= _DUE:
            self._collect()

    def _has_work(self) -> bool:
        return self._is_stopped or self._wanted is not None

    def _check(self) -> None:
        if self._is_stopped or self._session is not None:
            raise Stale

    def _answer(self, session: Session | None, wanted: Wanted) -> None:
        # Imported here, and so in the thread, when there is something to see.
        from .analysis import add_drawing, add_entries, add_preview, analyse

        start = perf_counter()
        if session is not None:
            last = self._last
            if last is not None:
                session.learn_from(last.session)
            # What else was asked for is asked again, if this gets stale.
            self._last = analyse(session, self._check)
            if last is not None:
                self._old.append(last)
        analysis = self._last
        if analysis is None:
            return
        for panel in wanted.panels:
            add_entries(analysis, panel)
            self._check()
        self._post(Analysed(analysis, perf_counter() - start))
        if wanted.graph is not None:
            add_drawing(analysis, wanted.graph)
        if wanted.preview is not None:
            add_preview(analysis, wanted.preview)
        if wanted.graph is not None or wanted.preview is not None:
            self._check()
            self._post(Analysed(analysis, perf_counter() - start))


@contextmanager
def _without_collector() -> Iterator[None]:
    """Keep the cycle collector away from what is made of a large program.

    It would walk what is new at once, stop the event loop meanwhile, and find nothing: all of it
    is let go without its help. What the event loop made meanwhile goes with it to the oldest
    generation, and is looked at when nobody types: Textual leaves cycles behind at each drawing.
    """
    if not gc.isenabled():
        yield
        return
    # What others have made so far is looked at now, while it is little.
    gc.collect(1)
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.unfreeze()
        gc.enable()
