"""Searches in a thread: an expression may take longer than a key has time.

The matching itself holds no other thread up (`concurrent` of the package regex), and gives up
after a while.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TypeAlias

from .search import Found, Search

PROMPT = 0.008
"""Seconds within which what is found belongs to the key that asked; most is found long before."""

Post: TypeAlias = "Callable[[Callable[[], None]], object]"


class _Job:
    """A search of a text, what it found, and whether somebody has to be told."""

    def __init__(self, search: Search, text: bytes, done: Callable[[Found], None]) -> None:
        self.search = search
        self.text = text
        self.done = done
        self.finished = threading.Event()
        self.found: Found | None = None
        self.is_late = False


class SearchThread:
    """Runs the newest search; one that is begun gives way to it."""

    def __init__(self, post: Post) -> None:
        """Run nothing yet; `post` calls a function in the thread of the screen."""
        self._post = post
        self._lock = threading.Lock()
        self._next: _Job | None = None
        self._newest: _Job | None = None
        self._is_running = False

    def run(self, search: Search, text: bytes, done: Callable[[Found], None]) -> None:
        """Search a text; `done` is called at once with what is found soon, else later.

        It is called in this thread, and not at all where another search came meanwhile.
        """
        job = _Job(search, text, done)
        with self._lock:
            self._next = self._newest = job
            is_running, self._is_running = self._is_running, True
        if not is_running:
            threading.Thread(target=self._work, name="search", daemon=True).start()
        job.finished.wait(PROMPT)
        with self._lock:
            found = job.found
            job.is_late = found is None
        if found is not None:
            done(found)

    def _work(self) -> None:
        while True:
            with self._lock:
                job, self._next = self._next, None
                if job is None:
                    self._is_running = False
                    return
            found = self._found(job)
            with self._lock:
                job.found = found
                is_late = job.is_late
            job.finished.set()
            if is_late:
                self._post(lambda job=job, found=found: self._tell(job, found))  # type: ignore[misc]

    def _found(self, job: _Job) -> Found:
        """Search, and say what went wrong: an error would end the thread, and all searches."""
        try:
            return job.search.find(job.text, lambda: self._next is not None)
        except Exception as error:
            return Found(problem=f"that cannot be searched for: {error}")

    def _tell(self, job: _Job, found: Found) -> None:
        if job is self._newest:
            job.done(found)
