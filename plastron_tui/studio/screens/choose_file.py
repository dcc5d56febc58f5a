"""Choosing a file: by writing its name, or by going through folders."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import ClassVar

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widgets import Input, Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.regular_files import is_same_file

from ..folder_labels import shown_folder
from .dialog import Dialog

_MOST = 2000
_MOST_RECENT = 5
_ROOM = 9
"""Rows around the list: the frame, the title, the line, the folder, the keys, gaps."""


class ChooseFile(Dialog["Path | None"]):
    """Asks for a file; the result is its path, None for none."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Cancel"),
        Binding("down", "to_list", "Files", show=False),
    ]

    def __init__(
        self,
        title: str,
        start: Path,
        *,
        name: str = "",
        must_be: bool,
        recent: Sequence[str] = (),
        present: Path | None = None,
    ) -> None:
        """Make the question.

        Args:
            title: what it is for.
            start: the folder to begin with.
            name: the name to begin with.
            must_be: whether the file must be there.
            recent: files of late, which are offered from every folder, the latest first.
            present: the file that is open already: another one is marked at first.
        """
        super().__init__()
        self._title = title
        self._folder = start
        if ".." in start.parts:
            with suppress(OSError, RuntimeError):
                self._folder = start.resolve()
        self._present = present
        self._first = name
        self._must_be = must_be
        self._recent = [path for path in map(Path, recent) if path.is_file()]

    def compose(self) -> ComposeResult:
        """Make the line and the list."""
        with Vertical(id="dialog"):
            yield Label(self._title, id="dialog-title", markup=False)
            yield Input(self._first, id="dialog-input", compact=True,
                        placeholder="a name, a path, or part of one")  # fmt: skip
            yield Label("", id="dialog-folder", markup=False)
            yield OptionList(id="dialog-list", compact=True, markup=False)
            yield Label("↓ files   Enter takes it   Esc cancels", id="dialog-keys")

    def on_resize(self, event: events.Resize) -> None:
        """Give the list the rows that there are; it takes those that it needs."""
        self.query_one(OptionList).styles.max_height = max(event.size.height - _ROOM, 1)

    def on_mount(self) -> None:
        """Show the first folder."""
        self._list()

    def _list(self) -> None:
        """List the programs of late, and those and the folders here, that the part fits."""
        folder, part = self._split()
        recent = recent_in(self._recent, folder, part, self.query_one(Input).value)
        label = self.query_one("#dialog-folder", Label)
        label.update("opened lately" if recent else visible(_shown(folder)))
        options = [_recent_option(path) for path in recent]
        if recent:
            # The heading of the first rows is above the list.
            options.append(Option(Content.styled(visible(_shown(folder)), "$text-muted"),
                                  disabled=True))  # fmt: skip
        options.append(Option("../", id=".."))
        names = _names(folder)
        options += [
            Option(visible(name), id=name) for name in names if part.lower() in name.lower()
        ]
        options_list = self.query_one(OptionList)
        options_list.clear_options()
        options_list.add_options(options)
        options_list.highlighted = 0 if recent else self._first_marked(folder, options)

    def _first_marked(self, folder: Path, options: Sequence[Option]) -> int:
        """Return which row is marked at first: the first below `../` that is not open already."""
        for row, option in enumerate(options[1:], 1):
            if not is_same_file(folder / (option.id or ""), self._present):
                return row
        return min(1, len(options) - 1)

    def _split(self) -> tuple[Path, str]:
        written = self.query_one(Input).value.strip()
        if written.startswith("~"):
            with suppress(RuntimeError):
                end = "/" if written.endswith("/") else ""
                written = os.fspath(Path(written).expanduser()) + end
        if "/" not in written:
            return self._folder, written
        folder, _, part = written.rpartition("/")
        return self._folder / (folder or "/"), part

    @on(Input.Changed)
    def changed(self) -> None:
        """List what fits."""
        if self.is_mounted:
            self._list()

    @on(Input.Submitted)
    def submitted(self) -> None:
        """Take what is written; where a file has to be there, what is lit fits as well."""
        folder, part = self._split()
        path = folder / part if part else folder
        is_any = self._must_be and not self.query_one(Input).value.strip()
        if path.is_dir() and not is_any:
            self._enter(path)
        elif path.is_file() or (part and not self._must_be):
            self.dismiss(path)
        else:
            options_list = self.query_one(OptionList)
            fitting = [
                option.id
                for option in options_list.options
                if option.id is not None and option.id != ".."
            ]
            if fitting:
                lit = options_list.get_option_at_index(options_list.highlighted or 0).id
                self._take(lit if lit in fitting else fitting[0])
            else:
                said = f"there is no file {part}" if part else "there is no program here"
                self.notify(said, severity="warning", markup=False)

    @on(OptionList.OptionSelected)
    def selected(self, event: OptionList.OptionSelected) -> None:
        """Take a file, or go into a folder."""
        self._take(event.option.id or "")

    def _take(self, name: str) -> None:
        folder, _ = self._split()
        path = folder.parent if name == ".." else folder / name
        if path.is_dir():
            self._enter(path)
        elif self._must_be:
            self.dismiss(path)
        else:
            self.query_one(Input).value = os.fspath(path)
            self.query_one(Input).focus()

    def _enter(self, folder: Path) -> None:
        with suppress(OSError):
            self._folder = folder.resolve()
        self.query_one(Input).value = "" if self._must_be else self._first
        self._list()

    def action_to_list(self) -> None:
        """Go from the line to the list."""
        if self.query_one(Input).has_focus:
            self.query_one(OptionList).focus()

    def action_cancel(self) -> None:
        """Take nothing."""
        self.dismiss(None)


def recent_in(recent: Sequence[Path], folder: Path, part: str, written: str) -> list[Path]:
    """Return the files of late that are offered: those that fit, and are listed nowhere else.

    Args:
        recent: the files, the latest first.
        folder: the folder whose files are listed.
        part: the part of a name that is written.
        written: all that is written; who writes a path wants none of late.
    """
    if "/" in written:
        return []
    own = folder.absolute()
    fitting = (path for path in recent if part.lower() in path.name.lower() and path.parent != own)
    return list(fitting)[:_MOST_RECENT]


def _recent_option(path: Path) -> Option:
    text = Content.assemble(
        visible(path.name), "  ", (shown_folder(path.parent, 40), "$foreground 60%")
    )
    return Option(text, id=os.fspath(path))


def _names(folder: Path) -> list[str]:
    folders, files = [], []
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith("."):
                continue
            with suppress(OSError):
                if entry.is_dir():
                    folders.append(f"{entry.name}/")
                elif entry.name.endswith(".plastron"):
                    files.append(entry.name)
    return [*sorted(files, key=str.lower), *sorted(folders, key=str.lower)][:_MOST]


def _shown(folder: Path) -> str:
    with suppress(OSError, RuntimeError, ValueError):
        return f"in ~/{folder.resolve().relative_to(Path.home())}"
    return f"in {folder}"
