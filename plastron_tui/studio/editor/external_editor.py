"""Another editor, which the user prefers, on a text of this one."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Mapping
from pathlib import Path
from shutil import rmtree
from tempfile import mkdtemp

from plastron_tui.project.program_file import LARGEST_PROGRAM
from plastron_tui.regular_files import read_regular, reason


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
