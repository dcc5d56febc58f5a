"""What is configured, and what the studio remembers from one start to the next."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import NamedTuple

from plastron_tui.private_files import read_private, write_private
from plastron_tui.regular_files import reason
from plastron_tui.user_folders import config_folder

_MOST_RECENT = 12
_LARGEST = 1024**2
"""The largest file of what is remembered, in bytes."""


def config_file(environ: Mapping[str, str] = os.environ) -> Path:
    """Return where the configuration file is."""
    return config_folder(environ) / "studio.yaml"


@dataclass(frozen=True, slots=True)
class Config:
    """What the configuration file says.

    Attributes:
        theme: the name of a theme, None for the one that was used last.
        keys: keys by the id of an action, in Textual's notation; "" where another one got them.
        mouse: whether the mouse is used.
        wrap: whether long lines are wrapped.
        numbers: whether lines have numbers.
    """

    theme: str | None = None
    keys: dict[str, str] = field(default_factory=dict)
    mouse: bool = True
    wrap: bool = True
    numbers: bool = True


def template(file: Path, actions: Iterable[tuple[str, str]]) -> str | None:
    """Write a configuration that says nothing yet, if there is none; return why that failed."""
    lines = [
        "# The settings of the studio; what starts with # is off.",
        "# theme: nord",
        "# mouse: true",
        "# wrap: false   # long lines go on below; Alt-Z does the same for now",
        "# numbers: true",
        "# keys:",
        *(f"#   {action}: {keys or 'f11'}" for action, keys in actions),
    ]
    try:
        if not os.path.lexists(file):
            write_private(file, ("\n".join(lines) + "\n").encode())
    except OSError as error:
        return f"{file} cannot be written: {reason(error)}"
    return None


@dataclass(slots=True)
class Remembered:
    """What the studio remembers.

    Attributes:
        theme: the theme that was chosen last.
        recent: the files that were open, the latest first.
        sizes: how large each dock is, in cells.
        hidden: the docks that are hidden.
        tabs: the tab that each dock showed.
        toured: whether the tour was taken.
        actions: the ids of the actions that were chosen in the menu, the latest first.
        told: the texts that were not saved, as far as that was said.
    """

    theme: str | None = None
    recent: list[str] = field(default_factory=list)
    sizes: dict[str, int] = field(default_factory=dict)
    hidden: list[str] = field(default_factory=list)
    tabs: dict[str, str] = field(default_factory=dict)
    toured: bool = False
    actions: list[str] = field(default_factory=list)
    told: list[str] = field(default_factory=list)

    def did(self, action: str) -> None:
        """Put an action in front of those of late."""
        others = [other for other in self.actions if other != action]
        self.actions = [action, *others][:_MOST_RECENT]

    def opened(self, path: Path) -> None:
        """Put a file in front of the recent ones."""
        name = os.fspath(path.absolute())
        others = [other for other in self.recent if other != name]
        self.recent = [name, *others][:_MOST_RECENT]


class Profile(NamedTuple):
    """What belongs to the user, and lasts longer than a program.

    Attributes:
        config: what the configuration file says.
        remembered: what is remembered.
        folder: where that is kept.
    """

    config: Config
    remembered: Remembered
    folder: Path

    @property
    def journals(self) -> Path:
        """The folder of what was typed and not saved."""
        return self.folder / "journal"


_STATE_FILE = "studio.json"


def load_remembered(folder: Path) -> Remembered:
    """Read what is remembered; what cannot be read is forgotten."""
    remembered = Remembered()
    with suppress(OSError, ValueError, RecursionError):
        data = json.loads(read_private(folder / _STATE_FILE, _LARGEST))
        for key, default in asdict(remembered).items():
            value = data.get(key) if isinstance(data, dict) else None
            if isinstance(value, str if default is None else type(default)):
                setattr(remembered, key, value)
    remembered.recent = [name for name in remembered.recent if isinstance(name, str)]
    remembered.actions = [name for name in remembered.actions if isinstance(name, str)]
    remembered.told = [name for name in remembered.told if isinstance(name, str)]
    sizes, tabs = remembered.sizes, remembered.tabs
    remembered.sizes = {key: size for key, size in sizes.items() if isinstance(size, int)}
    remembered.tabs = {key: tab for key, tab in tabs.items() if isinstance(tab, str)}
    return remembered


def save_remembered(folder: Path, remembered: Remembered) -> None:
    """Write what is remembered; a disk that takes nothing is no reason to stop."""
    file = folder / _STATE_FILE
    with suppress(OSError):
        write_private(file, json.dumps(asdict(remembered), indent=1).encode())
