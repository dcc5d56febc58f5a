"""What the editor does with the program: definition, rename, format, another editor."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import ClassVar

from textual.app import SuspendNotSupported
from textual.binding import Binding, BindingType

from plastron_tui.diagnostics import Edit
from plastron_tui.language import format_document
from plastron_tui.session import check_text

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
            self.prompt_bar.ask(f"rename {variable.name} to", variable.name, self.rename)

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
        try:
            with self.app.suspend():
                text = edit_elsewhere(command, self.text, self.session.path)
        except SuspendNotSupported:
            self._warn("this terminal cannot be lent to another editor")
            return
        except OSError as error:
            self._warn(f"`{command[0]}` cannot be started: {error.strerror or error}")
            return
        self.app.refresh()
        checked = check_text(None, text)
        if checked.text is None:
            self._warn(checked.diagnostics[0].message)
        else:
            self.replace_all(checked.text)


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


def edit_elsewhere(command: list[str], text: bytes, path: Path | None) -> bytes:
    """Hand a text to an editor in a temporary file, and return what it leaves there.

    Raises:
        OSError: the editor cannot be started, or the file is gone.
    """
    name = path.name if path is not None else "program.plastron"
    with TemporaryDirectory(prefix="plastron-") as folder:
        file = Path(folder, name)
        file.write_bytes(text)
        done = subprocess.run([*command, str(file)], check=False)
        return file.read_bytes() if done.returncode == 0 else text
