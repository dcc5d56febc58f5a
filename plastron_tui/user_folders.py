"""The folders of a user's settings, state and cache, by the XDG base directory specification."""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

NOWHERE = Path(os.devnull, "plastron")
"""A folder that cannot be: reading there finds nothing, and writing fails."""

_SHARED = Path("/tmp")


def config_folder(environ: Mapping[str, str] = os.environ) -> Path:
    """Return the folder of what the user sets."""
    return _base(environ, "XDG_CONFIG_HOME", ".config") / "plastron"


def state_folder(environ: Mapping[str, str] = os.environ) -> Path:
    """Return the folder of what is remembered from one start to the next."""
    return _base(environ, "XDG_STATE_HOME", ".local/state") / "plastron"


def cache_folder(environ: Mapping[str, str] = os.environ) -> Path:
    """Return the folder of what can be made again."""
    return _base(environ, "XDG_CACHE_HOME", ".cache") / "plastron"


def _base(environ: Mapping[str, str], variable: str, default: str) -> Path:
    set_ = environ.get(variable, "")
    if set_ and Path(set_).is_absolute():
        return Path(set_)
    with suppress(RuntimeError):
        home = Path.home()
        if home.is_absolute():
            return home / default
    return _without_home()


def _without_home() -> Path:
    """Return a folder for a user who has no home; one that others could write to is not used."""
    folder = _SHARED / f"plastron-{os.geteuid()}"
    try:
        status = os.lstat(folder)
    except OSError:
        return folder
    is_own = stat.S_ISDIR(status.st_mode) and status.st_uid == os.geteuid()
    return folder if is_own and not status.st_mode & 0o077 else NOWHERE
