"""Reading the configuration file."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from plastron_tui.diagnostics import did_you_mean
from plastron_tui.regular_files import read_regular, reason

from .config import Config
from .config_text import NotSettingsError, Setting, read_settings
from .key_conflicts import KeyOwner, Said, Wish, bind

_LARGEST_CONFIG = 64 * 1024
"""The largest file of settings, in bytes: YAML takes its time."""
_SWITCHES = ("mouse", "wrap", "numbers")
_KEYS = ("theme", "keys", *_SWITCHES)


def load_config(
    file: Path, owners: Sequence[KeyOwner], themes: Iterable[str]
) -> tuple[Config, tuple[str, ...]]:
    """Read the configuration; what is wrong with it is a message, and the default counts.

    Args:
        file: where it is.
        owners: what has keys, or can be given some.
        themes: the names of the themes.
    """
    config, said = load_settings(file, owners, themes)
    return config, tuple(told(file, each) for each in said)


def told(file: Path, said: Said) -> str:
    """Return what is to be said of a line of the configuration, with the file and the line."""
    return f"{file.name}{f', line {said.line}' if said.line else ''}: {said.words}"


def load_settings(
    file: Path, owners: Sequence[KeyOwner], themes: Iterable[str]
) -> tuple[Config, Sequence[Said]]:
    """Read the configuration, and say line by line what is wrong with it; a line 0 is the whole."""
    try:
        text = read_regular(file, _LARGEST_CONFIG)
    except (FileNotFoundError, NotADirectoryError):
        return Config(), ()
    except OSError as error:
        return Config(), [Said(0, f"it cannot be read: {reason(error)}")]
    return read_config(text, owners, themes)


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
