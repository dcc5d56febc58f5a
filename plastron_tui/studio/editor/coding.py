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
from plastron_tui.program_file import LARGEST_PROGRAM, check_text
from plastron_tui.regular_files import read_regular, reason

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
            self._warn(f"no temporary file can be written: {reason(error)}")
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
        try:
            text = there.read()
        except FileNotFoundError:
            self._warn(problem or f"`{there.file.name}` is gone; the text is as it was")
            return
        except OSError as error:
            self._keep(there, problem or f"`{there.file.name}` cannot be read: {reason(error)}")
            return
        checked = check_text(None, text)
        if problem is not None and text == self.text:
            self._warn(problem)
        elif problem is not None or checked.text is None:
            self._keep(there, problem or checked.diagnostics[0].message)
        else:
            self.replace_all(checked.text)

    def _keep(self, there: EditedElsewhere, problem: str) -> None:
        """Leave what was written where it is, and say so."""
        there.is_kept = True
        self._warn(f"{problem}; what you wrote is in {there.file}")


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
        return f"`{command[0]}` cannot be started: {reason(error)}"
    if done.returncode:
        return f"`{command[0]}` ended with status {done.returncode}; the text is as it was"
    return None


class EditedElsewhere:
    """A text in a temporary file, for another editor; it is gone afterwards unless it is kept.

    After an error it stays: nobody has read what is in it.
    """

    def __init__(self, text: bytes, name: str) -> None:
        self._folder = Path(mkdtemp(prefix="plastron-"))
        self.file = self._folder / name
        self.file.write_bytes(text)
        self.is_kept = False

    def read(self) -> bytes:
        """Return what is in the file.

        Raises:
            FileNotFoundError: it is gone.
            OSError: it cannot be read, is no regular file, or is larger than a program may be.
        """
        return read_regular(self.file, LARGEST_PROGRAM)

    def __enter__(self) -> EditedElsewhere:
        return self

    def __exit__(self, error: type[BaseException] | None, *_: object) -> None:
        if error is None and not self.is_kept:
            rmtree(self._folder, ignore_errors=True)
