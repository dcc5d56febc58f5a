"""The configuration file, and what the studio remembers from one start to the next."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from plastron_tui.diagnostics import did_you_mean
from plastron_tui.private_files import read_private, write_private
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.user_folders import config_folder

from .config_text import NotSettingsError, Setting, read_settings
from .key_conflicts import KeyOwner, Said, Wish, bind

_MOST_RECENT = 12
_LARGEST = 1024**2
"""The largest file of what is remembered, in bytes."""
_LARGEST_CONFIG = 64 * 1024
"""The largest file of settings, in bytes: YAML takes its time."""


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


_SWITCHES = ("mouse", "wrap", "numbers")
_KEYS = ("theme", "keys", *_SWITCHES)


def load_config(
    file: Path, owners: Callable[[], Sequence[KeyOwner]], themes: Iterable[str]
) -> tuple[Config, tuple[str, ...]]:
    """Read the configuration; what is wrong with it is a message, and the default counts.

    Args:
        file: where it is.
        owners: returns what has keys, or can be given some; asked only where there is a file.
        themes: the names of the themes.
    """
    try:
        text = read_regular(file, _LARGEST_CONFIG)
    except (FileNotFoundError, NotADirectoryError):
        return Config(), ()
    except OSError as error:
        return Config(), (f"{file.name} cannot be read: {reason(error)}",)
    config, said = read_config(text, owners(), themes)
    return config, tuple(
        f"{file.name}{f', line {each.line}' if each.line else ''}: {each.words}" for each in said
    )


def read_config(
    text: bytes, owners: Sequence[KeyOwner], themes: Iterable[str]
) -> tuple[Config, Sequence[Said]]:
    """Read a text of the configuration, and say line by line what is wrong with it.

    A line 0 is the whole text.
    """
    try:
        settings = read_settings(text)
    except NotSettingsError as error:
        return Config(), [Said(error.line or 0, str(error))]
    config, problems = Config(), _repeated(settings)
    for setting in settings:
        config = _with(config, setting, owners, frozenset(themes), problems)
    return config, sorted(problems, key=lambda said: said.line)


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


def _with(
    config: Config,
    setting: Setting,
    owners: Sequence[KeyOwner],
    themes: frozenset[str],
    problems: list[Said],
) -> Config:
    """Return the configuration with one setting more."""
    name, line = setting.name, setting.line
    if name == "theme" and setting.word:
        if setting.word in themes:
            return replace(config, theme=setting.word)
        problems.append(Said(line, f"no theme `{setting.word}`{_hint(setting.word, themes)}"))
    elif name == "keys" and setting.settings is not None:
        bound = bind(_wishes(setting.settings, owners, problems), owners)
        problems += bound.problems
        return replace(config, keys=bound.keys)
    elif name in _SWITCHES and setting.switch is not None:
        changes: dict[str, Any] = {name: setting.switch}
        return replace(config, **changes)
    elif name in _KEYS:
        problems.append(Said(line, f"`{name}` has a value that it cannot have"))
    elif any(owner.id == name for owner in owners):
        problems.append(Said(line, f"`{name}` is an action: its key stands indented below `keys:`"))
    else:
        problems.append(Said(line, f"no setting `{name}`{_hint(name, _KEYS)}"))
    return config


def _wishes(
    settings: Sequence[Setting], owners: Sequence[KeyOwner], problems: list[Said]
) -> list[Wish]:
    """Return which keys are wanted for actions that there are."""
    problems += _repeated(settings)
    actions = {owner.id for owner in owners if owner.id}
    wishes: dict[str, Wish] = {}
    for setting in settings:
        name, words = setting.name, setting.words
        if name not in actions:
            problems.append(Said(setting.line, f"no action `{name}`{_hint(name, actions)}"))
        elif words is None:
            problems.append(Said(setting.line, f"the key of `{name}` is no key"))
        else:
            wishes[name] = Wish(name, words, setting.line)
    return list(wishes.values())


def _repeated(settings: Sequence[Setting]) -> list[Said]:
    """Say which settings are there twice; the last one counts."""
    last = {setting.name: setting.line for setting in settings}
    return [
        Said(each.line, f"`{each.name}` comes again in line {last[each.name]}, which counts")
        for each in settings
        if last[each.name] != each.line
    ]


def _hint(word: str, known: Iterable[str]) -> str:
    hint = did_you_mean(word, known)
    return f"; {hint}" if hint else ""


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
    """

    theme: str | None = None
    recent: list[str] = field(default_factory=list)
    sizes: dict[str, int] = field(default_factory=dict)
    hidden: list[str] = field(default_factory=list)
    tabs: dict[str, str] = field(default_factory=dict)
    toured: bool = False
    actions: list[str] = field(default_factory=list)

    def did(self, action: str) -> None:
        """Put an action in front of those of late."""
        others = [other for other in self.actions if other != action]
        self.actions = [action, *others][:_MOST_RECENT]

    def opened(self, path: Path) -> None:
        """Put a file in front of the recent ones."""
        name = os.fspath(path.absolute())
        others = [other for other in self.recent if other != name]
        self.recent = [name, *others][:_MOST_RECENT]


@dataclass(frozen=True, slots=True)
class Profile:
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
    sizes, tabs = remembered.sizes, remembered.tabs
    remembered.sizes = {key: size for key, size in sizes.items() if isinstance(size, int)}
    remembered.tabs = {key: tab for key, tab in tabs.items() if isinstance(tab, str)}
    return remembered


def save_remembered(folder: Path, remembered: Remembered) -> None:
    """Write what is remembered; a disk that takes nothing is no reason to stop."""
    file = folder / _STATE_FILE
    with suppress(OSError):
        write_private(file, json.dumps(asdict(remembered), indent=1).encode())
