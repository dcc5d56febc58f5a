"""How long the lines of a file may be, by the settings of the linters and formatters around it."""

from __future__ import annotations

import os
import re
from itertools import takewhile
from pathlib import Path

from plastron_tui.regular_files import read_regular

ROS_2 = 99
"""What ament_flake8 allows: https://docs.ros.org, "Code style and language versions"."""

ROS_1 = 79
"""What PEP 8 allows; http://wiki.ros.org/PyStyleGuide goes by it, and few files do."""

_LARGEST = 64 * 1024
_FILES = (".flake8", "setup.cfg", "tox.ini", "pyproject.toml", "ruff.toml", ".ruff.toml")
_TABLES = frozenset({"flake8", "pycodestyle", "pep8", "tool.ruff", "tool.flake8", "tool.black"})
_HEAD = re.compile(r"\s*\[([\w.-]+)\]\s*(?:#.*)?$")
_ENTRY = re.compile(r"\s*(?:max[-_])?line[-_]length\s*[=:]\s*(\d{2,3})\b")

# What is above the package and the repository of a file says nothing about it.
_ROOTS = (".git", "package.xml")
_MOST_FOLDERS = 12


def find_line_length(file: Path) -> int | None:
    """Return what the settings around a file allow, None where none of them says it.

    They are read as text and never run; what cannot be read says nothing.
    """
    for folder in _folders(file):
        for name in _FILES:
            try:
                text = read_regular(folder / name, _LARGEST).decode("utf-8", "replace")
            except (OSError, ValueError):
                continue
            if (found := said_line_length(text, name)) is not None:
                return found
    return None


def said_line_length(text: str, name: str) -> int | None:
    """Return the length that the text of a settings file says; ruff's goes before black's."""
    table, found = "tool.ruff" if name.endswith("ruff.toml") else "", dict[str, int]()
    for line in text.splitlines():
        if (head := _HEAD.match(line)) is not None:
            table = head[1]
        elif table in _TABLES and (entry := _ENTRY.match(line)) is not None:
            found.setdefault(table, int(entry[1]))
    black = found.pop("tool.black", None)
    return next(iter(found.values()), black)


def _folders(file: Path) -> list[Path]:
    """Return the folders from a file's up to its repository, or else to its package."""
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 (never raises)
    folders = [*takewhile(lambda each: each != home, file.absolute().parents)][:_MOST_FOLDERS]
    roots = [
        number
        for number, folder in enumerate(folders)
        if any(os.path.lexists(folder / root) for root in _ROOTS)
    ]
    return folders[: roots[-1] + 1 if roots else 1]
