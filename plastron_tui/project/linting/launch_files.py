"""Reading a launch file, and why the launch system of ROS does not read it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.parsers import expat

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.sources.launch.reader import read_launch
from plastron_tui.sources.launch.xml_reader import LaunchRead

_PLACEHOLDER = re.compile(
    rb"\[[A-Z][A-Z0-9_]*\]|@[A-Za-z_]\w*@|%[A-Z][A-Z0-9_]*%"
    rb"|\{\{[^{}\n]*\}\}|\{%[^\n]*?%\}|<%[^\n]*?%>"
)
"""What stands in a template for what a tool puts there."""


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
    is_told = _is_refused(text) and not _is_template(text, path)
    told = tuple((str(each.code), *each[1:]) for each in wrong) if is_told else ()
    # The tree of the text, and what else is wrong in it, is for those who look at one file.
    return LaunchFileRead(read._replace(document=None, diagnostics=()), told)


def _is_template(text: bytes, path: Path) -> bool:
    """Tell whether a file is XML once a tool has filled it in: it lies among templates, too."""
    folders = (each.lower() for each in path.parts[:-1])
    if not any(each.endswith(("template", "templates")) for each in folders):
        return False
    return any(
        filled != text and not _is_refused(filled)
        for filled in (_PLACEHOLDER.sub(each, text) for each in (b"", b"x", b'""'))
    )


def _is_refused(text: bytes) -> bool:
    """Tell whether the parser that both generations of ROS use refuses a text."""
    try:
        expat.ParserCreate().Parse(text, True)
    except expat.ExpatError:
        return True
    return False
