"""Reading a launch file, and why the launch system of ROS does not read it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.launch import Format
from plastron_tui.sources.launch.reader import LARGEST, read_launch
from plastron_tui.sources.launch.xml_reader import LaunchRead
from plastron_tui.sources.not_text import not_utf_8
from plastron_tui.targets import language_of

from .kept_diagnostics import Kept, is_template, kept, unread
from .parameter_files import is_no_yaml, text_of

_PLACEHOLDER = re.compile(
    rb"\[[A-Z][A-Z0-9_]*\]|@[A-Za-z_]\w*@|%[A-Z][A-Z0-9_]*%"
    rb"|\{\{[^{}\n]*\}\}|\{%[^\n]*?%\}|<%[^\n]*?%>"
)
"""What stands in a template for what a tool puts there."""


class LaunchFileRead(NamedTuple):
    """What was read of a launch file.

    Attributes:
        read: what it says.
        wrong: why ROS does not read it, or why it is not read here.
    """

    read: LaunchRead
    wrong: Kept = ()


def read_launch_file(name: str) -> LaunchFileRead | None:
    """Return what a launch file says, None where there is no such file."""
    text, path = text_of(name, LARGEST), Path(name)
    if text is None:
        return None
    read = read_launch(text, path)
    if read.format is Format.PYTHON:
        wrong = _wrong_python(read, text, path)
    elif read.format is Format.YAML:
        wrong = _wrong_yaml(read, text, path)
    else:
        wrong = _wrong_xml(read, text, path)
    # The tree of the text, and what else is wrong in it, is for those who look at one file.
    return LaunchFileRead(read._replace(document=None, diagnostics=()), kept(wrong))


def content_of(name: str) -> str | None:
    """Return the text of a file that a launch file wants to have, None where there is none."""
    text = text_of(name, LARGEST)
    with suppress(ValueError):
        return None if text is None else text.decode()
    return None


def _wrong_python(read: LaunchRead, text: bytes, path: Path) -> Iterator[Diagnostic]:
    other = not_utf_8(text, path)
    if is_template(path) or (read.launch is not None and other is None):
        return
    language = language_of(path)
    refused = None if language is None else language.refusal(path, text)
    if refused is not None:
        yield refused
    elif read.launch is None and other is not None:
        yield unread(other)


def _wrong_yaml(read: LaunchRead, text: bytes, path: Path) -> Iterator[Diagnostic]:
    if read.launch is not None or is_template(path):
        return
    other = not_utf_8(text, path)
    if is_no_yaml(text):
        yield from read.diagnostics if other is None else (other,)
    elif other is not None:
        yield unread(other)


def _wrong_xml(read: LaunchRead, text: bytes, path: Path) -> Iterator[Diagnostic]:
    is_refused = _is_refused(text)
    if is_template(path) and _is_filled_in(text):
        return
    for each in read.diagnostics:
        if is_refused and each.code in (codes.BROKEN_XML, codes.UNSUPPORTED_XML):
            yield each
        elif each.code is codes.UNSUPPORTED_XML:
            yield unread(each)


def _is_filled_in(text: bytes) -> bool:
    """Tell whether a file is XML once a tool has filled it in."""
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
