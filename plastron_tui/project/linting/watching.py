"""Looking at a workspace again whenever one of its files changes."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress

from plastron_tui.boundary import PROJECT_FILE
from plastron_tui.sources.packages.facts.texts import NO_TEXT

from .listing import list_files
from .run import LintOptions, LintRun

_SHORTEST = 0.5
"""Seconds between two looks at the folders, at least."""

_SHARE = 20
"""A look takes at most one in so many parts of the time: one at a large workspace is long."""

_GROWING = (*NO_TEXT, ".log", ".out")
"""How the names of files end that grow all the time, and say nothing by what is in them."""

Stamps = Mapping[str, tuple[int, ...]]


def watched(options: LintOptions, sleep: Callable[[float], None] = time.sleep) -> Iterator[LintRun]:
    """Yield a run now, and a new one each time that a file was changed, made, renamed or removed.

    An editor that writes another file and renames it changes the file too. Of files that have not
    changed, a new run has what the last one read.

    Args:
        options: what is looked at.
        sleep: waits for so many seconds.
    """
    seen: Stamps | None = None
    while True:
        began = time.monotonic()
        now = _stamps(options)
        if now != seen:
            seen = now
            yield LintRun(options)
            began = time.monotonic()
        sleep(max(_SHORTEST, (time.monotonic() - began) * _SHARE))


def _stamps(options: LintOptions) -> Stamps:
    """Return what tells each file from what it was before: time, size, inode, who may run it.

    What is told itself may go into a file of the workspace, and is no reason to look again.
    """
    own = set(_own_outputs())
    paths = LintRun(options).paths
    listing = list_files(paths)
    above = listing.root
    projects = [os.path.join(place, PROJECT_FILE) for place in (above, *above.parents)]
    baselines = () if options.baseline is None else (os.fspath(options.baseline),)
    found: dict[str, tuple[int, ...]] = {}
    for path in (*listing.files, *projects, *baselines):
        try:
            status = os.stat(path)
        except OSError:
            continue
        if path.lower().endswith(_GROWING) or (status.st_dev, status.st_ino) in own:
            found[path] = (status.st_mode,)
            continue
        found[path] = (status.st_mtime_ns, status.st_size, status.st_ino, status.st_mode)
    return found


def _own_outputs() -> Iterator[tuple[int, int]]:
    """Yield what the system calls the files that this process itself prints to."""
    for number in (1, 2):
        with suppress(OSError):
            status = os.fstat(number)
            yield status.st_dev, status.st_ino
