"""The worker that finds out what the program means, in a thread of its own.

It takes the newest request only, and posts what it found; it touches no widget.

A process of its own would be slower: for a program of 10,000 statements it takes 160 ms to pickle
the workspace and the panels' entries, and 56 ms in which the event loop stands still to unpickle
them, where all that is analysed after a key takes 60 ms. Statements would have to be made again
as well, since their syntax nodes cannot leave the process of their tree.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from time import perf_counter
from typing import TYPE_CHECKING

from textual.message import Message

from plastron_tui import collector

from .discarding import Discarded
from .editor.preload import preload

if TYPE_CHECKING:
    from plastron_tui.session import Session

    from .analysis import Analysis
    from .panels.panel import Request

_SWITCH_INTERVAL = 0.001
"""Seconds after which this thread, when it is busy, lets another go on; Python's own are 0.005.

A key passes three threads on its way to the screen, the terminal's input, the event loop and the
terminal's output, and each waits for this one: it is shown in four fifths of the time with this
(`python -m benchmarks threads`).
"""

_REST = 3.0
"""Seconds without a question after which nobody types, and the collector may work."""


class Stale(Exception):  # noqa: N818 - no error: the text has changed meanwhile
    """A newer text is there; what was begun is of no use."""


class Preloaded(Message):
    """What it takes to ask what a text means is imported."""


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


class AnalysisWorker:
    """Answers the newest question, in a thread."""

    def __init__(self, post: Callable[[Message], object]) -> None:
        self._post = post
        self._condition = threading.Condition()
        self._session: Session | None = None
        self._wanted: tuple[Request, ...] | None = None
        self._must_preload = False
        self._is_stopped = False
        self._is_answering = False
        self._is_stale = False
        self._last: Analysis | None = None
        self._past: list[Analysis] = []
        self._thread = threading.Thread(target=self._run, name="analysis", daemon=True)
        self._switch = sys.getswitchinterval()

    def start(self) -> None:
        """Start the thread."""
        sys.setswitchinterval(_SWITCH_INTERVAL)
        self._thread.start()

    def stop(self) -> None:
        """Let the thread end after what it does now."""
        with self._condition:
            self._is_stopped = True
            self._condition.notify()
        sys.setswitchinterval(self._switch)

    def join(self, seconds: float) -> None:
        """Wait for the thread to end, so long at most."""
        self._thread.join(seconds)

    def preload(self) -> None:
        """Import in the thread what it takes to ask and to answer; `Preloaded` tells of it."""
        with self._condition:
            self._must_preload = True
            self._condition.notify()

    def ask(self, wanted: tuple[Request, ...], session: Session | None = None) -> None:
        """Ask what a snapshot means, for the panels in sight; None for more about the last one."""
        with self._condition:
            if session is not None:
                self._session = session
                self._is_stale = False
            self._wanted = wanted
            self._condition.notify()

    def interrupt(self) -> None:
        """End the answer about a text that was edited: a new question follows, when no key comes.

        Nobody shows that answer any more, and the key's drawing would have to wait for it.
        """
        self._is_stale = True

    def discard(self, analysis: Analysis) -> None:
        """Let go in the thread, when nothing is asked, of an analysis that nobody else needs."""
        with self._condition:
            self._past.append(analysis)
            self._condition.notify()

    @property
    def is_idle(self) -> bool:
        """Whether all that was asked is answered."""
        with self._condition:
            is_asked = self._must_preload or self._wanted is not None
            return not is_asked and not self._is_answering

    def _run(self) -> None:
        discarded = Discarded()
        while True:
            with self._condition:
                self._is_answering = False
                is_resting = not self._condition.wait_for(
                    lambda: self._has_work() or bool(self._past), _REST
                )
                if self._is_stopped:
                    return
                past, self._past = self._past, []
                must_preload, self._must_preload = self._must_preload, False
                session, wanted = self._session, self._wanted
                self._session = self._wanted = None
                self._is_answering = must_preload or wanted is not None
            while past:
                discarded.add(past.pop())
            try:
                if must_preload:
                    preload()
                    self._post(Preloaded())
                if wanted is not None:
                    self._answer(session, wanted)
                elif is_resting:
                    collector.collect_if_due()
                discarded.let_go(self._must_hurry)
            except Stale:
                pass
            except Exception as error:
                self._post(AnalysisFailed(error))

    def _has_work(self) -> bool:
        return self._is_stopped or self._must_preload or self._wanted is not None

    def _must_hurry(self) -> bool:
        """Tell whether a key was typed: it is drawn sooner if nothing else is done."""
        return self._is_stale or self._has_work()

    def _check(self) -> None:
        if self._is_stopped or self._is_stale or self._session is not None:
            raise Stale

    def _answer(self, session: Session | None, wanted: tuple[Request, ...]) -> None:
        from .analysis import Kept, analyse
        from .panels.registry import BY_NAME, counts, make

        start = perf_counter()
        if session is not None:
            if self._last is not None:
                session.learn_from(self._last.session)
            kept = Kept(None if self._last is None else self._last.kept)
            # What else was asked for is asked again, if this gets stale.
            self._last = analyse(session, self._check)
            self._last.kept = kept
            self._last.counts = counts(self._last)
        analysis = self._last
        if analysis is None:
            return
        slow = [request for request in wanted if BY_NAME[request.panel].is_slow]
        for request in wanted:
            if request not in slow:
                make(analysis, request)
                self._check()
        self._post(Analysed(analysis, perf_counter() - start))
        for request in slow:
            make(analysis, request)
        analysis.kept.forget()
        if slow:
            self._check()
            self._post(Analysed(analysis, perf_counter() - start))
