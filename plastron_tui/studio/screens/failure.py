"""What is shown when Plastron itself has failed: where the text is, and a report to copy."""

from __future__ import annotations

import platform
import sys
import traceback
from contextlib import suppress
from pathlib import Path
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Button, Label

from plastron_tui import __version__
from plastron_tui.private_files import write_private

from ..panels.styles import Piece
from ..panels.text_view import TextView
from .dialog import Dialog


def report_of(error: BaseException) -> str:
    """Return what helps to mend an error: versions and the traceback, nothing of the program."""
    from importlib.metadata import version

    head = (
        f"plastron {__version__}, textual {version('textual')}, "
        f"Python {platform.python_version()}, {sys.platform}"
    )
    lines = traceback.format_exception(type(error), error, error.__traceback__)
    return head + "\n\n" + "".join(lines)


def last_words(error: BaseException, journal: Path | None, folder: Path) -> str:
    """Write the report to a file, and return what the terminal shows when the studio is gone."""
    report = report_of(error)
    file = folder / "report.txt"
    lines = ["Plastron has made a mistake, and the studio has ended.", ""]
    if journal is not None:
        lines += [f"What was not saved is kept in {journal}", "and is offered at the next start."]
    with suppress(OSError):
        write_private(file, report.encode("utf-8", "backslashreplace"))
        lines += [f"This report is in {file}, to send it:"]
    return "\n".join([*lines, "", report])


class Failure(Dialog[None]):
    """Says that something failed, and that nothing is lost."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Close"),
        Binding("c", "copy", "Copy the report"),
    ]

    def __init__(self, report: str, journal: Path) -> None:
        super().__init__()
        self.report = report
        self._journal = journal

    def compose(self) -> ComposeResult:
        """Make the text."""
        lines = tuple((Piece(line, "quiet"),) for line in self.report.split("\n"))
        with Vertical(id="dialog", classes="-tall"):
            yield Label("Plastron has made a mistake", id="dialog-title")
            yield Label(
                "The text in the editor is as it was; go on, or save it. What is not saved is "
                f"kept in\n{self._journal}",
                id="dialog-text", markup=False,
            )  # fmt: skip
            yield TextView(lines, id="dialog-view")
            with Horizontal(id="dialog-buttons"):
                yield Button("Go on", id="close", variant="primary", compact=True)
                yield Button("Copy the report", id="copy", compact=True)

    @on(Button.Pressed, "#close")
    def action_close(self) -> None:
        """Go on."""
        self.dismiss(None)

    @on(Button.Pressed, "#copy")
    def action_copy(self) -> None:
        """Copy the report, over SSH too."""
        self.app.copy_to_clipboard(self.report)
        self.notify("copied", timeout=2)
