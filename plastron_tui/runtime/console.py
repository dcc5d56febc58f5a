"""What a run prints: the nodes' lines, labelled, and what happened to the nodes."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import signal
from collections.abc import Callable, Iterable, Mapping
from typing import TextIO

from plastron_tui.diagnostics.terminal import is_only_colour, visible, visible_line, wants_colour

from .child import Exit, Process, Role
from .labels import OWN_NAME, SIGN
from .table import Screen

# Cyan, yellow, magenta, green, blue, then their bright kin: red is kept for what went wrong.
_COLOURS = (36, 33, 35, 32, 34, 96, 93, 95, 92, 94)
_RED = 31
_DIM = 2
_NO_CAUSE = re.compile(r"\[(?:DEBUG|INFO)\]", re.IGNORECASE)
_FROM_OUTSIDE = frozenset({-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP})
"""The statuses of what somebody else has ended: nothing that it printed says why."""


class Console:
    """Writes lines under the name of the node that they come from.

    Nodes' lines go to `out`, what the run itself has to say to `err`. When nobody reads any
    more (a closed terminal, a pipe to `head`), `on_gone` is called once and the rest is dropped.

    Attributes:
        failure: why nothing can be written any more; None also where a reader has left.
    """

    def __init__(
        self,
        names: Iterable[str],
        out: TextIO,
        err: TextIO,
        *,
        on_gone: Callable[[], None] | None = None,
        environ: Mapping[str, str] = os.environ,
    ) -> None:
        listed = list(dict.fromkeys(names))
        self._width = max((len(name) for name in [*listed, OWN_NAME]), default=0)
        self._colour_of = {
            name: _COLOURS[index % len(_COLOURS)] for index, name in enumerate(listed)
        }
        self._out = out
        self._err = err
        self._on_gone = on_gone
        self._is_gone = False
        self.failure: OSError | None = None
        self._screen: Screen | None = None
        self._out_colour = wants_colour(out, environ)
        self._err_colour = wants_colour(err, environ)

    def line(self, process: Process, text: str) -> None:
        """Write a line of a node."""
        self.labelled(process.name, text)

    def labelled(self, name: str, text: str) -> None:
        """Write a line under a name.

        roscpp ends the text of a message with a line break, and rosconsole puts the end of its
        colour behind that: there is nothing to see in such a line.
        """
        if is_only_colour(text):
            return
        code = self._colour_of.get(name, _DIM)
        shown = visible_line(text, in_colour=self._out_colour)
        self._write(self._out, self._label(name, code, self._out_colour) + shown)

    def notice(self, text: str, *, is_bad: bool = False) -> None:
        """Write a line of the run itself."""
        label = self._label(OWN_NAME, _RED if is_bad else _DIM, self._err_colour)
        self._write(self._err, label + visible_line(text, in_colour=False))

    def show(self, screen: Screen | None) -> None:
        """Keep a table below the lines from now on, or leave the one there where it is."""
        if self._screen is not None and screen is None:
            self._put(self._out, self._screen.frame(is_forced=True))
        self._screen = screen

    def refresh(self) -> None:
        """Draw the table anew where that is due."""
        if self._screen is not None:
            self._put(self._out, self._screen.frame())

    def ended(self, end: Exit) -> None:
        """Report how a process ended, a failure with the end of its output.

        A node's lines were all shown, so that the last one is enough, which of a traceback is
        the error; of a helper's none was.
        """
        if end.was_asked:
            return
        lines = [line for line in end.last_lines if line.strip()] if end.is_failure else []
        told = f"{end.process.name} {end.words}"
        if not lines:
            self.notice(told, is_bad=end.is_failure)
        elif end.process.role is Role.NODE:
            cause = "" if _is_no_cause(end, lines[-1]) else f": {lines[-1].strip()}"
            self.notice(told + cause, is_bad=True)
        else:
            self.notice(f"{told}; its last lines were:", is_bad=True)
            for line in lines:
                self.notice(f"  {line}", is_bad=True)

    def _label(self, name: str, code: int, in_colour: bool) -> str:
        label = f"{visible(name):<{self._width}}{SIGN}"
        return f"\x1b[{code}m{label[:-1]}\x1b[0m " if in_colour else label

    def _write(self, stream: TextIO, line: str) -> None:
        if self._screen is not None:
            self._put(self._out, self._screen.erase())
        self._put(stream, line + "\n")

    def _put(self, stream: TextIO, text: str) -> None:
        if self._is_gone or not text:
            return
        try:
            stream.write(text)
            stream.flush()
        except (OSError, ValueError) as error:
            self._is_gone = True
            if isinstance(error, OSError) and error.errno != errno.EPIPE:
                self.failure = error
            _silence(stream)
            if self._on_gone is not None:
                self._on_gone()


def _is_no_cause(end: Exit, line: str) -> bool:
    """Tell whether the last line of a node says nothing of why it ended."""
    return end.status in _FROM_OUTSIDE or _NO_CAUSE.search(line[:80]) is not None


def _silence(stream: TextIO) -> None:
    # What is still in its buffer would fail again, with a traceback, when Python ends.
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
