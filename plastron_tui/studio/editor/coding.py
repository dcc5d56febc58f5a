"""What the editor does with the program: definition, rename, format, another editor."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Mapping
from pathlib import Path
from shutil import rmtree
from tempfile import mkdtemp
from typing import ClassVar

from textual.app import SuspendNotSupported
from textual.binding import Binding, BindingType

from plastron_tui.diagnostics import Edit
from plastron_tui.language import format_document
from plastron_tui.program_file import check_text

from .base import EditorBase
from .names import Variable, variable_at, wrong_name


class CodingActions(EditorBase):
    """Actions on the program as a whole."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding(
            "f12,alt+g", "go_to_definition", "Go to definition", show=False, id="editor.definition"
        ),
        Binding("f2", "rename", "Rename everywhere", show=False, id="editor.rename"),
        Binding("ctrl+l", "format", "Format", show=False, id="editor.format"),
        Binding(
            "ctrl+e", "external_editor", "Open in $EDITOR", show=False, id="editor.external_editor"
        ),
        Binding("alt+z", "toggle_wrap", "Wrap long lines", show=False, id="editor.toggle_wrap"),
    ]

    def _variable(self) -> Variable | None:
        variable = variable_at(self.session.document, self.state.cursor)
        if variable is None:
            self._warn("no variable is under the cursor")
        return variable

    def _warn(self, text: str) -> None:
        self.app.notify(text, severity="warning", markup=False)

    def action_go_to_definition(self) -> None:
        """Go to where the variable under the cursor is created or loaded."""
        variable = self._variable()
        if variable is None:
            return
        if variable.definition is None:
            self._warn(f"nothing creates or loads `{variable.name}`")
        else:
            self.go_to(variable.definition.start)

    def action_rename(self) -> None:
        """Ask for another name of the variable under the cursor."""
        variable = self._variable()
        if variable is not None:
            name = variable.name
            self.with_bars(lambda: self.prompt_bar.ask(f"rename {name} to", name, self.rename))

    def rename(self, name: str) -> None:
        """Give the variable under the cursor another name, everywhere, as one step to undo."""
        name = name.strip()
        variable = variable_at(self.session.document, self.state.cursor)
        if variable is None or name == variable.name:
            return
        problem = wrong_name(self.session.document, name)
        if problem is not None:
            self._warn(problem)
            return
        self.apply(Edit(span, name) for span in variable.places)

    def action_format(self) -> None:
        """Lay the program out as `plastron fmt` does."""
        self.replace_all(format_document(self.session.document))

    def action_toggle_wrap(self) -> None:
        """Wrap long lines, or scroll them."""
        self.view.soft_wrap = not self.view.soft_wrap

    def action_external_editor(self) -> None:
        """Edit the text in `$VISUAL` or `$EDITOR`, and take what comes back as one step."""
        command = external_editor(os.environ)
        if command is None:
            self._warn("neither $VISUAL nor $EDITOR names an editor")
            return
        name = self.session.path.name if self.session.path is not None else "program.plastron"
        try:
            there = EditedElsewhere(self.text, name)
        except OSError as error:
            self._warn(f"no temporary file can be written: {error.strerror or error}".lower())
            return
        with there:
            try:
                with self.app.suspend():
                    problem = run_editor(command, there.file)
            except SuspendNotSupported:
                self._warn("this terminal cannot be lent to another editor")
                return
            self.app.refresh()
            self._take(there, problem)

    def _take(self, there: EditedElsewhere, problem: str | None) -> None:
        """Take what another editor has left, or say why that cannot be."""
        text = there.text
        if problem is not None:
            self._warn(problem)
        elif text is None:
            self._warn(f"`{there.file.name}` is gone; the text is as it was")
        else:
            checked = check_text(None, text)
            if checked.text is not None:
                self.replace_all(checked.text)
                return
            there.is_kept = True
            self._warn(f"{checked.diagnostics[0].message}; what you wrote is in {there.file}")


def external_editor(environ: Mapping[str, str]) -> list[str] | None:
    """Return the command of the user's editor, None where no variable names one."""
    for variable in ("VISUAL", "EDITOR"):
        try:
            command = shlex.split(environ.get(variable, ""))
        except ValueError:
            continue
        if command:
            return command
    return None


def run_editor(command: list[str], file: Path) -> str | None:
    """Open a file in an editor, and return what went wrong.

    Nothing is raised: Textual takes the terminal back only when all went well.
    """
    try:
        done = subprocess.run([*command, os.fspath(file)], check=False)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        return f"`{command[0]}` cannot be started: {reason}"
    if done.returncode:
        return f"`{command[0]}` ended with status {done.returncode}; the text is as it was"
    return None


class EditedElsewhere:
    """A text in a temporary file, for another editor; it is gone afterwards unless it is kept."""

    def __init__(self, text: bytes, name: str) -> None:
        self._folder = Path(mkdtemp(prefix="plastron-"))
        self.file = self._folder / name
        self.file.write_bytes(text)
        self.is_kept = False

    @property
    def text(self) -> bytes | None:
        """What is in the file; None when it is gone."""
        try:
            return self.file.read_bytes()
        except OSError:
            return None

    def __enter__(self) -> EditedElsewhere:
        return self

    def __exit__(self, *_: object) -> None:
        if not self.is_kept:
            rmtree(self._folder, ignore_errors=True)
