"""Filling in a user's template in a process of its own, which has limits.

Jinja's sandbox knows what a template may touch, and not how long it works: limits of a process
(`limited_process`) stop one that counts for ever. What comes back from it is plain text.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from itertools import islice
from pathlib import Path

from plastron_tui.limited_process import (
    Limits,
    Reply,
    TimedOutError,
    limit_itself,
    run_limited,
    starting,
)
from plastron_tui.regular_files import stamp_of

LONGEST_WORK = 2
"""How long a template may work, in seconds of processor time; Plastron's own need some 0.01."""
LONGEST_WAIT = 60
"""How long to wait for the process, in seconds; only one that does nothing takes so long."""
MOST_MEMORY = 512 * 1024**2
"""How much memory the process may have, in bytes; some 50 MB are Python's own."""
LARGEST_NODE = 1024**2
"""The largest text that a template may write, in bytes."""

_START = starting("plastron_tui.targets.template_process")
_REFUSED, _OVER_LIMIT = 3, 4
_LONGEST_REASON = 400
_MOST_TEMPLATES = 1_000


class TemplateFailedError(Exception):
    """A template that came to no text; `name` is the template's, where it is known."""

    def __init__(self, reason: str, name: str = "", line: int | None = None) -> None:
        super().__init__(reason)
        self.name = name
        self.lineno = line


class OverLimitError(TemplateFailedError):
    """A template that was stopped, and would be for the next node as well."""


_stopped: dict[tuple[str, Path], tuple[object, str]] = {}
"""Why templates were stopped, with the state of their folder: not once more for each node."""


Finish = Callable[[str], str]
"""A function of a module, that lays out what a template has written."""


def render_apart(
    folders: tuple[str, ...], folder: Path, name: str, values: Mapping[str, object], finish: Finish
) -> str:
    """Fill in the user's template of a client library, and lay out what it writes.

    Args:
        folders: the client library, and the folders of Plastron's own templates besides.
        folder: the user's template folder, with a folder for each client library.
        name: the template.
        values: what it is given, by the names that it has for it.
        finish: lays out the text.

    Raises:
        TemplateFailedError: the template has a mistake, or does not keep to a limit.
    """
    state = _state(folder)
    known = _stopped.get((folders[0], folder))
    if known is not None and known[0] == state:
        raise OverLimitError(known[1])
    try:
        return _rendered(pickle.dumps((folders, folder, name, values, finish)))
    except OverLimitError as error:
        _stopped[folders[0], folder] = state, str(error)
        raise


def _state(folder: Path) -> object:
    """Return what changes when somebody edits a template, in whichever folder below this one."""
    places = (Path(at, name) for at, _, names in os.walk(folder) for name in names)
    return {place: stamp_of(place) for place in islice(places, _MOST_TEMPLATES)}


def _limits() -> Limits:
    return Limits(LONGEST_WORK, LONGEST_WAIT, MOST_MEMORY, LARGEST_NODE)


def _rendered(request: bytes) -> str:
    limits = _limits()
    try:
        reply = run_limited(_START, request, limits)
    except TimedOutError:
        raise OverLimitError(f"it did not end within {limits.wait} s") from None
    except OSError as error:
        raise TemplateFailedError(f"no process can be started for it: {error}") from error
    if reply.status == 0 and len(reply.text) <= LARGEST_NODE:
        with suppress(UnicodeDecodeError):
            return reply.text.decode()
    raise _failure(reply, limits)


def _failure(reply: Reply, limits: Limits) -> TemplateFailedError:
    """Return what became of a process that wrote no node."""
    said = reply.text[: 4 * _LONGEST_REASON].decode(errors="replace")
    if reply.status in (_REFUSED, _OVER_LIMIT) and said.count("\n") >= 2:
        name, line, reason = said.split("\n", 2)
        kind = OverLimitError if reply.status == _OVER_LIMIT else TemplateFailedError
        return kind(reason, name, int(line) if line.isdecimal() else None)
    is_over_limit = reply.status == -getattr(signal, "SIGXCPU", 0)
    return (OverLimitError if is_over_limit else TemplateFailedError)(reply.why(limits))


def main() -> int:
    """Answer the one request that the standard input holds; return the exit status."""
    from .templates import render_template

    folders, folder, name, values, finish = pickle.load(sys.stdin.buffer)
    limit_itself(_limits())
    try:
        text = finish(render_template(folders, folder, name, values)).encode()
        if len(text) > LARGEST_NODE:
            raise TemplateFailedError(f"it writes more than {LARGEST_NODE // 1024**2} MB")
        reply, status = text, 0
    except MemoryError:
        reason = f"it needs more than {MOST_MEMORY // 1024**2} MB of memory"
        reply, status = _refusal(TemplateFailedError(reason)), _OVER_LIMIT
    # What a template of a user's does wrong may be anything: a division by zero, say.
    except Exception as error:
        reply, status = _refusal(error), _REFUSED
    sys.stdout.buffer.write(reply)
    sys.stdout.buffer.flush()
    return status


def _refusal(error: Exception) -> bytes:
    from jinja2 import TemplateError

    # A module or an attribute that is missing has a name as well.
    name = str(getattr(error, "name", None) or "") if isinstance(error, TemplateError) else ""
    line = getattr(error, "lineno", None) or ""
    reason = str(error)[:_LONGEST_REASON] or type(error).__name__
    return f"{name.splitlines()[0] if name else ''}\n{line}\n{reason}".encode(errors="replace")
