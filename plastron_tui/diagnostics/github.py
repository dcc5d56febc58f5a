"""Diagnostics as annotations of GitHub's workflows, which are shown beside the lines of a change.

Source: GitHub's documentation, "Workflow commands for GitHub Actions": `%`, line ends, and in
properties `:` and `,`, are written as `%25`, `%0A`, `%3A`, `%2C`.
"""

from __future__ import annotations

from pathlib import Path

from .data import Diagnostic
from .render import Lines
from .severity import Severity
from .terminal import visible, visible_character

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}


def as_annotation(found: Diagnostic, lines: Lines, root: Path) -> str:
    """Return the line that annotates a file of the repository in a folder."""
    properties = {"title": f"plastron lint ({found.code})"}
    if found.file is not None:
        file = found.file
        properties["file"] = str(file.relative_to(root) if file.is_relative_to(root) else file)
        index = lines(file)
        if found.span is not None and index is not None:
            start, end = index.position(found.span.start), index.position(found.span.end)
            properties |= {"line": str(start.line), "endLine": str(end.line)}
            if start.line == end.line:
                properties |= {"col": str(start.column), "endColumn": str(end.column)}
    said = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
    text = found.message if found.help is None else f"{found.message}; {found.help}"
    return f"::{_COMMANDS[found.severity]} {said}::{_data(visible(text))}"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    r"""Return a property; what GitHub has no sign for is escaped as in text: `\x1b`, `\udcff`."""
    text = _data(text).replace(":", "%3A").replace(",", "%2C")
    return "".join(map(visible_character, text))
