"""Filling in a user's template in a process of its own, which has limits.

Nothing inside of a process stops a template that counts for ever or asks for all of the memory:
Jinja's sandbox knows what a template may touch, and not how long it works. So the process that
does the work limits itself, and what comes back from it is plain text, which nothing executes.
"""

from __future__ import annotations

import math
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path

from plastron_tui.regular_files import stamp_of

LONGEST_WORK = 2
"""How long a template may work, in seconds of processor time; Plastron's own need some 0.01."""
LONGEST_WAIT = 60
"""How long to wait for the process, in seconds; only one that does nothing takes so long."""
MOST_MEMORY = 512 * 1024**2
"""How much memory the process may have, in bytes; some 50 MB are Python's own."""
LARGEST_NODE = 1024**2
"""The largest text that a template may write, in bytes."""

# Isolated from the environment and the current folder, but for what this process imports from.
_START = (
    "import sys; sys.path[:] = sys.argv[1:]; "
    "from plastron_tui.targets.template_process import main; sys.exit(main())"
)
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


def _rendered(request: bytes) -> str:
    places = [place for place in sys.path if os.path.isabs(place)]  # noqa: PTH117
    try:
        with tempfile.TemporaryFile() as reply:
            status = subprocess.run(
                [sys.executable, "-I", "-c", _START, *places],
                input=request,
                stdout=reply,
                stderr=subprocess.DEVNULL,
                timeout=LONGEST_WAIT,
            ).returncode
            reply.seek(0)
            # Never more than may be: it is a stranger's word how much there is.
            text = reply.read(LARGEST_NODE + 1)
    except subprocess.TimeoutExpired:
        raise OverLimitError(f"it did not end within {LONGEST_WAIT} s") from None
    except OSError as error:
        raise TemplateFailedError(f"no process can be started for it: {error}") from error
    if status == 0 and len(text) <= LARGEST_NODE:
        with suppress(UnicodeDecodeError):
            return text.decode()
    raise _failure(status, text[: 4 * _LONGEST_REASON].decode(errors="replace"))


def _failure(status: int, reply: str) -> TemplateFailedError:
    """Return what became of a process that wrote no node."""
    if status in (_REFUSED, _OVER_LIMIT) and reply.count("\n") >= 2:
        name, line, reason = reply.split("\n", 2)
        kind = OverLimitError if status == _OVER_LIMIT else TemplateFailedError
        return kind(reason, name, int(line) if line.isdecimal() else None)
    if status == -getattr(signal, "SIGXCPU", 0):
        return OverLimitError(f"it works for more than {LONGEST_WORK} s")
    ended = f"signal {-status}" if status < 0 else f"status {status}"
    return TemplateFailedError(f"its process ended with {ended}")


def main() -> int:
    """Answer the one request that the standard input holds; return the exit status."""
    from .templates import render_template

    folders, folder, name, values, finish = pickle.load(sys.stdin.buffer)
    _limit_itself()
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


def _limit_itself() -> None:
    """Limit what this process may use; a limit that is tighter already stays."""
    try:
        import resource
    except ImportError:  # Windows has no such limits: there the parent's patience is one
        return
    limits: Sequence[tuple[int, int]] = (
        (resource.RLIMIT_AS, MOST_MEMORY),
        (resource.RLIMIT_CPU, math.ceil(time.process_time()) + LONGEST_WORK),
        (resource.RLIMIT_FSIZE, 2 * LARGEST_NODE),
        (resource.RLIMIT_CORE, 0),
    )
    for kind, most in limits:
        soft, hard = resource.getrlimit(kind)
        bounds = [each for each in (soft, hard) if each != resource.RLIM_INFINITY]
        # Some systems know a limit, and refuse to set it.
        with suppress(OSError, ValueError):
            resource.setrlimit(kind, (min([most, *bounds]), hard))
