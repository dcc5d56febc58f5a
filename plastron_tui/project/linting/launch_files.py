"""Reading a launch file, and why the launch system of ROS does not read it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.parsers import expat

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.sources.launch.reader import read_launch
from plastron_tui.sources.launch.xml_reader import LaunchRead


class LaunchFileRead(NamedTuple):
    """What was read of a launch file.

    Attributes:
        read: what it says.
        wrong: why it is no XML: diagnostics, their codes as plain texts.
    """

    read: LaunchRead
    wrong: tuple[tuple[Any, ...], ...] = ()

    def diagnostics(self) -> Iterator[Diagnostic]:
        """Yield why it is no XML."""
        for code, *parts in self.wrong:
            yield Diagnostic(codes.CODES[code], *parts)


def read_launch_file(text: bytes, path: Path) -> LaunchFileRead:
    """Return what a launch file says."""
    read = read_launch(text, path)
    wrong = [each for each in read.diagnostics if each.code is codes.BROKEN_XML]
    told = tuple((str(each.code), *each[1:]) for each in wrong) if _is_refused(text) else ()
    # The tree of the text, and what else is wrong in it, is for those who look at one file.
    return LaunchFileRead(read._replace(document=None, diagnostics=()), told)


def _is_refused(text: bytes) -> bool:
    """Tell whether the parser that both generations of ROS use refuses a text."""
    try:
        expat.ParserCreate().Parse(text, True)
    except expat.ExpatError:
        return True
    return False
